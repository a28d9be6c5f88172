"""Proofs that constants are, or are not, those of Assumptions 1 to 5 for one quadratic cost."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from verification.answers import Answer
from verification.certificates.make import certificate
from verification.exact.evaluate import add, dot, identity, quadratic, scaled
from verification.exact.rationals import nearest
from verification.exact.semidefinite import split

from ..block_inputs import Block
from .constants import NAMES, constant_data, drift_bounds, matrix_item, semidefinite_items
from .cost_changes import Change, beyond, change_of, excess, gradient_power, offset


def proved(data: Mapping[str, Any], change: Change) -> dict[str, Any]:
    """The certificate that constants do for a quadratic cost.

    Raises
    ------
    InputError
        They do not.
    """
    hessian, eye = data["H"], identity(len(data["H"]))
    low = split(add(hessian, scaled(data["mu"], eye), -1))
    high = split(add(scaled(data["M"], eye), hessian, -1))
    _, z, rest = offset(change, data["c3"])
    factors = [item for parts in (low, high, rest) for item in semidefinite_items(parts)]
    witness = [matrix_item(eye), *factors, matrix_item([[x] for x in z])]
    witness += semidefinite_items(split(data["Xi"]))
    return certificate("cyclic_spsa", "assumptions", data, witness)


def refuted(
    block: Block, kurtosis: Fraction, constants: Sequence[Fraction], changing: bool = True
) -> Answer | None:
    """The answer that names the first constant that is none, if there is one.

    Parameters
    ----------
    block : Block
    kurtosis : Fraction
        Excess kurtosis of the noise's coordinates.
    constants : sequence of Fraction
        In the order of `NAMES`.
    changing : bool, optional
        Whether to look at c3 and c4.
    """
    given, change = dict(zip(NAMES, constants, strict=True)), change_of(block, kurtosis)
    found = _extreme(block, given) or _power(block, given)
    if found is None and changing:
        found = _changes(change, given)
    found = found or _moved(block, given)
    if found is None:
        return None
    name, vector, miss, text = found
    witness = [matrix_item([[x] for x in vector])] if vector else []
    witness += semidefinite_items(split(block.noise))
    data = constant_data(block, kurtosis, constants)
    return Answer(
        verdict="REFUTED",
        certificate=certificate("cyclic_spsa", "assumptions", data, witness, f"REFUTED_{name}"),
        margin=-nearest(miss),
        notes=(f"{name}: {text}",),
    )


Failure = tuple[str, tuple[Fraction, ...], Fraction, str]
"""The constant, a vector, by how much it misses there, and what is true instead."""


def _extreme(block: Block, given: Mapping[str, Fraction]) -> Failure | None:
    hessian, eye = block.hessian, identity(block.size)
    for name, sign in (("mu", 1), ("M", -1)):
        x = split(scaled(sign, add(hessian, scaled(given[name], eye), -1))).vector
        if x is not None:
            found = quadratic(x, hessian) / dot(x, x)
            text = f"x'Hx/x'x = {nearest(found):.10g} at x = {_shown(x)}"
            return name, x, abs(found - given[name]), text
    return None


def _power(block: Block, given: Mapping[str, Fraction]) -> Failure | None:
    power = gradient_power(block)
    if given["c2"] >= power:
        return None
    text = f"E|grad f(theta)|^2 = tr(H Xi H) = {nearest(power):.10g}"
    return "c2", (), power - given["c2"], text


def _changes(change: Change, given: Mapping[str, Fraction]) -> Failure | None:
    c4, z, parts = offset(change, given["c3"])
    if parts.vector is not None:
        need = quadratic(z, change.form) / dot(z, z)
        text = f"with less than {nearest(need):.10g}, no c4 is enough"
        return "c3", z, need - given["c3"], text
    if c4 is None:
        y = beyond(change, given["c4"], z)
        miss = excess(change, given["c3"], given["c4"], y)
        return "c4", y, miss, "with exactly this c3, none is enough"
    if given["c4"] < c4:
        y = tuple(-x for x in z)
        return "c4", y, c4 - given["c4"], f"with this c3, {nearest(c4):.10g} is needed"
    return None


def _moved(block: Block, given: Mapping[str, Fraction]) -> Failure | None:
    square = dot(block.drift, block.drift)
    if given["delta"] ** 2 < square:
        text = f"|eta| = {math.sqrt(nearest(square)):.10g}"
        return "delta", (), drift_bounds(block)[1] - given["delta"], text
    return None


def _shown(x: Sequence[Fraction]) -> str:
    return "[" + ", ".join(f"{nearest(entry):.6g}" for entry in x) + "]"
