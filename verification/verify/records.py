"""What one run leaves behind, as data that the reports read."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from theory.claims import Claim
from verification.verdict import Decision, Verdict

Record = dict[str, Any]
FOLDER = "certificates"


@dataclass(frozen=True)
class Finding:
    """A record and the certificates that it rests on.

    Parameters
    ----------
    record : dict
        An entry of ``claims.json`` or ``networks.json``; empty if there is nothing to say.
    certificates : mapping of str to dict, optional
        File stem to document.
    skipped : str, optional
        Why a check was not made, empty if it was.
    """

    record: Record
    certificates: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    skipped: str = ""


def file_of(stem: str) -> str:
    """Path of a certificate, relative to the output folder."""
    return f"{FOLDER}/{stem}.json"


def finite(value: float | None) -> float | None:
    """A number that JSON can hold, else None."""
    return None if value is None or not math.isfinite(value) else float(value)


def claim_record(claim: Claim, decision: Decision, seconds: float, digest: str) -> Record:
    """Entry of ``claims.json``.

    Its ``margin`` is the relative distance of the printed value from the sharp one, positive where
    the printed one is larger, null where one of them is no number.
    """
    printed, sharp = finite(decision.printed_value), finite(decision.sharp_value)
    return {
        "id": claim.id,
        "system": claim.system,
        "source": claim.source,
        "title": claim.title,
        "statement": claim.statement,
        "formula": claim.formula,
        "printed": decision.printed or claim.printed or None,
        "sharp": decision.sharp or None,
        "printed_value": printed,
        "sharp_value": sharp,
        "sense": claim.sense,
        "verdict": str(decision.verdict),
        "margin": finite(printed / sharp - 1) if printed is not None and sharp else None,
        "margin_text": decision.margin_text,
        "reason": decision.reason,
        "repair": decision.repair,
        "repair_formula": decision.repair_formula,
        "assumptions": list(claim.assumptions),
        "relies_on": list(decision.relies_on),
        "certificates": [file_of(stem) for stem in decision.certificates],
        "replay": [list(row) for row in decision.replay],
        "figure": decision.figure.to_data() if decision.figure else None,
        "seconds": round(seconds, 3),
        "digest": digest,
    }


def undecide(record: Record, reason: str) -> None:
    """Take a record's verdict back, and everything that is only true with it."""
    record |= {"verdict": str(Verdict.UNDECIDED), "reason": reason, "repair": ""}
    record |= {"repair_formula": "", "relies_on": [], "certificates": []}
