"""What certificates about the claims prove, apart from Theorem 1 as printed and the lemmas."""

from __future__ import annotations

from collections.abc import Mapping

from ....algebra.identities import Identity
from ....statements import Statement
from . import consensus, geometry, numerics, positions

UNIVERSAL = (*geometry.GEOMETRY, *consensus.CONSENSUS, *numerics.DISCRETE)

PROOFS: Mapping[str, tuple[Identity, ...]] = {entry.name: entry.proof for entry in UNIVERSAL}
"""The identities that prove a universal statement, by its name."""

STATEMENTS: tuple[Statement, ...] = (
    *(entry.statement for entry in UNIVERSAL),
    geometry.two_sensors(),
    consensus.any_offset(),
    consensus.free_estimate(),
    consensus.path_of_three(),
    consensus.estimates(),
    consensus.from_four_on(),
    *consensus.repairs_as_forms(),
    consensus.time_of_others(),
    positions.late_position(),
    positions.singular_later(),
    numerics.example(),
    numerics.enough(),
    numerics.attained(),
)
