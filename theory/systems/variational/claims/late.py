"""Claims about the simulations: moving targets, lost sensors, late data."""

from __future__ import annotations

from ....claims import Claim

CLAIMS: tuple[Claim, ...] = ()
