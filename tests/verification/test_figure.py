"""Figures are data: they survive a file and refuse what cannot be drawn."""

import json

import pytest

from verification.figure import Area, Axis, Curve, Dots, Plot

X, Y = Axis("time", "s", 0.0, 2.0, ticks=(1.0,)), Axis("error", "m", 0.01, 1.0, log=True)
PLOT = Plot(
    title="An error",
    finding="It falls",
    caption="It falls below the bound",
    x=X,
    y=Y,
    curves=(Curve("sharp", (0.0, 2.0), (1.0, 0.1), "error"),),
    areas=(Area("false", (0.0, 1.0), (0.1, 0.1), (1.0, 1.0)),),
    dots=(Dots("refuting", (1.0,), (0.5,), "here"),),
)


def test_a_figure_comes_back_from_a_file_as_it_was():
    assert Plot.from_data(json.loads(json.dumps(PLOT.to_data()))) == PLOT


@pytest.mark.parametrize(
    "curve,what",
    [
        (Curve("mauve", (0.0,), (1.0,)), "role"),
        (Curve("sharp", (0.0, 1.0), (1.0,)), "lengths"),
    ],
)
def test_what_cannot_be_drawn_is_refused(curve, what):
    with pytest.raises(ValueError, match=what):
        Plot("t", "f", "c", X, Y, curves=(curve,))
