"""Printed statements of Erofeeva & Granichin that their text does not determine."""

from __future__ import annotations

from ...claims import Gap

GAPS: tuple[Gap, ...] = ()
