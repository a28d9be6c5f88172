"""What certificates about sensors, weights and communication prove."""

from __future__ import annotations

from ....statements import Statement

STATEMENTS: tuple[Statement, ...] = ()
