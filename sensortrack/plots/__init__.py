"""Figures of runs and networks with matplotlib, in the look of the reports."""

from .figures import save_run
from .networks import draw_cut
from .style import COLOURS, style

__all__ = ["COLOURS", "draw_cut", "save_run", "style"]
