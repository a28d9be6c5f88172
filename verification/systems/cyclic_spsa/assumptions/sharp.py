"""The sharp constants of Assumptions 1 to 5 for a user's costs, and whether given ones do.

The costs are quadratic, (x - theta_t - xi_t)'H(x - theta_t - xi_t)/2, with one H or with any of a
list in each sample, or they are only known to have a Hessian between low I and high I. Assumption 5
is taken as a proof needs it, with x on both sides: E(f_t(x) - f_(t-1)(x))^2 <= c3 |x -
theta_(t-1)|^2 + c4 for every x.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sensortrack.errors import InputError
from verification.answers import Answer, Input
from verification.exact.evaluate import identity
from verification.exact.rationals import above, nearest

from ..block_inputs import DRIFT, HESSIAN, NOISE
from ..errors.stationary import LAW
from .changing_costs import COSTS, decide_costs, of_costs
from .constants import (
    MOVED,
    NAMES,
    ONE_INSTANT,
    bracketed,
    constant_data,
    cost_of,
    drift_bounds,
    largest_ratio,
)
from .cost_changes import change_of, gradient_power, offset
from .hessian_bounds import BOUNDS, blocks_between, class_constants, of_bounds, proved_of_all
from .quadratic_costs import proved, refuted

WANTED_C3 = Input("c3", "number", "the c3 for which c4 is asked", optional=True)
COST = (*HESSIAN, COSTS, *BOUNDS, NOISE, DRIFT, LAW)
GIVEN = tuple(Input(name, "number", f"the constant {name} of the assumptions") for name in NAMES)

SUPREMA = (
    "mu and M are the extreme eigenvalues of H, reached at theta + x along their vectors",
    "c2 = tr(H Xi H) is E|grad f(theta)|^2 itself",
    "below c3 = {least:.10g}, the largest eigenvalue of H(2 Xi + eta eta')H, no c4 is enough",
    "c4 is the largest E(f_t(x) - f_(t-1)(x))^2 - c3 |x - theta_(t-1)|^2 over all x",
    MOVED,
)
DOUBLED = "c3 is twice that: the smaller c3 is, the larger is c4 where the target moves"
FREE = (
    "Assumption 5 as printed has no x on its left: it holds with c3 = 0 and c4 = {:.10g}, which "
    "bounds nothing that the proof uses"
)
NOT_SHARP = "neither a bound for all these costs nor broken by high |x|^2/2: c3 and c4 are bounds"


def assumption_constants(values: Mapping[str, Any]) -> Answer:
    """[mu, M, c2, c3, c4, delta], each as small (mu: as large) as the cost allows.

    Parameters
    ----------
    values : mapping
        ``h`` or ``H``, or ``costs``, or ``low`` and ``high``; ``Xi`` (m^2), ``eta`` (m a sample),
        ``law``, and ``c3`` where c4 is asked for another c3 than the default one.

    Raises
    ------
    InputError
        The Hessian is not positive definite, Xi is no covariance, or the law is not known or does
        not fit Xi; the bounds on the Hessian are not 0 < low <= high; no c4 belongs to c3.

    References
    ----------
    V. Erofeeva, O. Granichin, Assumptions 1 to 5; Theorem 2.
    """
    if values["costs"] is not None:
        return of_costs(values)
    if values["low"] is not None or values["high"] is not None:
        return of_bounds(values)
    block, kurtosis = cost_of(values)
    change, eye = change_of(block, kurtosis), identity(block.size)
    top = largest_ratio(block.hessian, eye)
    bottom = tuple(1 / x for x in reversed(largest_ratio(eye, block.hessian)))
    least = largest_ratio(change.form, eye)
    moves, wanted = any(block.drift), values["c3"]
    c3 = least[1] * (2 if moves else 1) if wanted is None else wanted
    c4, _, _ = offset(change, c3)
    if c4 is None:
        raise InputError("c3", f"{c3}", f"{above(least[1]):.10g} or more is needed for a c4")
    sharp = least[0] if wanted is None and not moves else c3
    power, (least_delta, delta) = gradient_power(block), drift_bounds(block)
    lows = (bottom[0], top[0], power, sharp, c4, least_delta)
    highs = (bottom[1], top[1], power, c3, c4, delta)
    data = constant_data(block, kurtosis, (bottom[0], *highs[1:]))
    notes = [text.format(least=nearest(least[1])) for text in SUPREMA]
    notes += [DOUBLED] if moves and wanted is None else []
    notes += [FREE.format(nearest(change.printed)), ONE_INSTANT]
    return bracketed(lows, highs, proved(data, change), notes)


def decide_assumptions(values: Mapping[str, Any]) -> Answer:
    """Decide whether given constants are constants of Assumptions 1 to 5 for this cost.

    Parameters
    ----------
    values : mapping
        The cost as for `assumption_constants`; ``mu``, ``M``, ``c2``, ``c3``, ``c4``, ``delta``.

    Returns
    -------
    Answer
        REFUTED names the first constant that is none; the margin is by how much it misses.

    Raises
    ------
    InputError
        As `assumption_constants`, or a constant is negative, or mu is 0.
    """
    for name in NAMES:
        if values[name] < 0:
            raise InputError(name, f"{values[name]}", "a constant of 0 or more is needed")
    if values["mu"] == 0:
        raise InputError("mu", "0", "a constant above 0 is needed: Assumption 1 asks for it")
    constants = [values[name] for name in NAMES]
    if values["costs"] is not None:
        return decide_costs(values, constants)
    if values["low"] is None and values["high"] is None:
        block, kurtosis = cost_of(values)
        failed = refuted(block, kurtosis, constants)
        if failed is not None:
            return failed
        data = constant_data(block, kurtosis, constants)
        return Answer(verdict="PROVED", certificate=proved(data, change_of(block, kurtosis)))
    low, high, kurtosis = blocks_between(values)
    for block in (low, high):
        failed = refuted(block, kurtosis, constants)
        if failed is not None:
            return failed
    needed = class_constants(low, high, kurtosis)
    if any(given < need for given, need in zip(constants[3:5], needed[1], strict=True)):
        return Answer(verdict="UNDECIDED", notes=(NOT_SHARP,))
    return Answer(verdict="PROVED", certificate=proved_of_all(low, high, kurtosis, constants))
