"""Claims about measurement noise."""

from __future__ import annotations

from ....claims import Claim

CLAIMS: tuple[Claim, ...] = ()
