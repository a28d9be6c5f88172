"""Numbers that are long, huge or tiny, and sizes that do not fit: an answer or a named error."""

import json
import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings

from sensortrack.errors import InputError
from tests.strategies import definite_matrices
from verification.certificates import check
from verification.cli.main import main
from verification.exact.rationals import nearest
from verification.inputs import as_text, read_inputs
from verification.systems.cyclic_spsa.block_inputs import ALPHA, BLOCK, block_of
from verification.systems.cyclic_spsa.errors import second_moments
from verification.systems.cyclic_spsa.errors.stationary import MEAN_SQUARE, stationary_mse
from verification.systems.cyclic_spsa.printed.bounds import INTERVAL, printed_interval
from verification.systems.cyclic_spsa.quantities import CONDITIONS, QUANTITIES
from verification.systems.cyclic_spsa.stability.limits import limit_of
from verification.systems.cyclic_spsa.stability.radius import spectral_radius
from verification.systems.cyclic_spsa.stability.steps import decide_step, step_limit

FULL = {"H": [[2, "1/3"], ["1/3", 1]], "Xi": "1/7", "eta": ["1/5", "1/11"], "beta": "1/2"}


def ask(name, **given_):
    question = next(entry for entry in (*QUANTITIES, *CONDITIONS) if entry.name == name)
    return question.answer(read_inputs(question.inputs, given_).values)


def limit(**given_):
    return step_limit(read_inputs(BLOCK, given_).values)


def status(capsys, *words, **given_):
    sets = [f"{name}={json.dumps(value)}" for name, value in given_.items()]
    arguments = [part for entry in sets for part in ("--set", entry)]
    code = main([*words, *arguments, "--json"])
    return code, capsys.readouterr()


# -------------------------------------------------------------------------------------- long ones


def test_an_answer_stays_when_the_checker_reads_no_certificate(monkeypatch, tmp_path, capsys):
    known = limit(**FULL)
    monkeypatch.setattr(check, "DENOMINATORS", 1)
    found = limit(**FULL)
    assert (found.value, found.lower, found.upper) == (known.value, known.lower, known.upper)
    assert found.certificate is None
    assert "without a file" in found.notes[0]
    decided = decide_step(read_inputs((*BLOCK, ALPHA), FULL | {"alpha": "1/10"}).values)
    assert decided.verdict == "PROVED"
    assert decided.certificate is None
    out = tmp_path / "limit.json"
    words = ("bound", "cyclic_spsa.step_limit", "--out", str(out))
    code, said = status(capsys, *words, **FULL)
    assert code == 3
    assert not out.exists()
    assert "no certificate was written" in said.err
    assert json.loads(said.out)["value"] == known.value
    assert status(capsys, *words[:2], **FULL)[0] == 0


def test_the_mean_square_of_long_data_is_enclosed(monkeypatch):
    rng = np.random.default_rng(5)
    root = rng.integers(-3, 4, size=(7, 7))
    hessian = [[str(Fraction(int(x), 20)) for x in row] for row in root @ root.T + 5 * np.eye(7)]
    values = read_inputs(
        MEAN_SQUARE, {"H": hessian, "Xi": "1/7", "eta": "1/9", "beta": 1, "alpha": "1/50"}
    ).values
    exact = stationary_mse(values)
    monkeypatch.setattr(second_moments, "LONGEST", 0)
    ball = stationary_mse(values)
    assert exact.exact is not None
    assert exact.certificate is not None
    assert ball.exact is None
    assert ball.certificate is None
    assert ball.verdict == "PROVED"
    assert ball.lower <= Fraction(exact.exact["value"]) <= ball.upper
    assert ball.upper - ball.lower <= 1e-12 * ball.upper


# ----------------------------------------------------------------------------- beyond the doubles


@pytest.mark.parametrize("exponent", [-320, 320, -400, 400])
@pytest.mark.parametrize("name", ["h", "H"])
def test_the_limit_goes_with_the_scale_of_the_hessian(name, exponent):
    plain = {"h": [3, 1]} if name == "h" else {"H": [[2, 1], [1, 2]]}
    scale = Fraction(10) ** exponent
    rows = plain[name]
    scaled = [[str(x * scale) for x in row] if name == "H" else str(row * scale) for row in rows]
    rest = {"Xi": "1/3", "beta": 1}
    base, far = (
        limit_of(block_of(read_inputs(BLOCK, entry | rest).values))
        for entry in (plain, {name: scaled})
    )
    assert base.lower < far.upper * scale
    assert far.lower * scale < base.upper
    assert far.upper - far.lower <= far.upper / 10**12
    found = limit(**{name: scaled}, **rest)
    assert found.value == pytest.approx(nearest((far.lower + far.upper) / 2), rel=1e-12)
    assert found.lower <= found.value <= found.upper


