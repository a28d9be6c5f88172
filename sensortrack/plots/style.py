"""One look for all figures: colours by role, the same bytes for the same data."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

COLOURS = {
    "sharp": "#006468",
    "printed": "#8a5600",
    "refuted": "#b01030",
    "bound": "#5848ad",
    "run": "#636870",
    "target": "#1b1d21",
    "paper": "#fcfbf8",
    "rule": "#8b8a83",
}
"""Role to colour; roles, never an order, decide."""

SERIFS = ("Palatino", "TeX Gyre Pagella", "Liberation Serif", "DejaVu Serif")
"""The first that is installed."""

SETTINGS = {
    "figure.figsize": (4.8, 3.3),
    "figure.dpi": 200,
    "figure.facecolor": COLOURS["paper"],
    "axes.facecolor": COLOURS["paper"],
    "savefig.facecolor": COLOURS["paper"],
    "font.family": "serif",
    "font.size": 9,
    "xtick.labelsize": 8,
    "ytick.labelsize": 8,
    "mathtext.fontset": "stix",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.linewidth": 0.8,
    "axes.edgecolor": COLOURS["rule"],
    "lines.linewidth": 1.8,
    "svg.fonttype": "none",
    "svg.hashsalt": "sensortrack",
}


@contextmanager
def style() -> Iterator[None]:
    """Draw in the look of the reports within this context."""
    import matplotlib as mpl
    from matplotlib import font_manager

    present = {font.name for font in font_manager.fontManager.ttflist}
    fonts = [font for font in SERIFS if font in present]
    chosen: Any = {**SETTINGS, "font.serif": fonts}
    with mpl.rc_context(chosen):
        yield


def axes_of(**options: Any) -> tuple[Figure, Axes]:
    """A figure that is written as SVG, and its axes."""
    from matplotlib.backends.backend_svg import FigureCanvasSVG
    from matplotlib.figure import Figure

    figure = Figure(layout="constrained")
    FigureCanvasSVG(figure)
    return figure, figure.add_subplot(**options)
