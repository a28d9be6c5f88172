"""What certificates about late data, lost sensors and moving targets prove."""

from __future__ import annotations

from ....statements import Statement

STATEMENTS: tuple[Statement, ...] = ()
