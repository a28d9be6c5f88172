"""Generated source as functions."""

from typing import Any


def loaded(text: str) -> dict[str, Any]:
    """What a module of this text defines."""
    space: dict[str, Any] = {}
    exec(text, space)
    return space
