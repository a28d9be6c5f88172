"""Claims about the experiment of section 5."""

from __future__ import annotations

from ....claims import Claim

CLAIMS: tuple[Claim, ...] = ()
