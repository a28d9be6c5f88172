"""The limit of the step on a user's own sensors and targets: over all sensors and their blocks."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError
from verification.answers import Answer, Detail
from verification.certificates.make import CertificateError, Item, certificate
from verification.exact.rationals import above, below, nearest, text

from .inputs import ASSIGNMENTS, NETWORK, SPEEDS, Network, network_of
from .plans import Plan, block_of_plan, plans_of, with_assignment

LIMITED = (*NETWORK, SPEEDS)
LARGEST = 400
"""Blocks, and pairs of a sensor and a target, that a certificate holds."""

SHOWN = 12
"""Sensors that are described to a reader."""

TOO_LARGE = "no certificate: more than {} blocks or pairs of a sensor and a target"
FIRST_ORDER = "covariances are those of the first order, (14) with its axes put right"
NOT_ALL = "of {} sensors not all choices were looked at: there may be better ones"
LONGEST = 48
"""Characters of a list that are shown to a reader."""


def network_step_limit(values: Mapping[str, Any]) -> Answer:
    """Supremum of the steps at which every block of every sensor is mean-square stable.

    Parameters
    ----------
    values : mapping
        The inputs of `inputs.NETWORK`, and ``eta_m``.

    Returns
    -------
    Answer
        Exact, a rational, with a certificate about all sensors.

    Raises
    ------
    InputError
        As `inputs.network_of` and `plans.plans_of`.

    References
    ----------
    V. Erofeeva, O. Granichin, (10) to (20) and Algorithm 1.
    """
    network = network_of(values)
    plans = plans_of(network)
    worst = min(plans, key=lambda plan: plan.limit)
    document, missing = _proved(network, plans)
    notes = [FIRST_ORDER, *missing, *searched(plans)]
    return Answer(
        value=nearest(worst.limit),
        exact={"kind": "rational", "value": text(worst.limit)},
        lower=below(worst.limit),
        upper=above(worst.limit),
        printed=nearest(printed_limit(plans, len(network.targets))),
        verdict="PROVED",
        certificate=document,
        notes=tuple(notes),
        more={
            "critical": lambda: critical_block(network, worst),
            "sensors": lambda: table(plans),
            "other": lambda: comparison(network, worst.limit),
            "other_reading": lambda: other_reading(network),
        },
    )


def searched(plans: Sequence[Plan]) -> list[str]:
    """A note where a search for the best choices was stopped."""
    count = sum(not plan.proved for plan in plans)
    return [NOT_ALL.format(count)] if count else []


def printed_limit(plans: Sequence[Plan], targets: int) -> Fraction:
    """The smallest mu/gamma of a sensor, with the constants that Theorem 2 prints.

    Parameters
    ----------
    plans : sequence of Plan
    targets : int
        Of the network: d is twice that.
    """
    d = 2 * targets
    limits = []
    for plan in plans:
        mu, top = min(plan.hessian.values()) / 2, max(plan.hessian.values()) / 2
        limits.append(mu / (3 * d**2 * top**2))
    return min(limits)


def _proved(
    network: Network, plans: Sequence[Plan]
) -> tuple[dict[str, Any] | None, tuple[str, ...]]:
    """The certificate about all blocks, or None and why there is none."""
    pairs = [(plan, i) for plan in plans for i in plan.hessian]
    blocks = [(plan, block) for plan in plans for block in plan.blocks.blocks]
    if max(len(pairs), len(blocks)) > LARGEST:
        return None, (TOO_LARGE.format(LARGEST),)
    inside = [[int(own is plan and i in block) for plan, i in pairs] for own, block in blocks]
    spreads = [network.variances[plan.sources.sources[i]][i] for plan, i in pairs]
    drifts = [network.drifts[i] for _, i in pairs]
    data = {
        "G": inside,
        "h": [[plan.hessian[i]] for plan, i in pairs],
        "s": [[x] for x in spreads],
        "e": [[x**2 + y**2] for x, y in drifts],
        "beta": network.beta,
        "reading": network.instants,
    }
    loads = [sum((plan.weights[i] for i in block), Fraction(0)) for plan, block in blocks]
    upper = 2 / max(loads)
    try:
        witness = _witness(drifts, loads, upper)
        made = certificate("cyclic_spsa", "network_step_limit", data, witness, upper=upper)
    except CertificateError as error:
        return None, (f"no certificate: {error}",)
    return made, ()


def _witness(
    drifts: Sequence[tuple[Fraction, ...]], loads: Sequence[Fraction], upper: Fraction
) -> list[Item]:
    slack = [2 - upper * x for x in loads]
    critical = slack.index(Fraction(0))
    loose = [k for k, x in enumerate(slack) if x]
    columns = [[int(k == at) for at in loose] for k in range(len(loads))] if loose else None
    return [
        _column([1] * len(drifts)),
        _column(loads),
        _column([1] * len(loads)),
        {"kind": "matrix", "rows": columns or [[0] for _ in loads]},
        _column([slack[k] for k in loose] or [1]),
        _column([int(k == critical) for k in range(len(loads))]),
        *map(_column, zip(*drifts, strict=True)),
    ]


def _column(entries: Sequence[Fraction | int]) -> Item:
    return {"kind": "matrix", "rows": [[x] for x in entries]}


# ------------------------------------------------------------------------------- what explains it


def critical_block(network: Network, plan: Plan) -> Detail:
    """The block that limits the step, and how to ask about it alone."""
    place = plan.blocks.critical
    block = block_of_plan(network, plan, place)
    data = {
        "h": [text(block.hessian[i][i]) for i in range(block.size)],
        "Xi": [[text(x) for x in row] for row in block.noise],
        "eta": [text(x) for x in block.drift],
        "beta": text(block.beta),
        "reading": "two" if block.instants == 2 else "one",
        "k": str(block.blocks),
    }
    names = ", ".join(map(str, plan.blocks.blocks[place]))
    where = f"sensor {plan.own}, block {place + 1} of {block.blocks}: targets {names}"
    alone = "sensortrack bound cyclic_spsa.step_limit --params FILE, critical.params of --json"
    data = {"sensor": plan.own, "block": place, "params": data}
    return Detail(data, (("critical", where), ("alone", alone)))


def table(plans: Sequence[Plan], errors: Mapping[int, Mapping[int, float]] | None = None) -> Detail:
    """Sources, blocks, weights and limits of every sensor, and errors where they are known."""
    data, lines = [], []
    for plan in plans:
        entry: dict[str, Any] = {
            "sensor": plan.own,
            "neighbours": list(plan.sources.neighbours),
            **plan.schedule(),
            "h": {str(i): text(x) for i, x in plan.hessian.items()},
            "limit": text(plan.limit),
        }
        heard = _cut(", ".join(map(str, plan.sources.neighbours))) or "none"
        blocks = _cut(blocks_text(plan))
        line = f"hears {heard}; blocks {blocks}; limit {nearest(plan.limit):.6g}"
        if errors is not None:
            known = errors[plan.own]
            entry["rms"] = {str(i): x for i, x in known.items()}
            line += "; rms " + _cut(", ".join(f"{i}: {x:.4g}" for i, x in sorted(known.items())))
        data.append(entry)
        lines.append((f"sensor {plan.own}", line))
    rest = len(lines) - SHOWN
    more = [("", f"and {rest} further sensors")] if rest > 0 else []
    return Detail(data, (*lines[:SHOWN], *more))


def blocks_text(plan: Plan) -> str:
    """The blocks of a sensor for a reader."""
    return " | ".join(" ".join(map(str, block)) for block in plan.blocks.blocks)


def _cut(line: str) -> str:
    return line if len(line) <= LONGEST else line[:LONGEST] + "…"


def comparison(network: Network, limit: Fraction) -> Detail | None:
    """What the other choice of neighbours and blocks gives; None for a large network."""
    if len(network.sensors) * len(network.targets) > LARGEST:
        return None
    other = next(word for word in ASSIGNMENTS if word != network.assignment)
    try:
        found = min(plan.limit for plan in plans_of(with_assignment(network, other)))
    except InputError as error:  # it leaves a sensor without targets
        return Detail({"assignment": other, "limit": None}, ((f"if {other}", error.found),))
    line = f"limit {nearest(found):.10g}, {nearest(found / limit):.4g} times this one"
    return Detail({"assignment": other, "limit": text(found)}, ((f"if {other}", line),))


def other_reading(network: Network) -> Detail | None:
    """The limit with the other number of measurement instants; None for a large network."""
    if len(network.sensors) * len(network.targets) > LARGEST:
        return None
    other = replace(network, instants=3 - network.instants)
    found = min(plan.limit for plan in plans_of(other))
    word = "one" if network.instants == 2 else "two"
    label = f"limit, reading {word}"
    return Detail({"reading": word, "limit": text(found)}, ((label, f"{nearest(found):.10g}"),))
