"""What stands beside a run of cyclic SPSA: no proved bound on one run, but what it was to do."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from .expected import expectations

__all__ = ["envelopes", "expectations"]


def envelopes(run: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Proved bounds on a run: none, since Gaussian errors have none; see `expectations`."""
    _ = run
    return []
