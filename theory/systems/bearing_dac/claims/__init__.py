"""What George claims, in the order of the poster."""

from __future__ import annotations

from ....claims import Claim
from . import algorithm, averaging, consensus, forms, geometry, lemmas, numerics, theorem_1

CLAIMS: tuple[Claim, ...] = (
    *geometry.CLAIMS,
    *averaging.CLAIMS,
    *lemmas.CLAIMS,
    *consensus.CLAIMS,
    *theorem_1.CLAIMS,
    *forms.CLAIMS,
    *algorithm.CLAIMS,
    *numerics.CLAIMS,
)
