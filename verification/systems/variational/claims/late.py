"""How the claims about moving targets, lost sensors and late data are decided."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from verification.verdict import Decision

DECISIONS: Mapping[str, Callable[[], Decision]] = {}
