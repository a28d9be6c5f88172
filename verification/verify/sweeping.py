"""The sharp gain of one shipped network beside the printed one."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

from sensortrack.data import load_network, network_places
from verification.answers import Answer
from verification.systems import SYSTEMS

from .records import Finding, file_of, finite

if TYPE_CHECKING:
    from sensortrack.networks import Network

SYSTEM = "bearing_dac"
GAMMA = "1"
"""Bound on each disturbance: threshold and printed formula are compared at this value."""


def sweep(name: str) -> Finding:
    """Row of ``networks.json`` for the network of that name.

    Returns
    -------
    Finding
        Without a row, and with the reason, if no certified threshold was found.
    """
    started = time.perf_counter()
    try:
        network = load_network(name)
        sharp = _ask("gain_threshold", network, gamma=True)
        if sharp.value is None or sharp.certificate is None:
            reason = "; ".join(sharp.notes) or "no certified value"
            return Finding({}, skipped=f"network {name}: {reason}")
        stem = f"{SYSTEM}.gain_threshold.{name}"
        row = _row(network, sharp) | {
            "certificate": file_of(stem),
            "seconds": round(time.perf_counter() - started, 3),
        }
    except Exception as error:  # one network must not hide the others
        text = " ".join(str(error).split())[:300]
        return Finding({}, skipped=f"network {name}: {type(error).__name__}: {text}")
    return Finding(row, {stem: sharp.certificate})


def _ask(question: str, network: Network, gamma: bool) -> Answer:
    from verification.inputs import read_inputs

    offered = SYSTEMS[SYSTEM].quantities.QUANTITIES
    quantity = next(entry for entry in offered if entry.name == question)
    given = {"gamma": GAMMA} if gamma else {}
    values = read_inputs(quantity.inputs, given, network, question).values
    answer: Answer = quantity.answer(values)
    return answer


def _row(network: Network, sharp: Answer) -> dict[str, Any]:
    connectivity = _ask("algebraic_connectivity", network, gamma=False).value
    printed = _ask("printed_threshold", network, gamma=True).value
    shown = sharp.more["cut"]()
    assert shown is not None
    cut = shown.data
    exact = (sharp.exact or {}).get("value")
    return {
        "graph": network.label,
        "nodes": network.n,
        "edges": network.m,
        "lambda_2": finite(connectivity),
        "threshold": exact or f"{sharp.lower} … {sharp.upper}",
        "threshold_value": finite(sharp.value),
        "printed_value": finite(printed),
        "ratio": finite(printed / sharp.value),
        "cut": cut["nodes"],
        "cut_edges": cut["edge_count"],
        "cut_links": cut["edges"],
        "names": list(network.names),
        "edge_list": network.edges.tolist(),
        "places": network_places(network.label).round(3).tolist(),
    }
