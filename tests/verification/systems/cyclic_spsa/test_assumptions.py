"""Sharp constants of Assumptions 1 to 5: a second road to each, and what refutes smaller ones."""

import itertools
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from verification.certificates import check
from verification.certificates.make import statements
from verification.exact.evaluate import dot, quadratic
from verification.inputs import read_inputs
from verification.systems.cyclic_spsa.assumptions.constants import NAMES
from verification.systems.cyclic_spsa.assumptions.sharp import (
    COST,
    GIVEN,
    WANTED_C3,
    assumption_constants,
    decide_assumptions,
)

SMALL = st.integers(-4, 4).map(lambda k: Fraction(k, 2))
POSITIVE = st.integers(1, 6).map(lambda k: Fraction(k, 2))


def ask(**given):
    return assumption_constants(read_inputs((*COST, WANTED_C3), given).values)


def decide(constants, **given):
    values = dict(zip(NAMES, constants, strict=True))
    return decide_assumptions(read_inputs((*COST, *GIVEN), given | values).values)


def chosen(answer):
    """The vector that a certificate puts in."""
    items = (item for item in answer.certificate["witness"] if item["kind"] == "matrix")
    return [Fraction(row[0]) for row in next(items)["rows"]]


def valid(answer):
    return check.check_document(answer.certificate, statements())


def enumerated(hessian, points, eta, y, before=None):
    """E(f_t(x) - f_(t-1)(x))^2 at x = theta + y, the noise taking points with probabilities."""
    total = Fraction(0)
    for new, old in itertools.product(points, repeat=2):
        now = [a - b - c for a, b, c in zip(y, eta, new[0], strict=True)]
        then = [a - b for a, b in zip(y, old[0], strict=True)]
        total += (
            new[1]
            * old[1]
            * (quadratic(now, hessian) - quadratic(then, before or hessian)) ** 2
            / 4
        )
    return total


def laws(scales, law):
    """Points of noise whose coordinates are independent: two, or three with Gaussian moments."""
    one = {
        "two_point": ((-1, Fraction(1, 2)), (1, Fraction(1, 2))),
        # mean square 1/3 and mean fourth power 1/3, three times the square of that
        "gaussian": ((-1, Fraction(1, 6)), (0, Fraction(2, 3)), (1, Fraction(1, 6))),
    }[law]
    for entry in itertools.product(one, repeat=len(scales)):
        weight = Fraction(1)
        for _, share in entry:
            weight *= share
        yield [a * scale for (a, _), scale in zip(entry, scales, strict=True)], weight


@st.composite
def costs(draw):
    h = (draw(POSITIVE), draw(POSITIVE))
    off = draw(st.sampled_from([Fraction(0), min(h) / 2, -min(h) / 3]))
    scales, eta = (draw(POSITIVE), draw(POSITIVE)), (draw(SMALL), draw(SMALL))
    return ((h[0], off), (off, h[1])), scales, eta, draw(st.sampled_from(["gaussian", "two_point"]))


@settings(max_examples=25, deadline=None)
@given(costs(), st.lists(SMALL, min_size=2, max_size=2))
def test_the_constants_hold_at_every_point_by_enumeration(cost, y):
    hessian, scales, eta, law = cost
    part = Fraction(1, 3) if law == "gaussian" else Fraction(1)
    noise = [[part * scales[0] ** 2, 0], [0, part * scales[1] ** 2]]
    found = ask(H=[list(row) for row in hessian], Xi=noise, eta=list(eta), law=law)
    valid(found)
    _, _, c2, c3, c4, delta = (Fraction(x) for x in found.upper)
    points = list(laws(scales, law))
    assert enumerated(hessian, points, eta, y) <= c3 * dot(y, y) + c4
    power = sum(
        (w * sum(dot(row, x) ** 2 for row in hessian) for x, w in points), start=Fraction(0)
    )
    assert float(power) == pytest.approx(float(c2), rel=1e-12)
    assert delta**2 >= dot(eta, eta)
    values = np.linalg.eigvalsh(np.array(hessian, float))
    assert found.value[:2] == pytest.approx([values[0], values[-1]], rel=1e-9)


