"""Closed forms for the sensors of a run, as if its geometry at one moment lasted."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors.stationary import stationary_mean, stationary_mse
from .expected_squares import Setting, covariances

Floats = NDArray[np.float64]
Values = dict[str, Any]
DIGITS = 9
"""Of the numbers of a frozen block, so that exact arithmetic is not about rounding."""


def frozen_blocks(setting: Setting, law: str, sample: int) -> Iterator[tuple[int, Values]]:
    """Inputs of the closed forms for every block of every sensor, as rationals.

    Parameters
    ----------
    setting : Setting
    law : str
        Of the noise.
    sample : int
        At which the geometry is frozen, from 1 on.

    Yields
    ------
    sensor : int
    values : dict
        The inputs of `errors.stationary.stationary_mse`.
    """
    drift = setting.paths[sample] - setting.paths[sample - 1]
    for j, share in enumerate(setting.shares):
        for block in share["blocks"]:
            (noise,) = covariances(setting, [(j, block)], np.array([sample]))
            weights = np.repeat([share["weights"][i] for i in block], 2)
            yield (
                j,
                {
                    "h": tuple(map(_exact, weights)),
                    "H": None,
                    "Xi": tuple(tuple(map(_exact, row)) for row in noise[0]),
                    "eta": tuple(map(_exact, drift[block].ravel())),
                    "beta": _exact(setting.beta),
                    "reading": "two" if setting.instants == 2 else "one",
                    "k": Fraction(len(share["blocks"])),
                    "alpha": _exact(setting.alpha),
                    "law": law,
                },
            )


def frozen_error(setting: Setting, law: str, sample: int) -> float | None:
    """Root-mean-square error over sensors, targets and the samples between two updates, in m.

    Returns
    -------
    float or None
        None where the mean square of some block grows or is not told.
    """
    total = count = 0.0
    for _, values in frozen_blocks(setting, law, sample):
        square = stationary_mse(values, certified=False).value
        if not isinstance(square, float):
            return None
        mean, eta = np.array(stationary_mean(values).value), np.array(values["eta"], dtype=float)
        # right after an update and a samples later, the target has moved on by a eta
        ages = np.arange(2 * int(values["k"]))
        later = square - 2 * ages * (mean @ eta) + ages**2 * (eta @ eta)
        targets = len(eta) // 2
        total, count = total + float(later.mean()), count + targets
    return float(np.sqrt(total / count))


def _exact(value: float) -> Fraction:
    return Fraction(f"{value:.{DIGITS}g}")
