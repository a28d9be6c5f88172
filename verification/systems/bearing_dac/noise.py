"""Noise of bearings: bias and covariance of the position in exact rationals where they are such."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import expm1
from typing import Any

from sensortrack.errors import InputError
from theory.systems.bearing_dac.noise import SPREAD
from verification.answers import Answer
from verification.exact.rationals import nearest

from .network_inputs import usable_numbers

Point = tuple[Fraction, Fraction]
Matrix = tuple[Fraction, Fraction, Fraction]
"""Symmetric: the entries 11, 12 and 22."""
FIRST_ORDER = "to first order in the noise; a single shot has a bias of second order"


def noise_bias(values: Mapping[str, Any]) -> Answer:
    """Error that averaging P and q over many samples leaves.

    Parameters
    ----------
    values : mapping
        ``positions`` of the sensors, ``target``: pairs of rationals in m; ``sigma_bearing_rad``.

    Returns
    -------
    Answer
        -a (a I + (1 - 2a) Pbar)^-1 (p - mean s), two numbers in m.

    Raises
    ------
    InputError
        The target sits on a sensor or on one line with all of them, sigma is negative, or a number
        is not of usable size.
    """
    sensors, target, sigma = _given(values)
    a = _spread(sigma)
    mean = _scaled(_sum([_outer(s, target) for s in sensors]), Fraction(1, len(sensors)))
    matrix = (a + (1 - 2 * a) * mean[0], (1 - 2 * a) * mean[1], a + (1 - 2 * a) * mean[2])
    centre = [sum((s[k] for s in sensors), Fraction(0)) / len(sensors) for k in (0, 1)]
    away = (target[0] - centre[0], target[1] - centre[1])
    inverse = _inverse(matrix)
    bias = (
        -a * (inverse[0] * away[0] + inverse[1] * away[1]),
        -a * (inverse[1] * away[0] + inverse[2] * away[1]),
    )
    return Answer(value=[nearest(x) for x in bias], notes=("towards the centre of the sensors",))


def noise_covariance(values: Mapping[str, Any]) -> Answer:
    """Covariance of a position from one bearing a sensor, to first order in the noise.

    Parameters, errors are those of `noise_bias`.

    Returns
    -------
    Answer
        Entries 11, 12, 22 of sigma^2 Pbar^-1 (sum of rho^2 h h') Pbar^-1 / n^2 in m^2.
    """
    sensors, target, sigma = _given(values)
    inverse = _inverse(_sum([_outer(s, target) for s in sensors]))
    noise = _sum([_scaled(_outer(s, target), _square(s, target)) for s in sensors])
    found = _scaled(_sandwich(inverse, noise), sigma**2)
    return Answer(value=[nearest(x) for x in found], notes=(FIRST_ORDER,))


def noise_cramer_rao(values: Mapping[str, Any]) -> Answer:
    """Smallest covariance of an unbiased position from one bearing a sensor.

    Parameters, errors are those of `noise_bias`.

    Returns
    -------
    Answer
        Entries 11, 12, 22 of sigma^2 (sum of h h'/rho^2)^-1 in m^2.
    """
    sensors, target, sigma = _given(values)
    information = _sum([_scaled(_outer(s, target), 1 / _square(s, target)) for s in sensors])
    found = _scaled(_inverse(information), sigma**2)
    return Answer(value=[nearest(x) for x in found])


def _given(values: Mapping[str, Any]) -> tuple[Sequence[Point], Point, Fraction]:
    usable_numbers(values)
    sensors, target = values["positions"], values["target"]
    sigma: Fraction = values["sigma_bearing_rad"]
    if sigma < 0:
        raise InputError("sigma_bearing_rad", f"{sigma}", "a number of 0 or more is needed")
    if any(_square(s, target) == 0 for s in sensors):
        raise InputError("target", "it sits on a sensor", "a distance above 0 is needed")
    total = _sum([_outer(s, target) for s in sensors])
    if total[0] * total[2] == total[1] ** 2:
        found = "it lies on one line with all sensors"
        raise InputError("target", found, "bearings that are not all parallel are needed")
    return sensors, target, sigma


def _spread(sigma: Fraction) -> Fraction:
    """a = E sin^2 d at the double nearest to it; its terms that are 1 are taken out exactly.

    The coefficients sum to zero, so that a = sum of c (exp(-k sigma^2/2) - 1).
    """
    size = nearest(sigma)
    parts = [nearest(c) * expm1(-k * size**2 / 2) for k, c in SPREAD.items()]
    return Fraction(sum(parts))


def _square(sensor: Point, target: Point) -> Fraction:
    """rho^2."""
    return (target[0] - sensor[0]) ** 2 + (target[1] - sensor[1]) ** 2


def _outer(sensor: Point, target: Point) -> Matrix:
    """h h': rational, since the root of rho^2 cancels."""
    x, y = target[0] - sensor[0], target[1] - sensor[1]
    square = x * x + y * y
    return y * y / square, -x * y / square, x * x / square


def _sum(matrices: Sequence[Matrix]) -> Matrix:
    a, b, c = (sum(column, Fraction(0)) for column in zip(*matrices, strict=True))
    return a, b, c


def _scaled(matrix: Matrix, factor: Fraction) -> Matrix:
    return matrix[0] * factor, matrix[1] * factor, matrix[2] * factor


def _inverse(matrix: Matrix) -> Matrix:
    a, b, c = matrix
    det = a * c - b * b
    return c / det, -b / det, a / det


def _sandwich(outer: Matrix, inner: Matrix) -> Matrix:
    """A B A of symmetric matrices."""
    (a, b, c), (p, q, r) = outer, inner
    return (
        a * a * p + 2 * a * b * q + b * b * r,
        a * b * p + (a * c + b * b) * q + b * c * r,
        b * b * p + 2 * b * c * q + c * c * r,
    )