@settings(max_examples=25, deadline=None)
@given(costs())
def test_they_are_proved_and_smaller_ones_refuted_by_name(cost):
    hessian, scales, eta, law = cost
    noise = [[scales[0], 0], [0, scales[1]]]
    data = {"H": [list(row) for row in hessian], "Xi": noise, "eta": list(eta), "law": law}
    found = ask(**data)
    good = [Fraction(found.lower[0]), *map(Fraction, found.upper[1:])]
    assert valid(decide(good, **data))["verdict"] == "PROVED"
    for k, name in enumerate(NAMES):
        if not good[k]:
            continue
        bad = list(good)
        bad[k] *= Fraction(101 if name == "mu" else 99, 100)
        if name == "c3":
            bad[k] *= Fraction(1, 3)
        answer = decide(bad, **data)
        assert answer.verdict == valid(answer)["verdict"] == "REFUTED"
        assert answer.notes[0].startswith(f"{name}:")
        assert answer.margin < 0


@settings(max_examples=20, deadline=None)
@given(costs())
def test_c4_is_reached_at_some_point(cost):
    """The certificate of a slightly smaller c4 names the point; the enumeration agrees there."""
    hessian, scales, eta, law = cost
    part = Fraction(1, 3) if law == "gaussian" else Fraction(1)
    noise = [[part * scales[0] ** 2, 0], [0, part * scales[1] ** 2]]
    data = {"H": [list(row) for row in hessian], "Xi": noise, "eta": list(eta), "law": law}
    found = ask(**data)
    good = [Fraction(found.lower[0]), *map(Fraction, found.upper[1:])]
    if not good[4]:
        return
    bad = [*good[:4], good[4] * Fraction(9, 10), good[5]]
    answer = decide(bad, **data)
    y = chosen(answer)
    points = list(laws(scales, law))
    assert enumerated(hessian, points, eta, y) > bad[3] * dot(y, y) + bad[4]


def test_known_values_of_static_costs():
    """Isotropic Gaussian: c2 = D h^2 s, c3 = 2 h^2 s, c4 = D (h s)^2, all in closed form."""
    found = ask(h=["2"] * 6, Xi="1/4")
    assert found.value == [2, 2, 6, 2, Fraction(3, 2), 0]
    assert ask(h=["2"] * 6, Xi="1/4", law="two_point").value[4] == 0


def test_a_chosen_c3_has_its_c4_and_one_too_small_has_none():
    free, more = ask(h=["1"], Xi="1", eta=["1"]), ask(h=["1"], Xi="1", eta=["1"], c3="60")
    assert free.value[3] == 6
    assert more.value[4] < free.value[4]
    with pytest.raises(InputError, match="is needed for a c4"):
        ask(h=["1"], Xi="1", eta=["1"], c3="3")
    answer = decide(["1", "1", "1", "3", "1000", "1"], h=["1"], Xi="1", eta=["1"])
    assert valid(answer)["verdict"] == "REFUTED"
    assert answer.notes == ("c4: with exactly this c3, none is enough",)


def test_the_printed_assumption_is_about_another_change():
    notes = " ".join(ask(h=["1"] * 12, Xi="25/2").notes)
    assert "c3 = 0 and c4 = 1875" in notes


def test_bounds_on_the_hessian_are_enough_and_three_constants_are_reached():
    data = {"low": "1", "high": "2", "Xi": [["1", "1/2"], ["1/2", "1"]], "eta": ["1", "0"]}
    found = ask(**data)
    valid(found)
    assert found.value[:3] == [1, 2, 8]
    good = [Fraction(found.lower[0]), *map(Fraction, found.upper[1:])]
    assert valid(decide(good, **data))["verdict"] == "PROVED"
    for k, verdict in enumerate(["REFUTED"] * 3 + ["UNDECIDED"] * 2 + ["REFUTED"]):
        bad = list(good)
        bad[k] *= Fraction(101 if k == 0 else 99, 100)
        assert decide(bad, **data).verdict == verdict
    for h in ("1", "3/2", "2"):  # quadratics between the bounds
        inside = [Fraction(h)] * 2
        answer = decide([h, h, *good[2:]], h=inside, Xi=data["Xi"], eta=data["eta"])
        assert answer.verdict == "PROVED"


