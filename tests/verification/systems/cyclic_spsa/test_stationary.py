"""Stationary moments: the algorithm itself, linear systems, closed forms, published numbers."""

import json
from fractions import Fraction
from math import sqrt

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from tests.verification.systems.cyclic_spsa.literal import settled
from verification.certificates import check
from verification.certificates.make import statements
from verification.inputs import read_inputs
from verification.systems.cyclic_spsa.errors.stationary import (
    MEAN_SQUARE,
    stationary_mean,
    stationary_mse,
)
from verification.systems.cyclic_spsa.printed.bounds import corrected_bound, printed_bound
from verification.systems.cyclic_spsa.stability.steps import step_limit


def question(**given_):
    """Values of `stationary_mse`, the rest by default."""
    texts = {name: _text(x) for name, x in given_.items()}
    return read_inputs(MEAN_SQUARE, texts, None, "cyclic_spsa.stationary_mse").values


def _text(x):
    if isinstance(x, (list, tuple)):
        return [_text(entry) for entry in x]
    return x if isinstance(x, str) else str(Fraction(x))


def mse(**given_):
    return stationary_mse(question(**given_), certified=False).value


FULL = [["2", "0.5"], ["0.5", "1"]]
NOISE = [["0.3", "0.1"], ["0.1", "0.2"]]
SHARED = {"beta": "0.8", "alpha": "0.15", "eta": ["0.1", "-0.2"]}


def floats(rows):
    return [[float(Fraction(x)) for x in row] for row in rows]


@pytest.mark.parametrize("law", ["gaussian", "two_point"])
@pytest.mark.parametrize("reading", ["one", "two"])
@pytest.mark.parametrize("hessian", [FULL, [["2", "0"], ["0", "1"]]], ids=["full", "diagonal"])
def test_moments_are_where_the_algorithm_settles(hessian, reading, law):
    k = 1 if reading == "one" else 2
    given_ = {**SHARED, "H": hessian, "Xi": NOISE, "reading": reading, "law": law, "k": k}
    instants = {"one": 1, "two": 2}[reading]
    mean, square = settled(floats(hessian), floats(NOISE), [0.1, -0.2], 0.8, 0.15, k, law, instants)
    assert mse(**given_) == pytest.approx(square, rel=1e-9)
    assert stationary_mean(question(**given_)).value == pytest.approx(mean, rel=1e-9)


def test_three_full_coordinates_settle_there_too():
    hessian = [["2", "0.5", "0.1"], ["0.5", "1", "-0.3"], ["0.1", "-0.3", "1.5"]]
    noise = [["0.5", "0.2", "0"], ["0.2", "0.4", "0.1"], ["0", "0.1", "0.3"]]
    given_ = {"H": hessian, "Xi": noise, "beta": "1", "alpha": "0.1", "eta": ["0.1", "0", "0.2"]}
    _, square = settled(floats(hessian), floats(noise), [0.1, 0, 0.2], 1.0, 0.1, 1, "two_point")
    assert mse(**given_, law="two_point") == pytest.approx(square, rel=1e-9)


@pytest.mark.parametrize("law", ["gaussian", "two_point"])
def test_one_coordinate_settles_there_too(law):
    given_ = {"h": ["1.5"], "Xi": [["0.4"]], "beta": "0.7", "alpha": "0.2", "eta": ["0.3"], "k": 3}
    mean, square = settled([[1.5]], [[0.4]], [0.3], 0.7, 0.2, 3, law)
    assert mse(**given_, law=law) == pytest.approx(square, rel=1e-10)
    assert stationary_mean(question(**given_)).value == pytest.approx(mean, rel=1e-10)


