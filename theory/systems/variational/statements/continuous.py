"""What certificates about the continuous estimator prove."""

from __future__ import annotations

from ....statements import Statement

STATEMENTS: tuple[Statement, ...] = ()
