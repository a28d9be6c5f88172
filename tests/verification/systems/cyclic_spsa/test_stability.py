"""Step limits of cyclic SPSA beside independent roads: eigenvalues over all signs, closed forms."""

from fractions import Fraction
from math import isqrt

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from tests.strategies import definite_matrices, rationals
from verification.certificates import check
from verification.certificates.make import statements
from verification.exact.evaluate import scaled
from verification.systems.cyclic_spsa.stability.radius import spectral_radius
from verification.systems.cyclic_spsa.stability.steps import decide_step, step_limit

ZERO = ((Fraction(0),),)
UNEVEN = ((Fraction(1), Fraction(1, 2)), (Fraction(1, 2), Fraction(2)))
EVEN = [(3, Fraction(1, 5), Fraction(1, 2)), (5, Fraction(1, 7), Fraction(1, 3))]
COUPLED = ((Fraction(1), Fraction(9, 10)), (Fraction(9, 10), Fraction(1)))


def block(**changes):
    """Values as the command line makes them."""
    plain = {"h": None, "H": None, "Xi": ZERO, "eta": (Fraction(0),), "beta": Fraction(1)}
    return plain | {"reading": "two", "k": Fraction(1)} | changes


def signs(size):
    """All sign vectors, as rows."""
    return 1 - 2 * ((np.arange(2**size)[:, None] >> np.arange(size)) & 1)


def radius(values, alpha):
    """Spectral radius of E M (x) M over all signs and a two-point noise with the moments of nu."""
    hessian = np.diag(values["h"]) if values["h"] else np.array(values["H"])
    hessian = hessian.astype(float)
    size, beta = len(hessian), float(values["beta"])
    spread = np.array(values["Xi"], dtype=float) * (1 if len(values["Xi"]) > 1 else np.eye(size))
    drift = np.resize(np.array(values["eta"], dtype=float), size)
    root = np.linalg.cholesky(spread + 1e-300 * np.eye(size)) * np.sqrt(2)
    total, ways = np.zeros((size**2, size**2)), signs(size)
    for delta in ways:
        for noise in ways:
            two = values["reading"] == "two"
            nu = (root @ noise + drift) / (2 * beta) if two else np.zeros(size)
            step = np.eye(size) - alpha * np.outer(delta, hessian @ (delta - nu))
            total += np.kron(step, step) / len(ways) ** 2
    return np.abs(np.linalg.eigvals(total)).max()


def blocks(size):
    return st.builds(
        lambda h, xi, eta, beta, reading: block(H=h, Xi=xi, eta=eta, beta=beta, reading=reading),
        definite_matrices(size),
        definite_matrices(size),
        st.tuples(*[rationals(Fraction(-1), 1)] * size),
        rationals(Fraction(1, 2), 2),
        st.sampled_from(["one", "two"]),
    )


@settings(max_examples=12)
@given(st.integers(1, 3).flatmap(blocks))
def test_the_limit_parts_stable_from_unstable_steps(values):
    answer = step_limit(values)
    assert answer.verdict == "PROVED"
    assert answer.lower <= answer.value <= answer.upper
    assert answer.upper - answer.lower <= 1e-12 * answer.upper
    assert radius(values, 0.999 * answer.lower) < 1
    assert radius(values, 1.001 * answer.upper) > 1
    entry = check.check_document(answer.certificate, statements())
    assert Fraction(entry["lower"]) <= Fraction(answer.value)


def test_the_limit_of_four_equal_coordinates_is_one_half():
    answer = step_limit(block(h=(Fraction(1),) * 4))
    assert answer.exact == {"kind": "rational", "value": "1/2"}
    assert (answer.value, answer.upper) == (0.5, 0.5)


def test_errors_on_a_line_set_the_limit_of_two_coupled_coordinates():
    rows = ((Fraction(1), Fraction(9, 10)), (Fraction(9, 10), Fraction(1)))
    answer = step_limit(block(H=rows))
    assert answer.exact == {"kind": "rational", "value": "10/19"}
    assert answer.certificate["case"] == "PROVED line"


def random_block(size, seed=0):
    rng = np.random.default_rng(seed)
    a, b = rng.integers(-9, 10, (2, size, size))
    full = a @ a.T + 9 * np.eye(size, dtype=int)
    hessian = tuple(tuple(Fraction(int(x), 50) for x in row) for row in full)
    noise = tuple(tuple(Fraction(int(x), 99) for x in row) for row in b @ b.T)
    return block(H=hessian, Xi=noise)


@pytest.mark.parametrize("size", [13, 18])
def test_larger_full_hessians_are_certified(size):
    answer = step_limit(random_block(size))
    assert answer.upper - answer.lower <= 1.1e-12 * answer.value
    assert answer.exact is None


