"""How the printed claims about the variational estimator are decided."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from verification.verdict import Decision

from . import continuous, discrete, framework, late, noise, schemes, simulated

DECISIONS: Mapping[str, Callable[[], Decision]] = {
    **framework.DECISIONS,
    **continuous.DECISIONS,
    **noise.DECISIONS,
    **discrete.DECISIONS,
    **schemes.DECISIONS,
    **simulated.DECISIONS,
    **late.DECISIONS,
}
