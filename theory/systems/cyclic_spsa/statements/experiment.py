"""What certificates about the experiment of section 5 prove."""

from __future__ import annotations

from ....statements import Statement

STATEMENTS: tuple[Statement, ...] = ()
