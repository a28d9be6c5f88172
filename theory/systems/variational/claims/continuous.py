"""Claims about the continuous estimator."""

from __future__ import annotations

from ....claims import Claim

CLAIMS: tuple[Claim, ...] = ()
