"""Constants of Assumptions 1 to 5 for costs of which only bounds on the Hessian are known."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError
from verification.answers import Answer, Input
from verification.certificates.make import certificate
from verification.exact.evaluate import add, dot, identity, quadratic, scaled, trace
from verification.exact.semidefinite import split

from ..block_inputs import Block
from .constants import (
    MOVED,
    ONE_INSTANT,
    bracketed,
    constant_data,
    cost_of,
    drift_bounds,
    largest_ratio,
    matrix_item,
    semidefinite_items,
)
from .cost_changes import change_of, gradient_power

BOUNDS = (
    Input("low", "number", "instead of h or H: the Hessian is at least low I", optional=True),
    Input("high", "number", "the Hessian is at most high I", optional=True),
)
REST = (Fraction(1), 2, 1)
"""beta, instants and blocks, which do not enter."""

OF_ALL = (
    "for every even cost of that Hessian and symmetric noise: mu, M and c2 are reached by low "
    "|x|^2/2 and high |x|^2/2, c3 and c4 are bounds"
)


def blocks_between(values: Mapping[str, Any]) -> tuple[Block, Block, Fraction]:
    """The quadratics low |x|^2/2 and high |x|^2/2, and the kurtosis of the noise.

    Raises
    ------
    InputError
        The bounds are not 0 < low <= high, or a Hessian is given beside them.
    """
    for name in ("low", "high"):
        if values[name] is None:
            raise InputError(name, "not given", "both bounds on the Hessian, low and high")
    if values["h"] is not None or values["H"] is not None:
        raise InputError("low", "given beside a Hessian", "the Hessian or bounds on it are needed")
    low, high = values["low"], values["high"]
    if not 0 < low <= high:
        raise InputError("low", f"low = {low}, high = {high}", "0 < low <= high is needed")
    size = max(len(values["Xi"]), len(values["eta"]))
    blocks = [cost_of({**values, "h": (x,) * size, "H": None}) for x in (low, high)]
    return blocks[0][0], blocks[1][0], blocks[1][1]


def class_constants(
    low: Block, high: Block, kurtosis: Fraction
) -> tuple[tuple[Fraction, ...], tuple[Fraction, Fraction]]:
    """mu, M and c2 that are reached, and c3 and c4 that are bounds, for all costs between."""
    top = high.hessian[0][0]
    plain = change_of(Block(identity(high.size), "h", high.noise, high.drift, *REST), kurtosis)
    c3 = 2 * top**2 * largest_ratio(plain.form, identity(high.size))[1]
    spread = trace(high.noise)
    moved = dot(high.drift, high.drift)
    # E|xi|^4 from the variance of |xi|^2, and E|eta + xi|^4 from it
    fourth = spread**2 + 2 * plain.printed
    further = moved**2 + 4 * quadratic(high.drift, high.noise) + fourth + 2 * moved * spread
    c4 = top**2 * (further + 2 * (moved + spread) * spread + fourth) / 2
    return (low.hessian[0][0], top, gradient_power(high)), (c3, c4)


def of_bounds(values: Mapping[str, Any]) -> Answer:
    """[mu, M, c2, c3, c4, delta] that do for every cost with the Hessian between the bounds.

    Raises
    ------
    InputError
        As `blocks_between`, or c3 is given.
    """
    low, high, kurtosis = blocks_between(values)
    if values["c3"] is not None:
        raise InputError("c3", "given beside bounds on the Hessian", "a Hessian is needed for it")
    reached, bounds = class_constants(low, high, kurtosis)
    least_delta, delta = drift_bounds(high)
    document = proved_of_all(low, high, kurtosis, (*reached, *bounds, delta))
    ends = (*reached, *bounds)
    lows, highs = (*ends, least_delta), (*ends, delta)
    return bracketed(lows, highs, document, (OF_ALL, MOVED, ONE_INSTANT))


def proved_of_all(
    low: Block, high: Block, kurtosis: Fraction, constants: Sequence[Fraction]
) -> dict[str, Any]:
    """The certificate that constants do for every cost between."""
    data = constant_data(high, kurtosis, constants)
    data |= {"low": low.hessian[0][0], "high": high.hessian[0][0]}
    eye = identity(high.size)
    drifts = tuple(tuple(a * b for b in high.drift) for a in high.drift)
    form = scaled(2 * high.hessian[0][0] ** 2, add(scaled(2, high.noise), drifts))
    factor = semidefinite_items(split(add(scaled(data["c3"], eye), form, -1)))
    witness = [matrix_item(eye), *factor, *semidefinite_items(split(high.noise))]
    return certificate("cyclic_spsa", "assumptions_of_all", data, witness)
