"""What certificates about the estimator under measurement noise prove."""

from __future__ import annotations

from ....statements import Statement

STATEMENTS: tuple[Statement, ...] = ()
