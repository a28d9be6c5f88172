"""Whose measurements a sensor uses while targets move: the schedule as pieces of time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from sensortrack.errors import InputError
from verification.answers import Answer, Detail, Input
from verification.exact.rationals import above, below, nearest, text

from .assignment import pieces
from .inputs import Network, network_of
from .limits import FIRST_ORDER, LIMITED, blocks_text
from .plans import Plan, plan_of

SAMPLES = Input("samples", "number", "samples to look ahead, 1 or more")
AHEAD = (*LIMITED, SAMPLES)
LONGEST = 1000
"""Samples that are looked at."""

SHOWN = 12
"""Pieces of time that are described to a reader."""


def network_schedule(values: Mapping[str, Any]) -> Answer:
    """The limit of the step while the targets move, and who uses whose measurements when.

    Parameters
    ----------
    values : mapping
        The inputs of `limits.LIMITED`; ``samples``, during which the targets keep their drifts.

    Returns
    -------
    Answer
        The smallest limit of all samples, exact, and the sample and sensor where it is.

    Raises
    ------
    InputError
        As `limits.network_step_limit`, at any of the samples; samples is no whole number from 1 to
        1000.
    """
    samples = values["samples"]
    if samples.denominator != 1 or not 1 <= samples <= LONGEST:
        raise InputError("samples", f"{samples}", f"a whole number from 1 to {LONGEST} is needed")
    network_of(values)
    plans = [_plans_at(values, t) for t in range(int(samples))]
    limits = [(plan.limit, t, plan.own) for t, now in enumerate(plans) for plan in now]
    limit, when, who = min(limits)
    return Answer(
        value=nearest(limit),
        exact={"kind": "rational", "value": text(limit)},
        lower=below(limit),
        upper=above(limit),
        verdict="PROVED",
        notes=(f"the smallest limit is that of sensor {who} at sample {when}", FIRST_ORDER),
        more={"schedule": lambda: _schedule(plans)},
    )


def network_at(network: Network, t: int) -> Network:
    """The network after t samples, each target keeping its drift."""
    targets = tuple(
        tuple(x + t * v for x, v in zip(place, drift, strict=True))
        for place, drift in zip(network.targets, network.drifts, strict=True)
    )
    return replace(network, targets=targets)


def _plans_at(values: Mapping[str, Any], t: int) -> tuple[Plan, ...]:
    network = network_at(network_of(values), t)
    try:
        moved = network_of({**values, "targets": network.targets})
        return tuple(plan_of(moved, own) for own in range(len(network.sensors)))
    except InputError as error:
        raise InputError(error.name, f"at sample {t}: {error.found}", error.needed) from None


def _schedule(plans: Sequence[tuple[Plan, ...]]) -> Detail:
    """Of each sensor, the pieces of time with one choice of sources and blocks."""
    data, lines = [], []
    for own in range(len(plans[0])):
        found = pieces([now[own] for now in plans], Plan.schedule)
        data.append([{"from": start, **plan.schedule()} for start, plan in found])
        for start, plan in found:
            sources = ", ".join(f"{i} from {q}" for i, q in sorted(plan.sources.sources.items()))
            blocks = blocks_text(plan)
            lines.append((f"sensor {own}", f"from sample {start}: {sources}; blocks {blocks}"))
    rest = len(lines) - SHOWN
    more = [("", f"and {rest} further pieces")] if rest > 0 else []
    return Detail(data, (*lines[:SHOWN], *more))
