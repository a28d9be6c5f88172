"""How the printed claims about bearing sensors with consensus are decided."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from verification.verdict import Decision

from ..lemmas import LEMMA_DECISIONS
from . import consensus, forms, geometry, numerics, positions, theorem_1

DECISIONS: Mapping[str, Callable[[], Decision]] = {
    **geometry.DECISIONS,
    **LEMMA_DECISIONS,
    **consensus.DECISIONS,
    **theorem_1.DECISIONS,
    **forms.DECISIONS,
    **positions.DECISIONS,
    **numerics.DECISIONS,
}
