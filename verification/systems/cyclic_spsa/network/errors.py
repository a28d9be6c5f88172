"""Where the errors of all sensors settle at a step, target by target."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from verification.answers import Answer, Detail
from verification.enclosures import ball, enclosure, ends, single
from verification.input_words import positive

from ..block_inputs import ALPHA
from ..errors.second_moments import BITS, Moments, moments_of
from ..errors.settling import Settling
from ..errors.stationary import LAW, law_of
from .inputs import NETWORK, Network, network_of
from .limits import FIRST_ORDER, searched, table
from .plans import Plan, block_of_plan, plans_of

ERROR = (*NETWORK, ALPHA, LAW)
WHAT = "root of the mean of |theta_hat - theta|^2 over sensors and targets, right after updates"
GROWS = "at this step the second moments grow in a block of sensor {}"


@dataclass(frozen=True)
class Errors:
    """Stationary mean squares of all sensors at a step.

    Parameters
    ----------
    squares : mapping of int to mapping of int to object
        Sensor to target to a `flint.arb` in m^2; without the targets of blocks that are unstable.
    unstable : tuple of int
        Sensors with a block that is not mean-square stable.
    """

    squares: Mapping[int, Mapping[int, Any]]
    unstable: tuple[int, ...]

    def mean(self) -> Any:
        """Mean over all pairs of a sensor and a target, a `flint.arb` in m^2; none unstable."""
        found = [x for own in self.squares.values() for x in own.values()]
        return sum(found[1:], start=found[0]) / len(found)


def network_error(values: Mapping[str, Any]) -> Answer:
    """Root-mean-square error of all estimates of a network in the long run, at a step.

    Parameters
    ----------
    values : mapping
        The inputs of `inputs.NETWORK`; ``alpha``, above 0; ``law`` of the noise.

    Returns
    -------
    Answer
        In m, in certified bounds; ``"inf"`` where a block is not mean-square stable. The table of
        sensors has the error of each target.

    Raises
    ------
    InputError
        As `inputs.network_of` and `plans.plans_of`; alpha <= 0; an unknown law.
    """
    import flint

    network, alpha, law = network_of(values), positive(values, "alpha", "a step"), law_of(values)
    plans = plans_of(network)
    with flint.ctx.workprec(BITS):
        found = errors_of(network, plans, alpha, law)
        more = {"sensors": lambda: _table(plans, found)}
        notes = [WHAT, FIRST_ORDER, *searched(plans)]
        if found.unstable:
            where = GROWS.format(", ".join(map(str, found.unstable)))
            return Answer(value="inf", verdict="PROVED", notes=(where, *notes), more=more)
        return single(enclosure(*ends(found.mean().sqrt())), tuple(notes), more=more)


def errors_of(network: Network, plans: Sequence[Plan], alpha: Fraction, law: str) -> Errors:
    """Mean squares of every sensor's errors, in balls of the precision that is set."""
    squares: dict[int, dict[int, Any]] = {plan.own: {} for plan in plans}
    unstable = []
    for plan in plans:
        for place, targets in enumerate(plan.blocks.blocks):
            block = block_of_plan(network, plan, place)
            moments = moments_of(block, alpha, exact=False)
            if moments.stable:
                found = coordinate_squares(Settling(block, law), moments)
                pairs = zip(found[::2], found[1::2], strict=True)
                squares[plan.own] |= {i: x + y for i, (x, y) in zip(targets, pairs, strict=True)}
            elif plan.own not in unstable:
                unstable.append(plan.own)
    return Errors(squares, tuple(unstable))


def coordinate_squares(settling: Settling, moments: Moments) -> list[Any]:
    """Mean square of each coordinate of the error right after an update, of a diagonal Hessian."""
    step = moments.step
    drift, noise = (moments.given(part) for part in (settling.by_drift, settling.by_noise))
    spread = moments.solved(drift * (1 / step) + noise * step).matrix
    beyond = settling.beyond * step
    mean = settling.mean(moments.alpha)
    return [
        spread[i, i] + beyond * moments.unit.matrix[i, i] + ball(x) ** 2 for i, x in enumerate(mean)
    ]


def _table(plans: Sequence[Plan], found: Errors) -> Detail:
    rms = {
        own: {i: float(x.sqrt().mid()) for i, x in squares.items()}
        for own, squares in found.squares.items()
    }
    return table(plans, rms)
