"""False statements, each with a witness that would pass if a predicate were missing.

A matrix of one entry multiplies any other as a number does; numbers may have the wrong sign; data
may have another size than the words around them say.
"""

from fractions import Fraction

import pytest

from verification.adversary.spsa_violations import Point
from verification.certificates.make import CertificateError, certificate
from verification.inputs import read_inputs
from verification.systems.cyclic_spsa.claims.theorem_2 import UNIT, constants, diverging, lagging
from verification.systems.cyclic_spsa.errors.stationary import MEAN_SQUARE, stationary_mse
from verification.systems.cyclic_spsa.printed.promises import promised, promised_2

EYE = [[1, 0], [0, 1]]
ZERO = [[0, 0], [0, 0]]
ONE = Fraction(1)
TENTH = Fraction(1, 10)


def chosen(*matrices):
    return [{"kind": "matrix", "rows": rows} for rows in matrices]


def made(name, inputs, witness=(), case="PROVED", **ends):
    return certificate("cyclic_spsa", name, inputs, witness, case, **ends)


def test_a_number_is_no_bound_on_a_trace():
    """p stands for p I in every product, and its trace is half of that."""
    asked = read_inputs(MEAN_SQUARE, {"h": ["1", "1"], "Xi": "1/10", "beta": "1", "alpha": "1/10"})
    document = stationary_mse(asked.values).certificate
    items = [item for item in document["witness"] if item["kind"] == "matrix"]
    ends = {end: Fraction(document[end]) for end in ("lower", "upper")}
    made("stationary_mse", document["inputs"], items, **ends)
    for place, end in ((7, "upper"), (9, "lower")):
        entry = items[place]["rows"][0][0]
        forged = [*items[:place], *chosen([[entry]]), *items[place + 1 :]]
        with pytest.raises(CertificateError):
            made("stationary_mse", document["inputs"], forged, **{**ends, end: Fraction(entry)})


BLOCK = {
    "h": [[1], [1]], "H": ZERO, "Xi": EYE, "eta": [[0], [0]], "beta": 1, "reading": 2, "k": 1,
    "alpha": Fraction(3, 2),
}  # fmt: skip


@pytest.mark.parametrize(
    "change",
    [
        {"Xi": [[1]], "eta": [[1]]},
        {"h": EYE},
        {"eta": EYE},
        {"eta": [[0, 0]]},
        {"h": [[1]], "H": [[0]]},
        {"Xi": [[1, 2], [2, 1]]},
        {"reading": Fraction(3, 2)},
        {"k": Fraction(1, 2)},
        {"beta": -1},
        {"alpha": -1},
    ],
)
def test_blocks_of_other_sizes_and_signs_are_refused(change):
    inputs = BLOCK | change
    size, noise = ([[1]], [[1]]) if len(inputs["H"]) == 1 else (EYE, inputs["Xi"])
    witness = chosen(size, size, size, size if len(noise) > 1 else [[1]], noise, [[1]])
    with pytest.raises(CertificateError):
        made("step", inputs, witness, "REFUTED")
    made("step", BLOCK, chosen(EYE, EYE, EYE, EYE, EYE, [[1]]), "REFUTED")


def test_a_large_block_does_not_refute_theorem_2_for_one_target():
    """Forty coordinates diverge where the two of one target do not."""
    size, alpha = 40, TENTH
    half = tuple(tuple(ONE / 2 if i == j else 0 * ONE for j in range(size)) for i in range(size))
    at = {"h": (ONE,) * size, "H": None, "Xi": half, "eta": (0 * ONE,), "beta": 1000 * ONE}
    at |= {"reading": "two", "k": ONE, "alpha": alpha}
    own = {"alpha": alpha, "beta": at["beta"]}
    with pytest.raises(CertificateError, match="trace"):
        diverging("theorem_2_interval", promised_2({**UNIT, **own, "delta": 0}), at)
    with pytest.raises(CertificateError, match="trace"):
        diverging("theorem_2_interval_nested", constants(ONE / 2, ONE, **own), at)


