"""Which claims to decide."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sensortrack.errors import InputError
from theory.claims import Claim
from theory.systems import SYSTEMS
from verification.input_words import brief, nearest


@dataclass(frozen=True)
class Selection:
    """What a user chose.

    Parameters
    ----------
    claims : tuple of Claim
        In the order of theory, none twice.
    systems : frozenset of str
        Systems that were chosen as a whole.
    """

    claims: tuple[Claim, ...]
    systems: frozenset[str]


def select(texts: Sequence[str]) -> Selection:
    """Choose claims by ``SYSTEM`` or ``SYSTEM.CLAIM``; everything without a text.

    Raises
    ------
    InputError
        No system or claim has that name.
    """
    systems = [system.name for system in SYSTEMS]
    claims = [claim for system in SYSTEMS for claim in system.claims]
    ids = [claim.id for claim in claims]
    for text in texts:
        system = text.partition(".")[0]
        if system not in systems:
            hint = nearest(system, systems) or f"one of {', '.join(systems)} is needed"
            raise InputError(brief(text), "no such system", hint)
        if text != system and text not in ids:
            hint = nearest(text, ids) or "another is needed"
            cure = f"'sensortrack claims {system}' lists them"
            raise InputError(brief(text), "no such claim", hint, cure)
    whole = frozenset(texts or systems).intersection(systems)
    chosen = (claim for claim in claims if claim.system in whole or claim.id in texts)
    return Selection(tuple(chosen), whole)
