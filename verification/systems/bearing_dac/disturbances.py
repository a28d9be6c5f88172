"""How fast what bearing sensors average can change: the bound gamma of Assumption 2."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError
from theory.algebra.plane import rate_factors
from verification.answers import Answer
from verification.exact.evaluate import matrices
from verification.exact.square_roots import exact_square_root

from .network_inputs import usable_numbers

Point = tuple[Fraction, ...]

ORIGIN = "entries of q move faster the farther a sensor is from the origin, which can be chosen"


def disturbance_bound(values: Mapping[str, Any]) -> Answer:
    """The least gamma that bounds the rates of all entries of P and q, for every such target.

    Parameters
    ----------
    values : mapping
        ``v_max``: largest speed of the target, m/s, at least 0; ``rho_min``: its smallest distance
        from a sensor, m, positive; ``positions``: tuple of (x, y) of the sensors, m.

    Returns
    -------
    Answer
        v_max/rho_min times the larger of 1 and the largest distance of a sensor from the origin,
        exact and attained; the unit is that of the faster entry, 1/s or m/s.

    Raises
    ------
    InputError
        v_max is negative, rho_min is not positive, two sensors are at the same place, or a number
        is not of usable size.

    References
    ----------
    George, Assumption 2.
    """
    usable_numbers(values)
    rate, positions = angular_rate(values), values["positions"]
    _apart(positions)
    for_p, for_q = rate_factors()
    squares = {place: _factor(for_q, place) for place in positions}
    far = max(positions, key=lambda place: squares[place])
    still = _factor(for_p, far)
    exact = exact_square_root(rate**2 * max(still, squares[far]))
    assert exact is not None  # of a square that is known
    where = f"the sensor at ({far[0]}, {far[1]}) decides: entries of q"
    note = where if squares[far] > still else "entries of P decide: no sensor is farther than 1 m"
    return Answer(value=exact.nearest, exact=exact.to_data(), notes=(note, ORIGIN))


def angular_rate(values: Mapping[str, Any]) -> Fraction:
    """Largest angular speed of a line of sight, v_max/rho_min.

    Raises
    ------
    InputError
        v_max is negative, or rho_min is not positive.
    """
    v_max, rho_min = values["v_max"], values["rho_min"]
    if v_max < 0:
        raise InputError("v_max", f"{v_max}", "a speed of at least 0 is needed")
    if rho_min <= 0:
        needed = "a distance above 0 is needed: a target on a sensor has no bearing"
        raise InputError("rho_min", f"{rho_min}", needed)
    return Fraction(v_max / rho_min)


def _apart(positions: tuple[Point, ...]) -> None:
    """Each sensor is at a place of its own."""
    for k, place in enumerate(positions):
        first = positions.index(place)
        if first < k:
            found = f"points {first + 1} and {k + 1} are both ({place[0]}, {place[1]})"
            raise InputError("positions", found, "a place of its own is needed for each sensor")


def _factor(form: Any, place: Point) -> Fraction:
    """A factor of the squared angular speed, for a sensor at this place."""
    column = tuple((x,) for x in place)
    return matrices(form, {"q": column})[0][0][0]
