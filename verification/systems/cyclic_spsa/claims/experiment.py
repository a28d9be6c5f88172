"""How the claims about the experiment of section 5 are decided."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from verification.verdict import Decision

DECISIONS: Mapping[str, Callable[[], Decision]] = {}
