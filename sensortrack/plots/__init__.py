"""Figures of runs with matplotlib, in the look of the reports."""

from .figures import save_run
from .style import COLOURS, style

__all__ = ["COLOURS", "save_run", "style"]
