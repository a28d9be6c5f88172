"""Witness items that several decisions use."""

from __future__ import annotations

from typing import Any


def derivation(
    squares: tuple[tuple[str, str, str], ...] = (), *relations: tuple[str, str, str]
) -> Any:
    """Witness that an expression is a sum of squares plus multiples of what is given."""
    return {
        "kind": "derivation",
        "squares": [list(entry) for entry in squares],
        "relations": [list(entry) for entry in relations],
    }
