"""Theorem 1, printed and proved: formulas beside a second way to each, units, ranges."""

from fractions import Fraction
from math import sqrt

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from theory.systems.cyclic_spsa.bounds import PRINTED, PROVED, unit_clashes
from verification.systems.cyclic_spsa.printed.bounds import (
    corrected_bound,
    printed_bound,
    printed_interval,
)

CONSTANTS = dict.fromkeys(("delta", "c2", "c3", "c4", "c_v2"), Fraction(0)) | {"k": Fraction(1)}
SMALL = st.fractions(Fraction(0), Fraction(3), max_denominator=20)
ABOVE_ZERO = st.fractions(Fraction(1, 20), Fraction(3), max_denominator=20)


def question(**numbers):
    return CONSTANTS | {name: Fraction(str(x)) for name, x in numbers.items()}


@st.composite
def problems(draw):
    """Constants that Assumptions 1 to 7 allow."""
    names = ("delta", "c2", "c3", "c4", "c_v2")
    given_ = {name: draw(SMALL) for name in names}
    mu = draw(ABOVE_ZERO)
    whole = {name: Fraction(draw(st.integers(1, 4))) for name in ("d", "k")}
    return {**given_, **whole, "mu": mu, "M": mu + draw(SMALL), "beta": draw(ABOVE_ZERO)}


def literal(g):
    """gamma and the bound (21) in floats, typed from the page once more."""
    d, k, mu, m_, beta, delta, alpha = (
        float(g[name]) for name in ("d", "k", "mu", "M", "beta", "delta", "alpha")
    )
    gamma = 3 * d * (m_ * m_ * d + float(g["c3"]) / beta)
    m = 2 * mu - 2 * alpha * gamma
    b = 2 * beta * m_ * d**1.5 * (1 + 6 * alpha * m_ * d)
    b += delta * (m_ + 2 * mu + 6 * alpha * (m_ * d) ** 2)
    inner = float(g["c4"]) / beta + d * (float(g["c2"]) + m_**2 * (delta + 2 * beta * sqrt(d)) ** 2)
    small = 2 * alpha * d * (float(g["c_v2"]) + 3 * inner)
    small += 2 * delta * (4 * beta * m_ * d**1.5 + m_ * delta + 3 * mu * delta**2)
    large = small + 2 * b * k**1.5 * delta + (1 - alpha * m) / alpha * delta**2
    return gamma, sqrt(k) * (b + sqrt(b * b + m * large)) / m


def settled(g):
    """Fixed point of the inequality that one update satisfies, by iterating it in floats."""
    d, k, mu, m_, beta, delta, alpha = (
        float(g[name]) for name in ("d", "k", "mu", "M", "beta", "delta", "alpha")
    )
    c2, c3, noise = float(g["c2"]), float(g["c3"]), float(g["c4"] + g["c_v2"])
    error = 1.0
    for _ in range(200_000):
        q = error + 2 * k * delta
        pull = -2 * mu * q * q + ((2 * mu + m_) * delta + m_ * beta * d**1.5) * q + m_ * delta**2
        slope = 2 * beta * sqrt(d)
        first = slope**2 * (2 * c2 + 2 * m_**2 * (q + beta * sqrt(d)) ** 2)
        second = c3 * ((q + delta) ** 2 + beta**2 * d) + noise
        push = 3 * d * (first + second) / (4 * beta**2)
        new = sqrt(q * q + alpha * pull + alpha**2 * push)
        if abs(new - error) <= 1e-14 * new:
            break
        error = new
    return sqrt(k) * error


@settings(max_examples=60, deadline=None)
@given(problems(), st.fractions(Fraction(1, 50), Fraction(49, 50), max_denominator=50))
def test_printed_bound_is_the_printed_formula(problem, part):
    gamma = 3 * problem["d"] * (problem["M"] ** 2 * problem["d"] + problem["c3"] / problem["beta"])
    problem["alpha"] = part * problem["mu"] / gamma
    found = printed_bound(problem)
    assert found.value == pytest.approx(literal(problem)[1], rel=1e-12)
    assert found.lower <= found.value <= found.upper
    assert found.upper - found.lower <= 1e-15 * found.value


