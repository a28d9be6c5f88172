"""Claims about the measurement model, the weights and the cost, (1) to (14) and (20)."""

from __future__ import annotations

from ....claims import Claim

CLAIMS: tuple[Claim, ...] = ()