def dense(hessian, noise, eta, beta, alpha, k, instants):
    """The second moment from the D^2 by D^2 system, Gaussian noise, all in doubles."""
    h, x, drift = (np.array(part, dtype=float) for part in (hessian, noise, eta))
    d, c = len(h), 2 * k * drift
    two = instants == 2
    n = (x / (2 * beta**2) + np.outer(drift, drift) / (4 * beta**2)) * two
    z = x / instants
    one, flat = np.eye(d), np.eye(d).ravel()

    def kick(q):
        return (np.trace(q) + np.trace(q @ n)) * one + 2 * (q - np.diag(np.diag(q)))

    columns = []
    for basis in np.eye(d * d).reshape(d * d, d, d):
        image = basis - alpha * (h @ basis + basis @ h) + alpha**2 * kick(h @ basis @ h)
        columns.append((basis - image).ravel())
    mean = -np.linalg.solve(h, c) / alpha
    cross = np.outer(mean, c)
    side = -cross - cross.T - np.outer(c, c) + alpha**2 * kick(h @ z @ h)
    moment = np.linalg.solve(np.array(columns).T, side.ravel())
    shift = c - drift / 2 if two else c
    return moment @ flat + 2 * shift @ mean + shift @ shift


@pytest.mark.parametrize("d", [4, 13, 20])
@pytest.mark.parametrize("reading", ["one", "two"])
def test_large_blocks_agree_with_the_dense_linear_system(d, reading):
    rng = np.random.default_rng(d)
    half, other = rng.integers(-5, 6, (2, d, 2 * d))
    hessian, noise, eta = half @ half.T, other @ other.T, rng.integers(-3, 4, d)
    alpha = Fraction(1, int(6 * np.trace(hessian)))
    found = stationary_mse(
        question(
            **{"H": hessian.tolist(), "Xi": noise.tolist(), "eta": eta.tolist()},
            **{"beta": 40, "alpha": alpha, "reading": reading, "k": 2},
        )
    )
    wanted = dense(hessian, noise, eta, 40.0, float(alpha), 2, {"one": 1, "two": 2}[reading])
    assert found.value == pytest.approx(wanted, rel=1e-9)
    assert found.lower <= found.value <= found.upper
    assert found.upper - found.lower <= 1e-15 * found.value


def closed_form(h, xi, eta, beta, alpha, k, instants):
    """Diagonal Hessian, Gaussian noise: entry by entry."""
    d, c = len(h), [2 * k * x for x in eta]
    index = range(d)
    n = [
        [(instants - 1) * (2 * xi[i][j] + eta[i] * eta[j]) / (4 * beta**2) for j in index]
        for i in index
    ]
    z = [[xi[i][j] / instants for j in index] for i in index]
    off = [[Fraction(0)] * d for _ in index]
    for i in index:
        for j in index:
            if i != j:
                drift = c[i] * c[j] * (1 / (alpha * h[i]) + 1 / (alpha * h[j]) - 1)
                noise = 2 * alpha**2 * h[i] * h[j] * z[i][j]
                pull = alpha * (h[i] + h[j]) - 2 * alpha**2 * h[i] * h[j]
                off[i][j] = (drift + noise) / pull
    own = [c[i] ** 2 / (alpha * h[i]) ** 2 - c[i] ** 2 / (2 * alpha * h[i]) for i in index]
    s = sum(h[i] ** 2 * ((1 + n[i][i]) * own[i] + z[i][i]) for i in index)
    s += sum(h[i] * h[j] * n[i][j] * (off[i][j] + z[i][j]) for i in index for j in index if i != j)
    s += sum(h[i] ** 2 * n[i][i] * z[i][i] for i in index)
    s /= 1 - alpha / 2 * sum(h[i] * (1 + n[i][i]) for i in index)
    total = sum(own[i] + alpha * s / (2 * h[i]) for i in index)
    shift = [c[i] - Fraction(instants - 1, 2) * eta[i] for i in index]
    return total + sum(w * w - 2 * w * c[i] / (alpha * h[i]) for i, w in enumerate(shift))


PARTS = st.fractions(Fraction(1, 10), Fraction(3), max_denominator=10)
DRIFTS = st.fractions(Fraction(-1), Fraction(1), max_denominator=10)


