"""Identities of bearings hold for bearings that one can write down, and mean what they say."""

import math

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.theory.substitution import substituted
from theory.algebra import plane

FAMILIES = {
    name: getattr(plane, name)()
    for name in (
        "turned", "clockwise", "counter_clockwise", "measured", "information", "rates", "fastest",
        "unbounded",
    )
}  # fmt: skip
SMALL = st.fractions(-3, 3, max_denominator=4).map(sp.sympify)
POSITIVE = st.integers(1, 9).map(lambda k: sp.Rational(k, 3))
VECTORS = st.tuples(SMALL, SMALL).map(sp.Matrix)


def direction(k):
    """Cosine and sine of a bearing whose half has the tangent k."""
    return (1 - k * k) / (1 + k * k), 2 * k / (1 + k * k)


@st.composite
def bearings(draw):
    """Axes, a bearing in them, a sensor, a target and its velocity."""
    e, n = direction(draw(SMALL))
    u, v = sp.Matrix([e, n]), sp.Matrix([-n, e])
    c, s = direction(draw(SMALL))
    f, h = c * u + s * v, -s * u + c * v
    q, t, distance = draw(VECTORS), draw(VECTORS), draw(POSITIVE)
    w = (h.T * t)[0] / distance
    i = -w * f
    known = {"u": u, "v": v, "f": f, "h": h, "q": q, "t": t, "i": i, "p": q + distance * f}
    known |= {"D": h * i.T + i * h.T, "a": u, "b": v}
    return known, {"c": c, "s": s, "l": distance, "w": w}


def values_of(name, matrices, scalars):
    """What each family calls g and q, where that differs."""
    h, f, q, i = (matrices[x] for x in "hfqi")
    if name == "counter_clockwise":
        return matrices | {"g": -h}, scalars
    if name == "information":
        return matrices | {"g": (h.T * q)[0] * h}, scalars
    if name == "rates":
        return matrices | {"g": (i.T * q)[0] * h + (h.T * q)[0] * i}, scalars
    if name == "fastest":
        size = sp.Rational(7, 2)
        twice = (scalars["c"] ** 2 - scalars["s"] ** 2) * matrices["u"]
        twice += 2 * scalars["c"] * scalars["s"] * matrices["v"]
        return matrices | {"q": size * twice}, scalars | {"S": size}
    if name == "unbounded":
        speed = scalars["l"] * scalars["w"]
        known = {"k": speed, "g": 2, "d": speed - 2 * scalars["l"]}
        return matrices | {"D": -scalars["w"] * (f * h.T + h * f.T)}, scalars | known
    return matrices, scalars


@pytest.mark.parametrize("name", sorted(FAMILIES))
@settings(max_examples=5, deadline=None)
@given(data=bearings())
def test_hypotheses_and_goals_hold_for_drawn_bearings(name, data):
    values = values_of(name, *data)
    for entry in FAMILIES[name]:
        assert entry.holds
        for form in entry.relations:
            assert substituted(form, *values).is_zero_matrix, (entry.name, str(form))
        goal = substituted(entry.goal, *values)
        assert goal.is_zero_matrix or (entry.squares and min(goal) >= 0), entry.name


def test_the_printed_vector_is_counter_clockwise_of_the_bearing():
    for theta in np.linspace(0, 2 * math.pi, 17):
        f, h = (math.cos(theta), math.sin(theta)), (-math.sin(theta), math.cos(theta))
        assert f[0] * h[1] - f[1] * h[0] == pytest.approx(1)
        turned = math.atan2(h[1], h[0]) - theta
        assert (turned - math.pi / 2) % (2 * math.pi) == pytest.approx(0, abs=1e-9) or (
            turned - math.pi / 2
        ) % (2 * math.pi) == pytest.approx(2 * math.pi, abs=1e-9)


def test_the_rates_are_the_derivatives():
    """P and q of a target in uniform motion, by symbols of time."""
    time = sp.Symbol("time", real=True)
    sensor, start, speed = sp.Matrix([2, -1]), sp.Matrix([5, 3]), sp.Matrix([-1, 2])
    apart = start + time * speed - sensor
    distance = sp.sqrt(apart.dot(apart))
    f = apart / distance
    h = sp.Matrix([-f[1], f[0]])
    info, offset = h * h.T, (h.T * sensor)[0] * h
    at = {time: sp.Rational(1, 2)}
    w = ((h.T * speed)[0] / distance).subs(at)
    rate, moved = info.diff(time).subs(at), offset.diff(time).subs(at)
    assert sp.simplify(rate + w * (f * h.T + h * f.T).subs(at)) == sp.zeros(2, 2)
    assert sp.simplify(moved - rate * sensor) == sp.zeros(2, 1)
    assert sp.simplify(rate * rate - w**2 * sp.eye(2)) == sp.zeros(2, 2)


def test_factors_of_the_rates_are_those_of_the_identities():
    for_p, for_q = plane.rate_factors()
    assert str(for_p) == "1"
    assert str(for_q) == "T(q)*q"
