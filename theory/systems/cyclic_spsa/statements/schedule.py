"""What certificates about the cycle, its blocks and Algorithm 1, (15) to (19) prove."""

from __future__ import annotations

from ....statements import Statement

STATEMENTS: tuple[Statement, ...] = ()