@st.composite
def diagonal_blocks(draw):
    """Diagonal Hessians with a step that is some part of its limit."""
    d = draw(st.integers(1, 5))
    h, eta = (draw(st.lists(part, min_size=d, max_size=d)) for part in (PARTS, DRIFTS))
    half = [draw(st.lists(DRIFTS, min_size=d, max_size=d)) for _ in range(d)]
    xi = [[sum(a * b for a, b in zip(x, y, strict=True)) for y in half] for x in half]
    beta, k = draw(PARTS), draw(st.integers(1, 3))
    instants = draw(st.sampled_from((1, 2)))
    factor = Fraction(instants - 1) / (4 * beta**2)
    share = sum(h[i] * (1 + factor * (2 * xi[i][i] + eta[i] ** 2)) for i in range(d))
    alpha = draw(st.fractions(Fraction(1, 50), Fraction(49, 50), max_denominator=50)) * 2 / share
    return {"h": h, "Xi": xi, "eta": eta, "beta": beta, "alpha": alpha, "k": k}, instants


@settings(max_examples=60, deadline=None)
@given(diagonal_blocks())
def test_diagonal_hessians_have_the_closed_form(block):
    given_, instants = block
    values = question(**given_, reading={1: "one", 2: "two"}[instants])
    found = stationary_mse(values, certified=False)
    data = {"xi" if name == "Xi" else name: x for name, x in given_.items()}
    wanted = closed_form(**data, instants=instants)
    assert found.value == float(wanted)
    assert found.exact is None or Fraction(found.exact["value"]) == wanted


@pytest.mark.parametrize(
    "numbers, error",
    [
        # d, alpha, beta, variance a coordinate, drift (of length delta): root-mean-square error
        ((1, "0.05", 1, "0.25", 0), 0.060145),
        ((2, "0.02", 1, 1, 0), 0.175863),
        ((12, "0.002", 1, 1, 0), 0.331632),
        ((1, "0.05", 1, 0, 1), 38.633827),
        ((1, "0.01", 1, 0, 1), 198.626697),
        ((2, "0.05", "0.03", "0.0338", 0), 1.734416),
    ],
)
def test_isotropic_blocks_have_the_values_of_an_earlier_computation(numbers, error):
    d, alpha, beta, variance, delta = numbers
    eta = [delta] + [0] * (d - 1)
    found = mse(h=[1] * d, alpha=alpha, beta=beta, Xi=variance, eta=eta)
    assert sqrt(found) == pytest.approx(error, rel=1e-5)


def test_two_drifting_blocks_have_the_values_of_an_earlier_computation():
    given_ = {"h": [1, 1], "Xi": "0.01", "beta": 1, "eta": ["0.1", 0]}
    assert sqrt(mse(**given_, alpha="0.01")) == pytest.approx(19.901588, rel=1e-7)
    assert sqrt(mse(**given_, alpha="0.001")) == pytest.approx(199.900833, rel=1e-8)


def test_static_isotropic_errors_have_their_closed_forms():
    d, variance, alpha, h, beta = 3, Fraction(1, 2), Fraction(1, 20), 1, 2
    x = alpha * h * d * (1 + variance / (2 * beta**2))
    given_ = {"h": [h] * d, "Xi": variance, "beta": beta, "alpha": alpha}
    assert mse(**given_) == float(d * x * variance / (2 * (2 - x)))
    y = alpha * h * d
    assert mse(**given_, reading="one") == float(y * d * variance / (2 - y))


def test_length_and_cost_units_do_not_matter():
    base = {"H": FULL, "Xi": NOISE, "beta": "0.8", "alpha": "0.15", "eta": ["0.1", "-0.2"], "k": 2}
    tall = {
        **base,
        "H": [[Fraction(x) * 49 for x in row] for row in FULL],
        "alpha": Fraction("0.15") / 49,
        "Xi": [[Fraction(x) * 10**60 for x in row] for row in NOISE],
        "beta": Fraction("0.8") * 10**30,
        "eta": [Fraction(x) * 10**30 for x in base["eta"]],
    }
    assert mse(**tall) == pytest.approx(1e60 * mse(**base), rel=1e-14)


