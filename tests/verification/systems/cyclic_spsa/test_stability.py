"""Step limits of cyclic SPSA beside independent roads: eigenvalues over all signs, closed forms."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.strategies import definite_matrices, rationals
from verification.certificates import check
from verification.certificates.make import statements
from verification.systems.cyclic_spsa.stability import step_limit

ZERO = ((Fraction(0),),)


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


@pytest.mark.parametrize("size", [13, 18])
def test_larger_full_hessians_are_certified(size):
    rng = np.random.default_rng(0)
    a, b = rng.integers(-9, 10, (2, size, size))
    hessian = tuple(
        tuple(Fraction(int(x), 50) for x in row) for row in a @ a.T + 9 * np.eye(size, dtype=int)
    )
    noise = tuple(tuple(Fraction(int(x), 99) for x in row) for row in b @ b.T)
    answer = step_limit(block(H=hessian, Xi=noise))
    assert answer.upper - answer.lower <= 1.1e-12 * answer.value