LIST = {"costs": [[["1", "0"], ["0", "2"]], [["3", "1"], ["1", "1"]]], "Xi": "1/2"}


def test_costs_that_change_have_the_worst_of_each_constant_and_no_c3():
    found = ask(**LIST, eta=["1", "0"])
    alone = [ask(H=rows, Xi="1/2", eta=["1", "0"]).value for rows in LIST["costs"]]
    assert found.value[0] == pytest.approx(min(x[0] for x in alone))
    assert found.value[1:3] == pytest.approx([max(x[k] for x in alone) for k in (1, 2)])
    assert found.value[3:5] == [float("inf")] * 2
    assert found.value[5] == 1


@settings(max_examples=20, deadline=None)
@given(costs(), st.integers(0, 10**9), st.integers(0, 10**9))
def test_no_c3_is_enough_from_one_hessian_to_another(cost, c3, c4):
    hessian, scales, eta, _ = cost
    other = ((hessian[0][0] + 1, hessian[0][1]), hessian[1])
    part = Fraction(1, 3)
    noise = [[part * scales[0] ** 2, 0], [0, part * scales[1] ** 2]]
    answer = decide(
        [Fraction(1, 10**6), 100, 10**6, c3, c4, 100],
        costs=[[list(row) for row in rows] for rows in (hessian, other)],
        Xi=noise,
        eta=list(eta),
    )
    assert valid(answer)["verdict"] == answer.verdict == "REFUTED"
    assert answer.notes[0].startswith("c3:")
    inputs = answer.certificate["inputs"]
    now, before = (tuple(tuple(map(Fraction, row)) for row in inputs[name]) for name in ("H", "G"))
    y = chosen(answer)
    points = list(laws(scales, "gaussian"))
    assert enumerated(now, points, eta, y, before) > c3 * dot(y, y) + c4


def test_what_is_wrong_with_one_cost_of_a_list_is_named_first():
    for k, name in enumerate(("mu", "M", "c2")):
        constants = ["1/3", "4", "6", "9", "9", "0"]
        constants[k] = "1" if name == "mu" else "1/2"
        answer = decide(constants, **LIST)
        assert answer.notes[0].startswith(f"{name}:")
        assert valid(answer)["verdict"] == "REFUTED"


@pytest.mark.parametrize(
    "given, name",
    [
        (LIST | {"h": ["1"]}, "h"),
        (LIST | {"low": "1"}, "low"),
        (LIST | {"c3": "1"}, "c3"),
        ({"costs": [[["1"]], [["1", "0"], ["0", "1"]]]}, "costs"),
        ({"costs": ["1", "1"]}, "costs"),
        ({"costs": ["1", "-1"]}, "costs"),
        ({"costs": "1"}, "costs"),
        ({"costs": ["1", [["1"], ["2", "3"]]]}, "costs"),
        ({"Xi": "1"}, "h"),
        ({"h": ["1"], "H": [["1"]], "Xi": "1"}, "h"),
        ({"H": [["1", "2"], ["2", "1"]]}, "H"),
        ({"h": ["1", "1"], "Xi": [["1", "2"], ["2", "1"]]}, "Xi"),
        ({"h": ["1"], "law": "cauchy"}, "law"),
        ({"h": ["1", "1"], "law": "two_point", "Xi": [["1", "1/2"], ["1/2", "1"]]}, "Xi"),
        ({"h": ["1"], "low": "1", "high": "2"}, "low"),
        ({"low": "1"}, "high"),
        ({"low": "2", "high": "1", "Xi": "1"}, "low"),
        ({"low": "1", "high": "2", "Xi": "1", "c3": "1"}, "c3"),
    ],
)
def test_bad_input_names_what_is_wrong(given, name):
    with pytest.raises(InputError) as caught:
        ask(**given)
    assert caught.value.name == name


def test_negative_constants_are_refused():
    with pytest.raises(InputError, match="c3"):
        decide(["1", "1", "1", "-1", "1", "0"], h=["1"], Xi="1")
    with pytest.raises(InputError, match="mu: 0"):
        decide(["0", "1", "1", "1", "1", "0"], h=["1"], Xi="1")
