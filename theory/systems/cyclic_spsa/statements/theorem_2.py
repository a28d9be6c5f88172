"""What certificates about Theorem 2 and its proof prove."""

from __future__ import annotations

from ....statements import Statement
from ..universal import Universal

UNIVERSAL: tuple[Universal, ...] = ()

STATEMENTS: tuple[Statement, ...] = ()
