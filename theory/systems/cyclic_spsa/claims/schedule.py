"""Claims about the cycle, its blocks and Algorithm 1, (15) to (19)."""

from __future__ import annotations

from ....claims import Claim

CLAIMS: tuple[Claim, ...] = ()
