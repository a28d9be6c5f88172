"""What certificates about Assumptions 1 to 7 and Theorem 1 prove."""

from __future__ import annotations

from ....statements import Statement

STATEMENTS: tuple[Statement, ...] = ()
