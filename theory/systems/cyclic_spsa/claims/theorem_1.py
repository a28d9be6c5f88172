"""Claims about Assumptions 1 to 7 and Theorem 1."""

from __future__ import annotations

from ....claims import Claim

CLAIMS: tuple[Claim, ...] = ()
