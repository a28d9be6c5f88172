"""Seeded Monte Carlo: means with confidence intervals, as many runs as the wanted width asks for.

A number that a simulation gives is never a proof. It is an interval, at a level, from seeds that
are kept, so that anybody finds the same one again; a closed form that lies outside it is refuted at
that level, and one that lies inside is supported.

References
----------
C. Stein, *A two-sample test for a linear hypothesis whose power is independent of the variance*
(1945): how many runs give an interval of a wanted width.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sensortrack.arguments import numbers, real
from sensortrack.errors import InputError
from sensortrack.random_numbers import whole

Floats = NDArray[np.float64]
LEVEL = 0.999
"""Of an interval, unless another is asked for."""
PILOT = 64
"""Runs of the first stage: enough that Student's quantile is within 7 % of the normal one."""
MOST = 1 << 22
"""Runs at most: a width that asks for more is refused rather than waited for."""
Draw = Callable[[int, int], ArrayLike]
"""``draw(first, count)``: one number a run, of the runs first, first + 1, ...; each run has its own
random numbers, so that a run is the same whoever asks for it."""


@dataclass(frozen=True)
class Interval:
    """Where a mean is, at a level.

    Parameters
    ----------
    mean : float
        Of the runs.
    half : float
        Half the width.
    runs : int
        Independent runs, or batches.
    level : float
        Probability with which such an interval holds the mean, for nearly normal numbers.
    seed : int
        Of the runs 0 to `runs` - 1; -1 where they were not drawn here.
    """

    mean: float
    half: float
    runs: int
    level: float
    seed: int = -1

    @property
    def low(self) -> float:
        """Lower end."""
        return self.mean - self.half

    @property
    def high(self) -> float:
        """Upper end."""
        return self.mean + self.half

    @property
    def relative_width(self) -> float:
        """Width over the size of the mean; infinite for a mean of zero."""
        return 2 * self.half / abs(self.mean) if self.mean else math.inf

    def holds(self, value: float) -> bool:
        """Whether a value lies inside, ends included."""
        return self.low <= value <= self.high


def mean_interval(values: ArrayLike, level: float = LEVEL, seed: int = -1) -> Interval:
    """Student's interval of the mean of independent runs.

    Parameters
    ----------
    values : array (runs,)
        One number a run, all finite.
    level : float, optional
        Above 0, below 1.
    seed : int, optional
        To be kept with it.

    Raises
    ------
    InputError
        Fewer than two runs, a number that is not finite, or a level out of range.
    """
    found = _checked(values)
    runs = len(found)
    half = _quantile(level, runs - 1) * float(found.std(ddof=1)) / math.sqrt(runs)
    return Interval(float(found.mean()), half, runs, level, seed)


def batch_interval(series: ArrayLike, batches: int = 32, level: float = LEVEL) -> Interval:
    """Interval of the mean of one long stationary run, from the means of its batches.

    Parameters
    ----------
    series : array (samples,)
        Cut into batches of equal length; what is left over at the start is dropped.
    batches : int, optional
        At least two; each must be long beside the memory of the series.
    level : float, optional
        Above 0, below 1.

    Raises
    ------
    InputError
        Fewer samples than batches, fewer than two batches, or as `mean_interval`.
    """
    found = numbers("series", series)
    length = len(found) // whole("batches", batches, 2)
    if length == 0:
        needed = "at least one sample a batch is needed"
        raise InputError("batches", f"{batches} for {len(found)} samples", needed)
    kept = found[len(found) - batches * length :]
    return mean_interval(kept.reshape(batches, length).mean(axis=1), level)


def runs_for(pilot: ArrayLike, width: float, level: float = LEVEL) -> int:
    """How many runs give a relative width, judged by a first stage.

    Stein's rule, n = (2 t s/(width |mean|))^2 with the quantile t and the deviation s of the pilot,
    rounded up and not below the pilot's own number.

    Parameters
    ----------
    pilot : array (runs,)
    width : float
        Of the whole interval over the size of the mean, above 0.
    level : float, optional

    Raises
    ------
    InputError
        A width of 0 or less, a pilot of mean zero that varies, more than `MOST` runs, or as
        `mean_interval`.
    """
    if not real("width", width) > 0:
        raise InputError("width", f"{width}", "a relative width above 0 is needed")
    first = mean_interval(pilot, level)
    if first.half == 0:
        return first.runs
    count = first.runs * (first.relative_width / width) ** 2
    if not count <= MOST:
        raise InputError("width", f"{width} asks for {count:.3g} runs", f"at most {MOST} are made")
    return max(first.runs, math.ceil(count))


def monte_carlo(
    draw: Draw, width: float, seed: int, level: float = LEVEL, pilot: int = PILOT
) -> Interval:
    """Interval of a mean in two stages: a pilot says how many runs the wanted width needs.

    The interval has the pilot's deviation and quantile and the mean of all runs, as Stein's proof
    wants it: the level is then right although the runs were counted by looking at them. The
    width is the wanted one of the pilot's mean, and near it of the final one.

    Parameters
    ----------
    draw : callable
        ``draw(first, count)``; it has drawn with `seed` already, which is recorded here.
    width : float
        Of the whole interval over the size of the mean.
    seed : int
    level : float, optional
    pilot : int, optional
        Runs of the first stage.

    Raises
    ------
    InputError
        As `runs_for`, or the draw has another number of runs than it was asked for.
    """
    pilot = whole("pilot", pilot, 2)
    first = _drawn(draw, 0, pilot)
    count = runs_for(first, width, level)
    rest = _drawn(draw, pilot, count - pilot) if count > pilot else first[:0]
    found = _checked(np.concatenate([first, rest]))
    stage = mean_interval(first, level)
    half = stage.half * math.sqrt(stage.runs / count)
    return Interval(float(found.mean()), half, count, level, seed)


def _drawn(draw: Draw, first: int, count: int) -> Floats:
    found = numbers("draw", draw(first, count))
    if found.shape != (count,):
        raise InputError("draw", f"shape {found.shape}", f"one number each of {count} runs")
    return found


def _quantile(level: float, degrees: int) -> float:
    """Of Student's law, two-sided."""
    from scipy.special import stdtrit

    if not 0 < real("level", level) < 1:
        raise InputError("level", f"{level}", "a number above 0 and below 1 is needed")
    return float(stdtrit(degrees, (1 + level) / 2))


def _checked(values: ArrayLike) -> Floats:
    found = numbers("runs", values)
    if found.ndim != 1 or len(found) < 2:
        raise InputError("runs", f"shape {found.shape}", "one number each of two or more runs")
    if not np.isfinite(found).all():
        count = int((~np.isfinite(found)).sum())
        needed = "finite numbers are needed: a run that diverges has no mean"
        raise InputError("runs", f"{count} of {len(found)} not finite", needed)
    return found
