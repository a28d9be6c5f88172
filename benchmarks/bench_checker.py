"""How long it takes to re-check a certificate, against the size of the network."""

import json
from fractions import Fraction

import pytest

from sensortrack.networks import read_network
from verification.certificates import check
from verification.certificates.make import certificate, statements


def document(family: str, n: int) -> dict[str, object]:
    """Gain threshold of a path (single edges decide) or a cycle (arcs decide), gamma = 1."""
    half = n // 2
    edges_cut = {"path": 1, "cycle": 2}[family]
    threshold = Fraction(2 * half * (n - half), n * edges_cut)
    part = {"path": {"kind": "tree"}, "cycle": {"kind": "enumeration", "order": list(range(n))}}
    return certificate(
        "bearing_dac",
        "gain_threshold",
        {"graph": read_network(f"{family}:{n}").to_data(), "gamma": 1},
        [{"kind": "cuts", "parts": [part[family]]}, {"kind": "cut", "nodes": list(range(half))}],
        lower=threshold,
        upper=threshold,
    )


@pytest.mark.parametrize(
    "family, n", [("path", 100), ("path", 1000), ("path", 10000), ("cycle", 16), ("cycle", 32)]
)
def test_gain_threshold(benchmark, family: str, n: int) -> None:
    made = document(family, n)
    known = statements()

    entry = benchmark(check.check_document, made, known)

    benchmark.extra_info |= {
        "nodes": n,
        "bytes": len(json.dumps(made)),
        "verdict": entry["verdict"],
        "width": float(Fraction(entry["upper"]) - Fraction(entry["lower"])),
    }
    assert entry["verdict"] == "PROVED"
    assert entry["lower"] == entry["upper"]
