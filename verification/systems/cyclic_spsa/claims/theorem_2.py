"""How the claims about Theorem 2 and its proof are decided."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from verification.verdict import Decision

DECISIONS: Mapping[str, Callable[[], Decision]] = {}
