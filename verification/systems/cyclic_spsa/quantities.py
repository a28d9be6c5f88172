"""What `bound` and `certify` offer about cyclic SPSA."""

from __future__ import annotations

from verification.answers import Condition, Quantity

QUANTITIES: tuple[Quantity, ...] = ()

CONDITIONS: tuple[Condition, ...] = ()
