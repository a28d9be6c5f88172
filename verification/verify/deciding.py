"""Decide one claim, whatever happens on the way."""

from __future__ import annotations

import re
import time

from theory.claims import Claim
from theory.systems import SYSTEMS as THEORY
from verification.systems import SYSTEMS
from verification.verdict import Decision, Verdict

from .records import Finding, claim_record

STEM = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.-]*")


def decide(claim_id: str) -> Finding:
    """Decide the claim of that name.

    Returns
    -------
    Finding
        UNDECIDED with the stage and the error where something failed: one claim never stops the
        others.
    """
    started = time.perf_counter()
    claim, digest = _claim(claim_id)
    decision = _decision(claim)
    record = claim_record(claim, decision, time.perf_counter() - started, digest)
    return Finding(record, dict(decision.certificates))


def lost(claim_id: str, reason: str) -> Finding:
    """What is left of a claim whose process ended."""
    claim, digest = _claim(claim_id)
    return Finding(claim_record(claim, _undecided(f"stage decide: {reason}"), 0.0, digest))


def _claim(claim_id: str) -> tuple[Claim, str]:
    for system in THEORY:
        for claim in system.claims:
            if claim.id == claim_id:
                return claim, system.digest
    raise KeyError(claim_id)


def _decision(claim: Claim) -> Decision:
    stage = "load"
    try:
        room = SYSTEMS.get(claim.system)
        function = room.claims.DECISIONS.get(claim.id) if room else None
        if function is None:
            return _undecided("stage load: nothing in verification/systems decides this claim")
        stage = "decide"
        decision: Decision = function()
        stage = "certificates"
        for stem in decision.certificates:
            if not STEM.fullmatch(stem):
                raise ValueError(f"{stem!r} cannot be the name of a file")
    except Exception as error:  # a fault in one decision must not hide the others
        text = " ".join(str(error).split())[:300]
        return _undecided(f"stage {stage}: {type(error).__name__}: {text}")
    return decision


def _undecided(reason: str) -> Decision:
    return Decision(Verdict.UNDECIDED, reason)
