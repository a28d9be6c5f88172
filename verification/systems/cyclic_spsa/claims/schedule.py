"""How the claims about the cycle, its blocks and Algorithm 1, (15) to (19) are decided."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from verification.verdict import Decision

DECISIONS: Mapping[str, Callable[[], Decision]] = {}