def graded(size, gap):
    """A full Hessian whose coordinates have units that differ, with singular noise."""
    values = random_block(size, seed=1)
    units = [Fraction(10) ** (gap * i // size) for i in range(size)]
    rows = zip(values["H"], units, strict=True)
    hessian = tuple(tuple(x * a * b for x, b in zip(row, units, strict=True)) for row, a in rows)
    noise = tuple(
        tuple(Fraction(10**8 * (-1) ** (i + j)) for j in range(size)) for i in range(size)
    )
    return values | {"H": hessian, "Xi": noise}


@pytest.mark.parametrize("size", [6, 17])
def test_ill_scaled_hessians_take_more_bits(size):
    answer = step_limit(graded(size, 6))
    assert answer.verdict == "PROVED"
    assert answer.upper - answer.lower <= 1e-10 * answer.value


def closed(values):
    """2 / sum of h (1 + N_ii), in the reading's N."""
    size, two = len(values["h"]), values["reading"] == "two"
    spread = [values["Xi"][i % len(values["Xi"])][i % len(values["Xi"])] for i in range(size)]
    drift = [values["eta"][i % len(values["eta"])] for i in range(size)]
    extra = [
        (2 * x + e * e) / (4 * values["beta"] ** 2) for x, e in zip(spread, drift, strict=True)
    ]
    return 2 / sum(h * (1 + two * n) for h, n in zip(values["h"], extra, strict=True))


DIAGONAL = st.integers(1, 4).flatmap(
    lambda size: st.builds(
        lambda h, xi, eta, beta, reading: block(h=h, Xi=xi, eta=eta, beta=beta, reading=reading),
        st.tuples(*[rationals(Fraction(1, 9), 5)] * size),
        definite_matrices(size),
        st.tuples(*[rationals(-2, 2)] * size),
        rationals(Fraction(1, 3), 2),
        st.sampled_from(["one", "two"]),
    )
)


@settings(max_examples=8)
@given(DIAGONAL)
def test_a_diagonal_hessian_has_a_closed_form(values):
    limit, hair = closed(values), Fraction(1, 10**40)
    answer = step_limit(values)
    assert answer.exact == {"kind": "rational", "value": str(limit)}
    for alpha, verdict in ((limit - hair, "PROVED"), (limit, "REFUTED"), (limit + hair, "REFUTED")):
        decided = decide_step(values | {"alpha": alpha})
        assert decided.verdict == verdict
        assert decided.certificate["verdict"] == verdict
        assert abs(decided.margin) < 1e-15


@settings(max_examples=8)
@given(blocks(2), st.sampled_from([Fraction(1, 1000), Fraction(2**40), Fraction(10**9, 7)]))
def test_the_unit_of_length_does_not_matter(values, unit):
    other = values | {
        "Xi": scaled(unit**2, values["Xi"]),
        "eta": tuple(unit * x for x in values["eta"]),
        "beta": unit * values["beta"],
    }
    assert step_limit(other).exact == step_limit(values).exact


@settings(max_examples=8)
@given(blocks(2), rationals(Fraction(1, 7), 9))
def test_a_larger_cost_asks_for_a_smaller_step(values, factor):
    other = values | {"H": scaled(factor, values["H"])}
    assert step_limit(other).value == pytest.approx(step_limit(values).value / float(factor))


def test_steps_just_beside_an_irrational_limit_are_decided_apart():
    values = block(H=UNEVEN, Xi=((Fraction(1, 10),),))
    limit = step_limit(values)
    assert limit.exact["kind"] == "algebraic"
    root = min(np.roots(limit.exact["polynomial"][::-1]))
    assert root == pytest.approx(limit.value, rel=1e-12)
    for alpha in (Fraction(limit.lower), Fraction(limit.upper)):
        verdict = decide_step(values | {"alpha": alpha}).verdict
        assert verdict == ("PROVED" if alpha == Fraction(limit.lower) else "REFUTED")


def test_a_step_between_two_doubles_is_decided():
    """The limit is (3 - sqrt 3)/6; a continued fraction gives steps on both sides of it."""
    rows = tuple(tuple(Fraction(2 if i == j else 1) for j in range(3)) for i in range(3))
    values, root = block(H=rows), Fraction(0)
    verdicts = []
    for places in (25, 45):
        root = Fraction(isqrt(3 * 10 ** (2 * places)), 10**places)
        low, high = ((3 - root - Fraction(1, 10**places)) / 6, (3 - root) / 6)
        verdicts += [decide_step(values | {"alpha": a}).verdict for a in (low, high)]
    assert verdicts == ["PROVED", "REFUTED"] * 2
    assert step_limit(values).exact["polynomial"] == [1, -6, 6]


def even(size, coupling):
    """I + c J: the same for every coordinate."""
    return tuple(tuple(coupling + (i == j) for j in range(size)) for i in range(size))


@pytest.mark.parametrize("size,coupling,limit", EVEN)
def test_a_rational_limit_of_a_full_hessian_is_kept_exactly(size, coupling, limit):
    values = block(H=even(size, coupling))
    assert decide_step(values | {"alpha": limit}).certificate["case"] == "REFUTED exact"
    assert decide_step(values | {"alpha": limit - Fraction(1, 10**30)}).verdict == "PROVED"
    assert decide_step(values | {"alpha": limit + Fraction(1, 10**30)}).verdict == "REFUTED"
    assert step_limit(values).value == pytest.approx(float(limit), rel=1e-15)


def test_errors_on_a_line_are_kept_at_and_above_the_limit():
    values = block(H=COUPLED)
    for alpha, verdict in (("10/19", "REFUTED"), ("3", "REFUTED"), ("9/19", "PROVED")):
        decided = decide_step(values | {"alpha": Fraction(alpha)})
        assert decided.verdict == verdict
    across = ((Fraction(1), Fraction(-1)), (Fraction(-1), Fraction(1)))
    noisy = [step_limit(values | {"Xi": scaled(size, across)}) for size in (Fraction(1, 3), 300)]
    assert [answer.certificate["case"] for answer in noisy] == ["PROVED line", "PROVED exact"]
    assert noisy[1].value < noisy[0].value == 10 / 19
    quiet = block(H=((COUPLED[0][0], -COUPLED[0][1]), (-COUPLED[0][1], COUPLED[0][0])))
    assert step_limit(quiet).exact == {"kind": "rational", "value": "10/19"}


def test_the_verdict_may_depend_on_the_reading():
    values = block(h=(Fraction(1),) * 4, Xi=((Fraction(1),),))
    two = decide_step(values | {"alpha": Fraction(2, 5)})
    one = decide_step(values | {"alpha": Fraction(2, 5), "reading": "one"})
    assert (two.verdict, one.verdict) == ("REFUTED", "PROVED")
    assert any("the verdict depends on the reading" in note for note in two.notes)
    assert any("the verdict depends on the reading" in note for note in one.notes)
    assert two.more["other_reading"]().data["value"] == 0.5
    limit = step_limit(values)
    assert any("the limit depends on the reading" in note for note in limit.notes)
    assert not step_limit(block(h=(Fraction(1),))).notes


@pytest.mark.parametrize("rank", [0, 1, 2, 3])
def test_noise_of_every_rank_is_shown_to_be_a_covariance(rank):
    rows = np.arange(1, 10).reshape(3, 3)[:, :rank] ** 2
    noise = tuple(tuple(Fraction(int(x), 7) for x in row) for row in rows @ rows.T)
    made = step_limit(block(h=(Fraction(1), Fraction(2), Fraction(3)), Xi=noise)).certificate
    assert check.check_document(made, statements())["verdict"] == "PROVED"
    assert [len(row) for row in made["witness"][-4]["rows"]] == [max(rank, 1)] * 3


def test_planted_errors_are_refused():
    values = block(H=UNEVEN, Xi=((Fraction(1, 10),),))
    made = step_limit(values).certificate
    check.check_document(made, statements())
    for change in (
        {"inputs": made["inputs"] | {"reading": "3"}},
        {"inputs": made["inputs"] | {"beta": "0"}},
        {"inputs": made["inputs"] | {"beta": "99/100"}},
        {"inputs": made["inputs"] | {"reading": "1"}},
        {"inputs": made["inputs"] | {"Xi": [["1/10", "0"], ["0", "-1/10"]]}},
        {"lower": made["upper"]},
        {"upper": made["lower"]},
        {"case": "PROVED exact"},
    ):
        with pytest.raises(check.Reject):
            check.check_document(made | change, statements())


@pytest.mark.parametrize("alpha", [Fraction(0), Fraction(-1)])
@pytest.mark.parametrize("question", [decide_step, spectral_radius])
def test_a_step_that_is_not_positive_is_refused(question, alpha):
    with pytest.raises(InputError, match=r"^alpha: "):
        question(block(h=(Fraction(1),)) | {"alpha": alpha})


def test_a_hessian_that_is_not_definite_is_refused():
    with pytest.raises(InputError, match=r"^h: "):
        step_limit(block(h=(Fraction(1), Fraction(-1))))


@settings(max_examples=12)
@given(st.integers(1, 3).flatmap(blocks), rationals(Fraction(1, 20), 2))
def test_the_multiplier_is_the_radius_over_all_draws(values, alpha):
    answer = spectral_radius(values | {"alpha": alpha})
    assert answer.verdict == "PROVED"
    assert answer.lower <= answer.value <= answer.upper
    assert answer.upper - answer.lower <= 1e-9 * answer.upper
    assert answer.value == pytest.approx(radius(values, float(alpha)), rel=1e-7)
    assert (answer.upper < 1) == (alpha < Fraction(step_limit(values).lower))


@pytest.mark.parametrize("size", [7, 17])
def test_the_multiplier_of_a_larger_block_is_one_at_the_limit(size):
    values = random_block(size)
    limit = step_limit(values)
    below, above = (
        spectral_radius(values | {"alpha": Fraction(end) * (1 + side * Fraction(1, 10**9))})
        for side, end in ((-1, limit.lower), (1, limit.upper))
    )
    assert below.upper < 1 < above.lower
    assert above.upper - below.lower < 1e-7


def test_a_step_inside_the_bracket_of_a_large_block_is_decided():
    values = random_block(17)
    limit = step_limit(values)
    inside = [Fraction(limit.lower) + Fraction(limit.upper - limit.lower) * k / 5 for k in (1, 4)]
    verdicts = [decide_step(values | {"alpha": alpha}).verdict for alpha in inside]
    assert verdicts == ["PROVED", "REFUTED"]