def test_a_step_beyond_the_doubles_is_decided(capsys):
    code, said = status(capsys, "certify", "cyclic_spsa.step", alpha="1e320", **FULL)
    found = json.loads(said.out)
    assert (code, found["verdict"], found["margin"]) == (1, "REFUTED", "-inf")


def test_the_margin_beside_the_limit_is_not_rounded_away():
    found = ask("step", h=[1] * 4, beta=1, alpha="0.49999999999999999999")
    assert found.verdict == "PROVED"
    assert found.margin == pytest.approx(1e-20)


def test_a_radius_beyond_the_doubles_is_no_fault():
    values = read_inputs((*BLOCK, ALPHA), {"h": [1, 2], "beta": 1, "alpha": "1e300"}).values
    found = spectral_radius(values)
    assert (found.value, found.upper, found.verdict) == (math.inf, math.inf, "PROVED")


def test_a_wide_bracket_is_no_value():
    found = ask("lyapunov_exponent", h=[1], beta=1, alpha="1e-120", Xi=1)
    assert found.value is None
    assert found.lower <= -1e-120 <= found.upper


# ------------------------------------------------------------------------------------------- sizes


@pytest.mark.parametrize(
    "given_, name",
    [
        ({"h": [1, 1], "Xi": [[1]]}, "Xi"),
        ({"h": [1, 1], "Xi": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}, "Xi"),
        ({"H": [[1, 0], [0, 1]], "Xi": [[1]]}, "Xi"),
        ({"h": 2, "Xi": [[1, 0], [0, 1]]}, "Xi"),
        ({"h": [1, 1], "eta": [1, 2, 3]}, "eta"),
        ({"H": [[1, 1], [1, 1]]}, "H"),
        ({"h": [1, 1], "Xi": -1}, "Xi"),
    ],
)
def test_what_does_not_fit_the_hessian_is_named(given_, name):
    with pytest.raises(InputError) as caught:
        limit(beta=1, **given_)
    assert caught.value.name == name


@pytest.mark.parametrize("other", [{"eta": [0, 0, 0]}, {"Xi": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}])
def test_a_hessian_that_is_one_number_has_the_size_of_the_rest(other):
    found, wanted = limit(H=2, beta=1, **other), limit(h=[2, 2, 2], beta=1, **other)
    assert found.exact == wanted.exact


def test_one_number_means_every_coordinate_of_noise_and_drift():
    found = limit(h=[1, 2], Xi="1/3", eta="1/5", beta=1)
    wanted = limit(h=[1, 2], Xi=[["1/3", 0], [0, "1/3"]], eta=["1/5", "1/5"], beta=1)
    assert found.exact == wanted.exact


# --------------------------------------------------------------------------------- what is printed


@settings(max_examples=10)
@given(definite_matrices(3))
def test_the_printed_step_is_the_end_of_the_printed_interval(rows):
    found = ask("step_limit", H=as_text(rows), beta=1)
    low, *_, high = np.linalg.eigvalsh(np.array(rows, dtype=float))
    given_ = {"d": 3, "mu": str(Fraction(low)), "M": str(Fraction(high)), "beta": 1}
    end = printed_interval(read_inputs(INTERVAL, given_).values).value[1]
    if found.printed is None:
        assert low < 1e-5 * high
    else:
        assert found.printed == pytest.approx(end, rel=1e-6)
        assert found.printed < found.lower


def test_no_printed_step_where_doubles_do_not_tell():
    found = ask("step_limit", H=[[1, "0.9999999999999"], ["0.9999999999999", 1]], beta=1)
    assert found.printed is None
    assert found.verdict == "PROVED"


# -------------------------------------------------------------------------------- exactly the best


@pytest.mark.parametrize("h", ["1", "3", "7/3"])
def test_one_update_may_remove_the_whole_error(h):
    found = ask("best_step", h=[h], eta="1/2", beta=1, reading="one")
    assert found.value == [float(1 / Fraction(h)), 0]
    at_it = ask(
        "stationary_mse", h=[h], eta="1/2", beta=1, reading="one", alpha=str(1 / Fraction(h))
    )
    assert at_it.value == 0
    for other in ({"reading": "two"}, {"reading": "one", "Xi": "1/9"}):
        assert ask("best_step", h=[h], eta="1/2", beta=1, **other).value[1] > 0
