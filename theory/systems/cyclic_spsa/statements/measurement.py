"""What certificates about the measurement model, weights and cost, (1) to (14), (20), prove."""

from __future__ import annotations

from ....statements import Statement

STATEMENTS: tuple[Statement, ...] = ()
