"""Steps and perturbations for the smallest error in the long run, with proofs of stability."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError
from verification.answers import Design, Designed, Input
from verification.enclosures import ends
from verification.exact.evaluate import identity, trace
from verification.exact.rationals import above, below

from .block_inputs import BLOCK, BLOCKS, DRIFT, HESSIAN, NOISE, Block, block_of
from .errors.best_step import at_once, best_step
from .errors.second_moments import BITS, moments_of
from .errors.settling import Settling, mean_square
from .errors.stationary import LAW, law_of
from .network.errors import errors_of
from .network.inputs import NETWORK, network_of
from .network.limits import network_step_limit
from .network.plans import plans_of
from .stability.limits import limit_of
from .stability.steps import decide_step

DIGITS = 6
FEW_DIGITS = 4
"""Of a step found by comparing errors, which are flat about the best one."""

CLOSE = 1.01
"""The error may be this many times that of a perturbation without limit."""

ROUNDS = 40
STILL = "a drift is needed: without it, every smaller step leaves a smaller error in the long run"
STEP_OBJECTIVE = "smallest root-mean-square error in the long run, among all steps"
BOTH_OBJECTIVE = (
    "smallest root-mean-square error in the long run, among all steps and both readings; beta is "
    "the smallest one within 1 % of what any beta can do"
)
NETWORK_OBJECTIVE = (
    "smallest root-mean-square error in the long run, over all sensors and targets, among all steps"
)
CERTIFIED = (
    "the error and the stability are certified; that no other choice does better is a search's"
)
ONE_BETTER = "with one instant: two would leave {:.6g} at the least"
TWO_BETTER = "with two instants: one would leave {:.6g}"
ANY_BETA = "with one instant, the error does not depend on beta"


def step_for_block(values: Mapping[str, Any]) -> Designed:
    """The step with the smallest error of a block that drifts.

    Parameters
    ----------
    values : mapping
        The inputs of `block_inputs.BLOCK`; ``law``.

    Raises
    ------
    InputError
        As `block_inputs.block_of`; nothing drifts; an unknown law.
    """
    block = block_of(values)
    _moving(block)
    found = best_step(values)
    if found.value is None:
        return Designed(objective=STEP_OBJECTIVE, notes=found.notes)
    return _certified(values, block, found.value[0], STEP_OBJECTIVE, ())


def step_and_perturbation(values: Mapping[str, Any]) -> Designed:
    """Step, perturbation and reading with the smallest error of a block that drifts.

    With two instants the noise enters the more, the smaller beta is; the cost is quadratic, so
    that a larger beta costs nothing. With one instant beta does not matter.

    Parameters
    ----------
    values : mapping
        ``h`` or ``H``, the identity if there is none; ``Xi``, ``eta``, ``k``, ``law``.

    Raises
    ------
    InputError
        As `block_inputs.block_of`; nothing drifts; an unknown law.
    """
    given = dict(values)
    if given["h"] is None and given["H"] is None:
        given["H"] = identity(max(len(given["Xi"]), len(given["eta"])))

    def at(beta: Fraction, reading: str = "two") -> dict[str, Any]:
        return {**given, "beta": beta, "reading": reading}

    block = block_of(at(Fraction(1)))
    _moving(block)
    unit = _unit(block)
    single, double = best_step(at(unit, "one")), best_step(at(unit * 10**6))
    if single.value is None or double.value is None:
        return Designed(objective=BOTH_OBJECTIVE, notes=(*single.notes, *double.notes))
    notes: tuple[str, ...]
    if single.value[1] <= double.value[1]:
        notes = (ONE_BETTER.format(double.value[1]), ANY_BETA)
        chosen, step = at(unit, "one"), single.value[0]
    else:
        notes = (TWO_BETTER.format(single.value[1]),)
        beta = _smallest_beta(lambda x: best_step(at(x)).value, unit, CLOSE * double.value[1])
        chosen, step = at(beta), best_step(at(beta)).value[0]
    return _certified(chosen, block_of(chosen), step, BOTH_OBJECTIVE, notes)


def step_for_network(values: Mapping[str, Any]) -> Designed:
    """The step with the smallest error of all sensors of a network.

    Parameters
    ----------
    values : mapping
        The inputs of `network.inputs.NETWORK`; ``law``.

    Raises
    ------
    InputError
        As `network.limits.network_step_limit`; no target moves; an unknown law.
    """
    import flint

    network, law = network_of(values), law_of(values)
    if not any(any(drift) for drift in network.drifts):
        raise InputError("velocities", "targets that do not move", STILL)
    plans = plans_of(network)
    limit = network_step_limit(values)
    top = Fraction(limit.lower)

    def error(part: float) -> float:
        with flint.ctx.workprec(BITS):
            return float(errors_of(network, plans, top * Fraction(part), law).mean().mid())

    alpha = _short(float(top) * _lowest(error), FEW_DIGITS)
    with flint.ctx.workprec(BITS):
        rms = errors_of(network, plans, alpha, law).mean().sqrt()
        error_bound = above(ends(rms)[1])
    return Designed(
        gains={**_given(values), "alpha": alpha},
        objective=NETWORK_OBJECTIVE,
        bound={"rms": error_bound, "step_limit": limit.lower},
        verdict="PROVED" if limit.certificate else "SUPPORTED",
        certificate=limit.certificate,
        notes=(*limit.notes, CERTIFIED),
    )


def _moving(block: Block) -> None:
    if not any(block.drift):
        raise InputError("eta", "0", STILL)


def _unit(block: Block) -> Fraction:
    """About the standard deviation of a measured coordinate and a sample's drift, to one bit."""
    spread = trace(block.noise) / block.size
    spread += sum((x**2 for x in block.drift), Fraction(0))
    power = math.log2(spread.numerator) - math.log2(spread.denominator)  # no double may hold it
    return Fraction(2) ** math.ceil(power / 2)


