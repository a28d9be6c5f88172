"""What the decisions on most claims need: certificates of universal statements, by name."""

from __future__ import annotations

from collections.abc import Mapping
from string import ascii_lowercase
from typing import Any

from sensortrack.networks import Network
from theory.systems.bearing_dac.claim_statements import PROOFS
from verification.certificates.derivations import Derivations

SYSTEM = "bearing_dac"
Document = dict[str, Any]


def lettered(network: Network) -> Document:
    """The graph of a certificate, with letters for nodes that only have numbers."""
    return network.to_data() | {"nodes": list(ascii_lowercase[: network.n])}


MADE = Derivations(SYSTEM, PROOFS)
proof, proofs, disproof = MADE.proof, MADE.proofs, MADE.disproof


def squares(*goals: str) -> list[Document]:
    """Witness of goals that are polynomials with positive coefficients."""
    return [
        {"kind": "derivation", "squares": [[goal, "1", "1"]], "relations": []} for goal in goals
    ]


def file_of(name: str, document: Document) -> dict[str, Document]:
    """One certificate, by the stem of its file."""
    return {f"{SYSTEM}.{name}": document}


def reliances(certificates: Mapping[str, Document]) -> tuple[str, ...]:
    """Theorems that the certificates rely on, each once."""
    return tuple(
        dict.fromkeys(text for made in certificates.values() for text in made["relies_on"])
    )
