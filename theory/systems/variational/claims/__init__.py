"""What Sanyal & Eslamiat claim, in the order of their paper."""

from __future__ import annotations

from ....claims import Claim
from . import continuous, discrete, framework, late, noise, schemes

CLAIMS: tuple[Claim, ...] = (
    *framework.CLAIMS,
    *continuous.CLAIMS,
    *noise.CLAIMS,
    *discrete.CLAIMS,
    *schemes.CLAIMS,
    *late.CLAIMS,
)
