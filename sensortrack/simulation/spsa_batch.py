"""Statistics of cyclic SPSA over many runs of one block: what closed forms are compared with.

Each run is Algorithm 1 on a quadratic cost with Hessian H: two points, two costs, an update, with
measured positions that are the true ones plus noise, which move by the same drift from sample to
sample. Nothing of the theory goes in: no second moments, no linear recursion.

Draws are a function of seed, run and update, so that a run is the same in whichever batch it is.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sensortrack.arguments import positive
from sensortrack.errors import InputError
from sensortrack.kernels.spsa import Recursion, Tally, advance
from sensortrack.random_numbers import whole

from .block_numbers import covariance_root, drift_of, hessian_of, start_of

Floats = NDArray[np.float64]
READINGS = {"one": 1, "two": 2}
LAWS = ("gaussian", "two_point")
MOST = 2**40
"""Of the numbers of a run and of a block; their products fit a word of a counter."""
HELD = 2**28
"""Numbers of one array, 2 GiB: more runs are made in parts, by `first_run`."""


@dataclass(frozen=True, eq=False)
class BatchResult:
    """What some runs counted.

    Parameters
    ----------
    means : array (runs, D)
        Of each run, the mean over the counted updates of theta_hat - theta right after them, in m.
    squares : array (runs,)
        The same of the square of its length, in m^2.
    trajectory : array (updates, 2)
        Of each update, counted or not, sums over the runs of that square and of its square.
    errors : array (runs, D)
        theta_hat - theta before the next update, at its second instant: where to go on from.
    """

    means: Floats
    squares: Floats
    trajectory: Floats
    errors: Floats

    @property
    def runs(self) -> int:
        """How many there are."""
        return len(self.squares)

    @property
    def mean(self) -> Floats:
        """Mean error right after an update, in m."""
        found: Floats = self.means.mean(axis=0)
        return found

    @property
    def mean_error(self) -> Floats:
        """Standard error of `mean`: runs are independent, updates of a run are not."""
        return _standard_error(self.means)

    @property
    def mean_square(self) -> float:
        """Mean square error right after an update, in m^2."""
        return float(self.squares.mean())

    @property
    def mean_square_error(self) -> float:
        """Standard error of `mean_square`; NaN for one run.

        It means little near the limit of stability, where squares have no variance.
        """
        return float(_standard_error(self.squares))

    @property
    def curve(self) -> tuple[Floats, Floats]:
        """Mean square after each update and its standard error, in m^2."""
        mean = self.trajectory[:, 0] / self.runs
        with np.errstate(over="ignore", invalid="ignore"):
            spread = np.maximum(self.trajectory[:, 1] / self.runs - mean * mean, 0.0)
        return mean, np.sqrt(spread / max(self.runs - 1, 1))


@dataclass(frozen=True, eq=False)
class SpsaBatch:
    """One block of cyclic SPSA, in many runs.

    The two costs are rounded before they are compared, as in any program that follows the paper: an
    error of 10^12 beta says that a run diverges, but no longer how fast.

    Parameters
    ----------
    hessian : array (D,) or (D, D)
        Diagonal h, or H symmetric positive definite.
    alpha, beta : float
        Step size, and size of the perturbation in m, above 0.
    noise : float or array (D, D), optional
        Xi, the covariance of a measured position in m^2; a number is that multiple of the identity.
    drift : float or array (D,), optional
        eta, in m a sample.
    reading : str, optional
        ``two`` instants of measurement in a step, or ``one``.
    blocks : int, optional
        k: the block is updated every 2k samples.
    law : str, optional
        ``gaussian`` noise, or ``two_point``: the symmetric root of Xi times signs.

    Raises
    ------
    InputError
        By the names of `sensortrack bound`: H or h is not symmetric positive definite, Xi not
        symmetric positive semidefinite, a number out of its range, or a size does not fit.
    """

    hessian: ArrayLike
    alpha: float
    beta: float
    noise: ArrayLike = 0.0
    drift: ArrayLike = 0.0
    reading: str = "two"
    blocks: int = 1
    law: str = "gaussian"
    recursion: Recursion = field(init=False, repr=False)

    def __post_init__(self) -> None:
        alpha, beta = (positive(name, getattr(self, name)) for name in ("alpha", "beta"))
        for name, known in (("reading", (*READINGS,)), ("law", LAWS)):
            if getattr(self, name) not in known:
                needed = f"one of {', '.join(known)} is needed"
                raise InputError(name, repr(getattr(self, name)), needed)
        blocks = whole("k", self.blocks, 1, MOST)
        hessian = hessian_of(self.hessian)
        size = len(hessian)
        found = Recursion(
            hessian,
            covariance_root(self.noise, size),
            drift_of(self.drift, size),
            alpha,
            beta,
            READINGS[self.reading],
            blocks,
            self.law == "gaussian",
        )
        object.__setattr__(self, "recursion", found)

    def run(
        self,
        runs: int,
        updates: int,
        skip: int = 0,
        seed: int = 0,
        first_run: int = 0,
        start: ArrayLike = 0.0,
    ) -> BatchResult:
        """Run and count.

        Parameters
        ----------
        runs, updates : int
            Of each, 1 or more; at most 2^28 updates, and 2^28 coordinates of all runs.
        skip : int, optional
            Updates that are not counted, so that the start is forgotten.
        seed : int, optional
        first_run : int, optional
            Number of the first run among those of this seed.
        start : float or array (D,) or (runs, D), optional
            theta_hat - theta at the second instant of the first step, before its update, in m.

        Returns
        -------
        BatchResult

        Raises
        ------
        InputError
            A number is out of its range, or the start does not fit.
        """
        size = self.recursion.size
        runs, updates = whole("runs", runs, 1, HELD // size), whole("updates", updates, 1, HELD)
        first_run, skip = whole("first_run", first_run, 0, MOST), whole("skip", skip, 0, MOST)
        if skip >= updates:
            found = f"{skip} of {updates}"
            raise InputError("skip", found, "one update at least is needed that counts")
        tally = Tally(
            start_of(start, runs, size),
            np.zeros((runs, size)),
            np.zeros(runs),
            np.zeros((updates, 2)),
        )
        advance(self.recursion, tally, whole("seed", seed), first_run, skip)
        counted = updates - skip
        means, squares = tally.sums / counted, tally.squares / counted
        return BatchResult(means, squares, tally.trajectory, tally.errors)


def _standard_error(values: Floats) -> Floats:
    if len(values) < 2:
        return np.full(values.shape[1:], np.nan)
    with np.errstate(over="ignore", invalid="ignore"):
        found: Floats = values.std(axis=0, ddof=1) / math.sqrt(len(values))
    return found
