"""A toy system, so that the command line is tested without the mathematics of a real one."""

from fractions import Fraction
from types import SimpleNamespace

import pytest

from verification.answers import Answer, Condition, Input, Quantity
from verification.certificates.make import certificate
from verification.cli.main import main
from verification.systems import SYSTEMS

NAME = "toy"
GAINS = (Input("M", "matrix", "a gain", "kg"), Input("K", "matrix", "another"))
NODES = (
    Input("graph", "graph", "the network"),
    Input("gamma", "node numbers", "bound on the disturbance", default="1"),
)
STEP = Input("h", "number", "a step", "s")


def proof():
    """A real certificate, whatever the toy was asked."""
    one = ((Fraction(1),),)
    inputs = {"M": one, "K": one, "C": one, "h": Fraction(1, 10)}
    return certificate("variational", "step", inputs, [])


def trace(values):
    sizes = [len(values[name]) for name in "MK"]
    total = sum(values["M"][i][i] + values["K"][i][i] for i in range(sizes[0]))
    return Answer(
        value=float(total),
        exact={"kind": "rational", "value": str(total)},
        lower=float(total),
        upper=float(total),
        printed=2 * float(total),
        verdict="PROVED",
        certificate=proof(),
        notes=(f"sizes {sizes}",),
    )


def total(values):
    return Answer(value=float(sum(values["gamma"])), notes=("a note",))


def fixed(**fields):
    return lambda _values: Answer(**fields)


def fail(values):
    raise RuntimeError("two\nlines")


def compare(values):
    verdict = "PROVED" if values["h"] < 1 else "REFUTED" if values["h"] > 1 else "UNDECIDED"
    document = None if verdict == "UNDECIDED" else proof()
    return Answer(verdict=verdict, margin=float(1 - values["h"]), certificate=document)


ROOT = {"kind": "algebraic", "polynomial": [-2, 0, 1], "interval": ["7/5", "3/2"]}
QUANTITIES = (
    Quantity("trace", "sum of the diagonals", GAINS, trace, True),
    Quantity("total", "sum over the nodes", NODES, total, False),
    Quantity("endless", "never", (), fixed(value=float("inf"), lower=[1.0, -2.5]), False),
    Quantity("root", "of two", (), fixed(value=2**0.5, exact=ROOT, verdict="PROVED"), True),
    Quantity("open", "bracket", (), fixed(lower=1.0, upper=2.0, verdict="UNDECIDED"), True),
    Quantity("broken", "raises", (), fail, False),
)
CONDITIONS = (Condition("small", "h < 1", (STEP,), compare),)


@pytest.fixture
def toy(monkeypatch):
    room = SimpleNamespace(quantities=SimpleNamespace(QUANTITIES=QUANTITIES, CONDITIONS=CONDITIONS))
    monkeypatch.setitem(SYSTEMS, NAME, room)


@pytest.fixture
def run(toy, capsys):
    """Run the command here: exit status, stdout, lines of stderr."""

    def call(*argv):
        status = main(list(map(str, argv)))
        out, err = capsys.readouterr()
        return status, out, err.splitlines()

    return call