def _smallest_beta(least: Callable[[Fraction], Any], unit: Fraction, allowed: float) -> Fraction:
    """The smallest beta, to three digits, whose best step leaves at most the error allowed."""
    low, high = float(unit) / 2**20, float(unit) * 10**6
    for _ in range(ROUNDS):
        if high <= low * 1.0005:
            break
        middle = math.sqrt(low * high)
        found = least(Fraction(middle))
        low, high = (low, middle) if found is not None and found[1] <= allowed else (middle, high)
    scale = Fraction(10) ** (math.floor(math.log10(high)) - 2)
    return math.ceil(Fraction(high) / scale) * scale


def _lowest(error: Callable[[float], float]) -> float:
    """Where a function on (0, 1) that falls and then rises is least."""
    from scipy.optimize import minimize_scalar

    found = minimize_scalar(
        lambda x: math.log(error(math.exp(x))), bounds=(math.log(1e-9), math.log(1 - 1e-9)),
        method="bounded", options={"xatol": 1e-7},
    )  # fmt: skip
    return math.exp(float(found.x))


def _short(alpha: float, digits: int = DIGITS) -> Fraction:
    return Fraction(f"{alpha:.{digits}g}")


def _given(values: Mapping[str, Any]) -> dict[str, Any]:
    """The inputs that were given or matter, as parameters of the system's questions."""
    plain = {"law": LAW.default}
    return {
        name: value
        for name, value in values.items()
        if value is not None and value != plain.get(name)
    }


def _certified(
    values: Mapping[str, Any], block: Block, step: float, objective: str, notes: tuple[str, ...]
) -> Designed:
    """The step in a few digits, with the certificate that it is stable, and its error."""
    import flint

    alpha = at_once(block) or _short(step)
    decided = decide_step({**values, "alpha": alpha})
    if decided.verdict != "PROVED":
        return Designed(objective=objective, notes=(*notes, *decided.notes))
    settling = Settling(block, law_of(values))
    with flint.ctx.workprec(BITS):
        rms = flint.arb(mean_square(settling, moments_of(block, alpha, exact=False))).sqrt()
        bound = {"rms": above(ends(rms)[1])}
    limit = limit_of(block)
    if limit is not None:
        bound["step_limit"] = below(limit.lower)
    return Designed(
        gains={**_given(values), "alpha": alpha},
        objective=objective,
        bound=bound,
        verdict="PROVED",
        certificate=decided.certificate,
        notes=(*notes, CERTIFIED),
    )


ANY_HESSIAN = tuple(
    Input(entry.name, entry.kind, f"{entry.meaning}; the identity if left out", optional=True)
    for entry in HESSIAN
)
NOISE_AND_DRIFT = tuple(
    Input(entry.name, entry.kind, entry.meaning, entry.unit) for entry in (NOISE, DRIFT)
)
DESIGNS = (
    Design(
        "step for a block",
        "alpha of the smallest error in the long run",
        (*BLOCK, LAW),
        step_for_block,
    ),
    Design(
        "step, perturbation and reading",
        "alpha, beta, and one or two instants, from noise and drift",
        (*ANY_HESSIAN, *NOISE_AND_DRIFT, BLOCKS, LAW),
        step_and_perturbation,
    ),
    Design(
        "step for a network",
        "alpha of the smallest error of all sensors and targets",
        (*NETWORK, LAW),
        step_for_network,
    ),
)
