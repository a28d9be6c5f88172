"""How the claims about the continuous estimator are decided."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from verification.verdict import Decision

DECISIONS: Mapping[str, Callable[[], Decision]] = {}