def test_error_grows_without_limit_towards_the_limit_and_is_infinite_there():
    given_ = {"h": [1, 1, 1, 1], "beta": 1, "Xi": "0.1"}
    limit = Fraction(2) / (4 * (1 + Fraction(1, 20)))
    close = [mse(**given_, alpha=limit * (1 - Fraction(1, 10**n))) for n in (3, 6)]
    assert 1 < close[0] < close[1] / 999
    assert mse(**given_, alpha=limit) == "inf"
    assert mse(**given_, alpha=limit + Fraction(1, 10**30)) == "inf"


@pytest.mark.parametrize("d", [1, 3])
def test_error_is_finite_below_the_certified_limit_only(d):
    rng = np.random.default_rng(d)
    half = rng.integers(-5, 6, (d, 2 * d))
    given_ = {
        "H": (half @ half.T + np.eye(d, dtype=int)).tolist(),
        "beta": 2,
        "Xi": 1,
        "eta": [1] * d,
    }
    values = question(**given_, alpha=1)
    limit = step_limit(values)
    ends_ = (Fraction(limit.lower) * (1 - Fraction(1, 10**6)), Fraction(limit.upper))
    below, above = (mse(**given_, alpha=x) for x in (ends_[0], ends_[1] * Fraction("1.000001")))
    assert float(below) > 0
    assert above == "inf"


def test_exact_threshold_of_a_full_hessian():
    hessian = [["1", "0.9"], ["0.9", "1"]]
    assert mse(H=hessian, beta=1, alpha="10/19") == "inf"
    assert mse(H=hessian, beta=1, alpha="0.5263", eta=[1, 1], reading="one") != "inf"


def test_mean_settles_where_the_mean_square_does_not():
    given_ = {"h": [1, 1, 1, 1], "beta": 1, "eta": [1, 0, 0, 0]}
    found = stationary_mean(question(**given_, alpha="0.6"))
    assert found.value[0] == float(Fraction(3, 2) - Fraction(2) / Fraction("0.6"))
    assert any("second moments grow" in note for note in found.notes)
    assert stationary_mean(question(**given_, alpha=2)).value == ["inf"] * 4


def test_law_of_the_noise_matters_with_two_instants_only():
    given_ = {"H": FULL, "Xi": NOISE, **SHARED}
    assert mse(**given_) > mse(**given_, law="two_point")
    one = {**given_, "reading": "one"}
    assert mse(**one) == mse(**one, law="two_point")


@pytest.mark.parametrize("hessian", [FULL, [["2", "0"], ["0", "1"]]], ids=["full", "diagonal"])
def test_certificate_bounds_the_exact_number_closely(hessian):
    answer = stationary_mse(question(H=hessian, Xi=NOISE, **SHARED, k=2))
    low, high = (Fraction(answer.certificate[end]) for end in ("lower", "upper"))
    exact = Fraction(answer.exact["value"])
    assert low < exact < high
    assert high - low < exact / 10**18
    assert answer.lower <= low <= high <= answer.upper
    check.check_document(json.loads(json.dumps(answer.certificate)), statements())


def test_certificate_of_other_bounds_is_refused():
    document = stationary_mse(question(H=FULL, Xi=NOISE, **SHARED)).certificate
    for end in ("lower", "upper"):
        middle = (Fraction(document["lower"]) + Fraction(document["upper"])) / 2
        moved = json.loads(json.dumps({**document, end: str(middle)}))
        with pytest.raises(check.Reject):
            check.check_document(moved, statements())


def test_infinite_error_has_a_certificate():
    document = stationary_mse(question(H=FULL, Xi=NOISE, **{**SHARED, "alpha": 1})).certificate
    assert (document["case"], document["lower"]) == ("INFINITE", "inf")
    check.check_document(json.loads(json.dumps(document)), statements())


@pytest.mark.parametrize(
    "more", [{"law": "two_point"}, {"H": np.eye(13, dtype=int).tolist(), "Xi": 1, "eta": 1}]
)
def test_what_has_no_certificate_says_so(more):
    answer = stationary_mse(question(**{"H": FULL, "Xi": NOISE, **SHARED, "alpha": "0.01", **more}))
    assert answer.certificate is None
    assert "without a file" in answer.notes[0]


