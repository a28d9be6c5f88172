"""Text from files as it may be shown on a terminal."""

from __future__ import annotations

import re

CONTROL = re.compile(r"[\x00-\x1f\x7f-\x9f\u200e\u200f\u202a-\u202e\u2066-\u2069]")
"""Characters that a terminal acts on, and those that turn the direction of writing."""


def harmless(text: str) -> str:
    """One line of text without characters that play tricks with a terminal."""
    return CONTROL.sub("?", text)