@settings(max_examples=25, deadline=None)
@given(problems(), st.fractions(Fraction(1, 5), Fraction(4, 5), max_denominator=20))
def test_corrected_bound_is_where_the_inequality_of_one_update_settles(problem, part):
    d, m_, beta = problem["d"], problem["M"], problem["beta"]
    gamma = 3 * d * (m_**2 * d + problem["c3"] / (8 * beta**2))
    problem["alpha"] = part * problem["mu"] / gamma
    assert corrected_bound(problem).value == pytest.approx(settled(problem), rel=1e-8)


@pytest.mark.parametrize(
    "numbers, printed, corrected",
    [
        # d, alpha, beta, noise a coordinate, drift: table of bounds for isotropic quadratics
        ((1, "0.05", 1, "0.25", 0), 3.290130, 1.155553),
        ((2, "0.02", 1, 1, 0), 9.591757, 3.302684),
        ((12, "0.002", 1, 1, 0), 699.8947, 227.6533),
        ((2, "0.01", 1, "0.01", "0.1"), 8.038962, 24.623089),
        ((2, "0.001", 1, "0.01", "0.1"), 7.078442, 203.756909),
        ((12, "0.0005", 3, 1, 1), 340.9542, 5196.1878),
    ],
)
def test_bounds_have_the_values_of_an_earlier_computation(numbers, printed, corrected):
    d, alpha, beta, variance, delta = (Fraction(str(x)) for x in numbers)
    xi = variance
    # f_w(x) = |x - w|^2/2 with w of covariance xi I around a target that drifts by delta
    eta_square = delta**2
    c4 = (4 * d * xi**2 + 4 * xi * eta_square + eta_square**2) / 2
    c3 = 2 * (2 * xi + eta_square)
    if not delta:
        c3, c4 = 2 * xi, d * xi**2
    base = {"d": d, "mu": 1, "M": 1, "alpha": alpha, "beta": beta, "delta": delta, "c2": d * xi}
    given_ = question(**{name: str(x) for name, x in base.items()})
    assert printed_bound({**given_, "c4": c4}).value == pytest.approx(printed, rel=1e-6)
    assert corrected_bound({**given_, "c3": c3, "c4": c4}).value == pytest.approx(
        corrected, rel=1e-6
    )


def in_other_units(g, length, cost):
    """The same problem with positions and costs counted in other units."""
    powers = {
        **{"mu": (1, -2), "M": (1, -2), "alpha": (-1, 2), "beta": (0, 1), "delta": (0, 1)},
        **{"c2": (2, -2), "c3": (2, -2), "c4": (2, 0), "c_v2": (2, 0)},
    }
    scale = {name: cost**f * length**x for name, (f, x) in powers.items()}
    return {name: x * scale.get(name, 1) for name, x in g.items()}


MOVING = question(
    **{"d": 2, "mu": 1, "M": 1, "alpha": "1/100", "beta": 1, "delta": "1/10"},
    **{"c2": "1/50", "c3": "1/100", "c4": "1/100", "c_v2": "1/10"},
)


def test_corrected_bound_scales_with_the_units_and_the_printed_one_does_not():
    metres = in_other_units(MOVING, Fraction(1000), Fraction(10**6))
    km, m = corrected_bound(MOVING).value, corrected_bound(metres).value
    assert m == pytest.approx(1000 * km, rel=1e-14)
    assert abs(printed_bound(metres).value - 1000 * printed_bound(MOVING).value) > 1