def test_simulated_error_brackets_the_exact_one():
    rng = np.random.default_rng(7)
    h, xi, beta, alpha, k = np.array([1.0, 2.0]), 0.3, 0.9, 0.12, 2
    eta, runs, updates = np.array([0.05, -0.1]), 20_000, 150
    error = np.zeros((runs, 2))
    for _ in range(updates):
        signs = rng.choice((-1.0, 1.0), (runs, 2))
        before, later = rng.normal(0, sqrt(xi), (2, runs, 2))
        first = error - beta * signs - (2 * k - 1) * eta - before
        second = error + beta * signs - 2 * k * eta - later
        change = (h * (second**2 - first**2)).sum(axis=1) / 2
        error = error - alpha * signs * (change / (2 * beta))[:, None] - 2 * k * eta
    squares = (error**2).sum(axis=1)
    found = mse(h=[1, 2], Xi="0.3", beta="0.9", alpha="0.12", eta=["0.05", "-0.1"], k=k)
    assert abs(squares.mean() - found) < 4 * squares.std() / sqrt(runs)


@settings(max_examples=30, deadline=None)
@given(diagonal_blocks(), st.fractions(Fraction(1, 20), Fraction(19, 20), max_denominator=20))
def test_corrected_bound_holds_for_quadratics(block, part):
    given_, _ = block
    h, xi, eta, beta = (given_[name] for name in ("h", "Xi", "eta", "beta"))
    d, size = len(h), range(len(h))
    hessian, top = np.diag(np.array(h, dtype=float)), max(h)
    noise = np.array(xi, dtype=float)
    spread = Fraction(float(np.linalg.eigvalsh(noise).max())) * Fraction(1000001, 10**6)
    drift = Fraction(sqrt(sum(x * x for x in eta))) * Fraction(1000001, 10**6)
    c3 = 2 * top**2 * (2 * max(spread, Fraction(0)) + drift**2)
    product = hessian @ noise
    moved = np.array(eta, dtype=float)
    curved = moved @ hessian @ moved
    fourth = 4 * np.trace(product @ product) + 4 * moved @ product @ hessian @ moved + curved**2
    c4 = Fraction(float(fourth) / 2) * Fraction(1000001, 10**6)
    gamma = 3 * d * (top**2 * d + c3 / (8 * beta**2))
    alpha = part * min(h) / gamma
    constants = {
        **{"d": Fraction(d), "mu": min(h), "M": top, "alpha": alpha, "beta": beta},
        **{"delta": drift, "c2": sum(h[i] ** 2 * xi[i][i] for i in size), "c3": c3, "c4": c4},
        **{"c_v2": Fraction(0), "k": Fraction(1)},
    }
    exact = mse(**{**given_, "alpha": alpha, "k": 1})
    assert corrected_bound(constants).value >= sqrt(exact)


def test_printed_bound_is_below_the_error_of_a_drifting_target():
    constants = dict.fromkeys(("c2", "c3", "c4", "c_v2"), Fraction(0))
    one = dict.fromkeys(("d", "mu", "M", "beta", "delta", "k"), Fraction(1))
    bound = printed_bound({**constants, **one, "alpha": Fraction(1, 20)})
    assert bound.value == pytest.approx(9.854229, rel=1e-7)
    assert mse(h=[1], beta=1, alpha="0.05", eta=[1]) > 15 * bound.value**2


@pytest.mark.parametrize(
    "name, bad", [("alpha", "0"), ("alpha", "-1"), ("law", "cauchy"), ("beta", "0"), ("k", "1.5")]
)
def test_stationary_questions_refuse_numbers_out_of_range(name, bad):
    values = question(**{**SHARED, "H": FULL, name: bad})
    for ask in (stationary_mse, *((stationary_mean,) if name != "law" else ())):
        with pytest.raises(InputError) as raised:
            ask(values)
        assert raised.value.name == name