def test_a_negative_drift_does_not_lower_the_promise():
    point = Point(ONE / 20, ONE, -ONE, ONE, ONE)
    moments = point.moments()
    inputs = {**promised(point.constants()), "sigma": point.sigma, **vars(moments)}
    inputs |= {"error": moments.mean, "square": moments.square}
    assert moments.square > inputs["bound"] ** 2
    with pytest.raises(CertificateError, match="delta"):
        made("theorem_1_bound_found", inputs, (), "REFUTED")


def test_a_negative_variance_does_not_lower_the_promise():
    own = {"alpha": ONE / 20, "beta": 5 * ONE, "delta": ONE}
    error = Fraction(3, 2) - 40
    honest = constants(ONE, ONE, **own)
    assert -error < honest["bound"]
    forged = constants(ONE, -4 * ONE, **own)
    assert -error < forged["bound"] < honest["bound"]
    with pytest.raises(CertificateError, match=r"c2 >= 0"):
        lagging("theorem_2_bound_nested", forged, error)


NETWORK = {"G": [[1]], "h": [[1]], "s": [[1]], "e": [[1]], "beta": 1, "reading": 2}


@pytest.mark.parametrize("name", ["s", "e"])
def test_negative_squares_do_not_raise_the_limit_of_a_network(name):
    def document(inputs):
        load = 2 + Fraction(inputs["s"][0][0], 2) + Fraction(inputs["e"][0][0], 4)
        columns = ([[1]], [[load]], [[1]], [[0]], [[1]], [[1]], [[1]], [[0]])
        return made("network_step_limit", inputs, chosen(*columns), upper=2 / load)

    document(NETWORK)
    with pytest.raises(CertificateError):
        document(NETWORK | {name: [[-1]]})


COST = {"H": EYE, "Xi": EYE, "eta": [[0], [0]], "kappa": 0} | {
    "mu": 1, "M": 1, "c2": 1, "c3": 1, "c4": 0, "delta": 0,
}  # fmt: skip


@pytest.mark.parametrize(
    "change, case, vector",
    [
        ({"Xi": [[1, 0], [0, -3]], "c2": -5}, "REFUTED_c2", None),
        ({"Xi": [[1]], "eta": [[1]]}, "REFUTED_c3", [[1], [0]]),
        ({"eta": [[1]]}, "REFUTED_delta", None),
        ({"eta": [[1], [1], [1]]}, "REFUTED_delta", None),
    ],
)
def test_noise_that_is_none_refutes_no_constant(change, case, vector):
    known = chosen(vector) if vector else []
    with pytest.raises(CertificateError):
        made("assumptions", COST | change, [*known, *chosen(EYE, [[1], [1]])], case)
    made("assumptions", COST, chosen(EYE, [[1], [1]]), "REFUTED_c2")


def test_dependent_constraints_are_no_basis():
    dependent = {"I": EYE, "H": [[1, 0], [1, 0]], "N": [[0], [1]], "W": [[1]]}
    with pytest.raises(CertificateError):
        made("eq_6_reduced_formation", dependent | {"Y": [["1/2", 0], [0, "1/2"]]})


def test_other_steps_and_directions_stand_for_nothing():
    with pytest.raises(CertificateError):
        made("algorithm_1_first_cost", {"needed": 1, "known": 2}, (), "REFUTED")
    turned = {"C": [[12, -9], [16, -12]], "a": [["3/5"], ["4/5"]], "b": [["4/5"], ["-3/5"]]}
    with pytest.raises(CertificateError, match="diag"):
        made("section_3_neighbours", turned, (), "REFUTED")


def test_half_a_cycle_is_none():
    halves = {"k": "3/2", "T": 1, "S": "3/2", "u": "3/2", "v": 1}
    with pytest.raises(CertificateError, match="== 0"):
        made("algorithm_1_clock", halves, (), "REFUTED")
    with pytest.raises(CertificateError, match="== 0"):
        made("section_3_shift", {"k": "3/2", "T": 1, "u": 1, "l": 1}, (), "REFUTED")
    made("algorithm_1_clock", {"k": 2, "T": 1, "S": 2, "u": 2, "v": 1}, (), "REFUTED")