def test_unit_checker_names_the_printed_summands_that_do_not_fit():
    found = {name: dict(clash.terms) for name, (clash,) in unit_clashes(PRINTED).items()}
    assert {name: [*terms] for name, terms in found.items()} == {
        "gamma": ["M**2*d", "c3/beta"],
        "change": ["c4/beta", "d*(c2 + M**2*(delta + 2*beta*root_d)**2)"],
        "spread": ["c_v2", "3*change"],
        "lag": ["4*beta*M*d*root_d", "M*delta", "3*mu*delta**2"],
    }
    odd = [found["gamma"]["c3/beta"], found["change"]["c4/beta"], found["spread"]["c_v2"]]
    assert odd == ["F^2/L^3", "F^2/L", "F^2"]
    assert unit_clashes(PROVED) == {}


def test_bounds_grow_without_limit_at_the_end_of_their_interval_and_are_infinite_there():
    given_ = question(d=1, mu=1, M=1, beta=1, delta="0.5")
    for bound in (printed_bound, corrected_bound):
        before = [
            bound({**given_, "alpha": Fraction(1, 3) - Fraction(1, 10**n)}).value for n in (4, 8)
        ]
        assert 1e4 < before[0] < before[1] / 1000
        at_end = bound({**given_, "alpha": Fraction(1, 3)})
        assert at_end.value == "inf"
        assert "1/3" in at_end.notes[0]


def test_k_blocks_multiply_the_bound_of_one_by_the_root_of_k():
    static = question(d=2, mu=1, M=2, alpha="1/100", beta=1, c2=1)
    one, four = (corrected_bound({**static, "k": Fraction(k)}).value for k in (1, 4))
    assert four == pytest.approx(2 * one, rel=1e-15)


def test_printed_interval_is_one_interval_for_every_cost():
    found = printed_interval(question(d=2, mu="1/2", M=1, beta="1/10", c3="1/5"))
    assert found.value == [0.0, pytest.approx(1 / 48, rel=1e-15)]
    assert "never occurs" in found.notes[1]


def test_printed_interval_is_cut_only_for_constants_of_no_cost():
    found = printed_interval(question(d=1, mu=3, M=1, beta=1))
    root = sqrt(3)
    first, second = [0, (3 - root) / 6], [(3 + root) / 6, 1]
    assert found.value[0] == pytest.approx(first, rel=1e-15)
    assert found.value[1] == pytest.approx(second, rel=1e-15)
    assert any("no cost" in note for note in found.notes)


def test_a_double_root_leaves_out_one_point():
    found = printed_interval(question(d=1, mu=3, M=1, c3="1/2", beta=1))  # mu^2 = 2 gamma
    third = pytest.approx(1 / 3, rel=1e-15)
    assert found.value == [[0, third], [third, pytest.approx(2 / 3, rel=1e-15)]]


@pytest.mark.parametrize(
    "name, bad",
    [
        *(("mu", x) for x in ("0", "-1")),
        *(("d", x) for x in ("0", "1.5", "-2")),
        *(("k", x) for x in ("0", "2.5")),
        *((name, "0") for name in ("alpha", "beta", "M")),
        *((name, "-1/10") for name in ("delta", "c2", "c3", "c4", "c_v2")),
        ("M", "1/2"),
    ],
)
def test_bounds_refuse_numbers_out_of_range(name, bad):
    given_ = question(d=1, mu=1, M=1, alpha="0.1", beta=1, delta="0.5")
    for bound in (printed_bound, corrected_bound):
        with pytest.raises(InputError) as raised:
            bound({**given_, name: Fraction(bad)})
        assert raised.value.name == name


@pytest.mark.parametrize("name, bad", [("mu", "0"), ("d", "1.5"), ("beta", "0"), ("c3", "-1")])
def test_interval_refuses_numbers_out_of_range(name, bad):
    with pytest.raises(InputError) as raised:
        printed_interval({**question(d=1, mu=1, M=1, beta=1), name: Fraction(bad)})
    assert raised.value.name == name
