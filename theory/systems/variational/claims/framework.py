"""Claims about sensors, weights and communication."""

from __future__ import annotations

from ....claims import Claim

CLAIMS: tuple[Claim, ...] = ()
