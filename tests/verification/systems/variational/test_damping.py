"""The best damping and the offset behind an accelerating target, on a second road."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from tests.strategies import definite_matrices, rationals
from verification.inputs import read_inputs
from verification.systems.variational.damping import best_damping
from verification.systems.variational.moving import steady_offset
from verification.systems.variational.quantities import QUANTITIES

ONE = ((Fraction(1), Fraction(0)), (Fraction(0), Fraction(1)))
ASKED = {question.name: question for question in QUANTITIES}


def floats(rows):
    return np.array([[float(x) for x in row] for row in rows])


def modes(m, k):
    """M-orthonormal modes, ascending, first non-zero entry positive, by numpy's eigenvectors."""
    root = np.linalg.cholesky(m)
    inverse = np.linalg.inv(root)
    squares, vectors = np.linalg.eigh(inverse @ k @ inverse.T)
    found = inverse.T @ vectors
    for j in (0, 1):
        column = found[:, j]
        first = column[0] if abs(column[0]) > 1e-9 else column[1]
        found[:, j] = column * np.sign(first)
    return np.sqrt(squares), found


@settings(max_examples=80)
@given(definite_matrices(2), definite_matrices(2))
def test_every_eigenvalue_is_the_same_and_the_off_diagonal_mode_entry_is_positive(mass, pull):
    answer = best_damping({"M": mass, "K": pull})
    m, k = floats(mass), floats(pull)
    (a, b), shapes = modes(m, k)
    assume(abs(b / a - 3 - 2 * np.sqrt(2)) > 1e-6)
    if b / a > 3 + 2 * np.sqrt(2):
        assert answer.value is None
        return
    c, slowest = np.array(answer.value[0]), answer.value[1]
    assert slowest == pytest.approx(-np.sqrt(a * b))
    assert np.linalg.eigvalsh(c)[0] > 0
    inner = shapes.T @ c @ shapes
    assert inner[0, 1] >= -1e-9
    wanted = np.diag([4 * a, 4 * b]) * np.sqrt(a * b) / (a + b)
    wanted = wanted + (a - b) ** 2 / (a + b) * np.array([[0, 1], [1, 0]])
    if b - a > 1e-6:
        assert inner == pytest.approx(wanted, rel=1e-6, abs=1e-7)
    for s in (0.7, 1.9, -3.1):
        value = np.linalg.det(s * s * m + s * c + k)
        size = np.linalg.det(m) * (abs(s) + abs(slowest)) ** 4
        assert value / size == pytest.approx(
            np.linalg.det(m) * (s - slowest) ** 4 / size, abs=1e-10
        )


@pytest.mark.parametrize("last, exists", [("33", True), ("34", False)])
def test_the_frequencies_may_be_a_factor_of_almost_six_apart(last, exists):
    pull = ((Fraction(1), Fraction(0)), (Fraction(0), Fraction(last)))
    answer = best_damping({"M": ONE, "K": pull})
    assert (answer.value is not None) == exists
    assert exists == (np.sqrt(float(last)) < 3 + 2 * np.sqrt(2))


@pytest.mark.parametrize("turned", [False, True])
def test_a_mode_along_the_second_axis_keeps_the_sign_rule(turned):
    """The quicker or the slower mode is the second unit vector."""
    pull = [[Fraction(1), Fraction(0)], [Fraction(0), Fraction(9)]]
    if turned:
        pull = [[Fraction(9), Fraction(0)], [Fraction(0), Fraction(1)]]
    answer = best_damping({"M": ONE, "K": tuple(map(tuple, pull))})
    assert answer.value[0][0][1] == pytest.approx(1.0)


@pytest.mark.parametrize("power", [-300, -100, 100, 300])
def test_units_far_off_scale_the_result(power):
    """C scales with both gains; the abscissa does not, where both scale alike."""
    scale = Fraction(10) ** power
    pull = ((Fraction(1), Fraction(0)), (Fraction(0), Fraction(2)))
    plain = best_damping({"M": ONE, "K": pull}).value
    found = best_damping(
        {
            "M": tuple(tuple(scale * x for x in row) for row in ONE),
            "K": tuple(tuple(scale * x for x in row) for row in pull),
        }
    ).value
    assert found[1] == pytest.approx(plain[1])
    assert np.array(found[0]) == pytest.approx(np.array(plain[0]) * float(scale))


@pytest.mark.parametrize("name", ["M", "K"])
def test_more_than_two_coordinates_are_refused(name):
    three = [[str(int(i == j)) for j in range(3)] for i in range(3)]
    given_values = {"M": "1", "K": "1"} | {name: three}
    with pytest.raises(InputError, match=name):
        read_inputs(ASKED["best_damping"].inputs, given_values)


def test_an_indefinite_gain_is_refused():
    with pytest.raises(InputError, match="K"):
        best_damping({"M": ONE, "K": ((Fraction(1), Fraction(2)), (Fraction(2), Fraction(1)))})


@settings(max_examples=30)
@given(st.tuples(*[definite_matrices(3)] * 3), st.tuples(*[rationals(Fraction(-3), 3)] * 3))
def test_the_offset_is_the_solution_of_k_o(three, acceleration):
    gains = dict(zip("MKC", three, strict=True))
    answer = steady_offset({**gains, "h": Fraction(1, 50), "acceleration": acceleration})
    if answer.value is None:
        assert answer.verdict == "UNDECIDED"
        return
    a = np.array([float(x) for x in acceleration])
    wanted = np.linalg.solve(floats(gains["K"]), -0.01 * floats(gains["C"]) @ a)
    assert answer.value == pytest.approx(wanted, rel=1e-8, abs=1e-12)


def test_an_unstable_step_settles_nowhere():
    gains = dict.fromkeys("MKC", ((Fraction(1),),))
    answer = steady_offset({**gains, "h": Fraction(4), "acceleration": (Fraction(1),)})
    assert answer.value is None


@pytest.mark.parametrize(
    "acceleration, found", [(["1", "2"], "2 numbers"), ([], "empty"), (["nan"], "nan")]
)
def test_a_wrong_acceleration_is_refused(acceleration, found):
    eye = [["1", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]]
    given_values = {"M": eye, "K": "1", "C": "1", "h": "1/10", "acceleration": acceleration}
    with pytest.raises(InputError, match="acceleration") as error:
        read_inputs(ASKED["steady_offset"].inputs, given_values)
    assert found in str(error.value)


def test_the_vector_gives_the_size_where_the_gains_are_numbers():
    given_values = {"M": "1", "K": "1", "C": "1", "h": "1/10", "acceleration": ["1", "2"]}
    reading = read_inputs(ASKED["steady_offset"].inputs, given_values)
    assert len(reading.values["K"]) == 2
