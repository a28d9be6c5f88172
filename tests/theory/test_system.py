"""A system checks itself when it is made, and its digest moves with its mathematics."""

import os
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace

import pytest

from tests.theory.test_claims import CLAIM
from theory.kinds import FormulaError
from theory.system import Guard, Law, Parameter, Signal, System
from theory.systems import SYSTEMS

X = Signal("x", ("n",), "m", "sensors", "where it is")
V = Signal("v", ("n",), "m/s", "sensors", "how fast it is")
M = Parameter("M", ("n", "n"), "kg", "symmetric positive definite", "how heavy it is")
K = Parameter("k", (), "kg/s^2", "positive", "how stiff it is")
MOTION = Law("d(x)", "v", "(1)")
FORCE = Law("M*d(v)", "-k*x", "(2)")
FAR = Guard("far", "norm(x) > 0", "it has arrived")

SYSTEM = System(
    name="pendulum",
    title="A pendulum",
    citation="Someone: Pendulums",
    signals=(X, V),
    parameters=(M, K),
    laws=(MOTION, FORCE),
    guards=(FAR,),
    claims=(CLAIM,),
    dimensions={"n": "number of pendulums"},
)


@pytest.mark.parametrize(
    "make, what",
    [
        (lambda: replace(SYSTEM, laws=(MOTION,)), "unused symbols M, k"),
        (lambda: replace(SYSTEM, signals=(X, V, replace(X, name="y"))), "unused symbols y"),
        (lambda: replace(SYSTEM, signals=(X, V, X)), "symbol x stands twice"),
        (lambda: replace(SYSTEM, signals=(X, replace(V, name="k"))), "symbol k stands twice"),
        (lambda: replace(SYSTEM, parameters=(M,)), "k is not declared"),
        (lambda: replace(SYSTEM, signals=(X, replace(V, unit="m"))), "one unit is needed"),
        (lambda: replace(SYSTEM, signals=(X, replace(V, unit="mm"))), "'mm'"),
        (lambda: replace(SYSTEM, signals=(X, replace(V, shape=(3,)))), "one unit is needed"),
        (lambda: replace(SYSTEM, parameters=(replace(M, shape=(2, 2)), K)), "inner sizes"),
        (lambda: replace(SYSTEM, laws=(MOTION, FORCE, Law("x", "v", "(3)"))), r"\(3\).*one unit"),
        (lambda: replace(SYSTEM, laws=(MOTION, FORCE, Law("x", "M", "(3)"))), r"\(3\)"),
        (lambda: replace(SYSTEM, guards=(replace(FAR, condition="norm(x) > k"),)), "far.*one unit"),
        (lambda: replace(SYSTEM, guards=(replace(FAR, condition="norm(x)"),)), "comparison"),
        (lambda: replace(SYSTEM, guards=(FAR, FAR)), "guard far stands twice"),
        (lambda: replace(SYSTEM, claims=(CLAIM, CLAIM)), "claim pendulum.theorem_1_gain"),
        (lambda: replace(SYSTEM, name="clock"), "belongs to pendulum"),
        (lambda: replace(SYSTEM, name="a clock"), "identifier"),
        (lambda: replace(SYSTEM, dimensions={}), "dimension n is not declared"),
        (lambda: replace(SYSTEM, dimensions={"n": "a", "m": "b"}), "unused dimensions or units m"),
        (lambda: replace(SYSTEM, units={"c": "something"}), "unused dimensions or units c"),
        (lambda: replace(SYSTEM, dimensions={"n": "a", "x": "b"}), "symbol x stands twice"),
        (lambda: replace(X, name="x y"), "identifier"),
        (lambda: replace(X, shape=(0,)), "shape"),
        (lambda: replace(X, shape=("n m",)), "shape"),
        (lambda: replace(X, shape=(2, 2, 2)), "shape"),
        (lambda: replace(X, shape=[3]), "shape"),
        (lambda: replace(X, shape=(True,)), "shape"),
        (lambda: replace(X, frame="moon"), "frame"),
        (lambda: replace(X, meaning=" "), "meaning"),
        (lambda: replace(K, domain="large"), "domain"),
        (lambda: replace(FAR, name="far away"), "identifier"),
        (lambda: replace(FAR, meaning=""), "meaning"),
        (lambda: Guard("odd", "norm(x) >", "nothing"), "formula"),
        (lambda: Law("next(x)", "d(x)", "(3)"), "continuous and discrete"),
        (lambda: Law("x +", "v", "(3)"), "formula"),
    ],
)
def test_what_is_wrong_is_an_error_at_birth(make: Callable[[], object], what: str) -> None:
    with pytest.raises(ValueError, match=what):
        make()


def test_one_assumption_has_one_text_in_all_claims() -> None:
    other = replace(
        CLAIM,
        id="pendulum.theorem_2",
        assumes=(replace(CLAIM.assumes[0], text="another text"),),
    )
    with pytest.raises(ValueError, match="A1 has two texts"):
        replace(SYSTEM, claims=(CLAIM, other))


def test_unit_errors_say_where() -> None:
    with pytest.raises(FormulaError, match=r"pendulum, \(2\): n by 1 in kg m/s\^2 and n by 1 in"):
        replace(SYSTEM, laws=(MOTION, Law("M*d(v)", "-k*v", "(2)")))


def test_laws_are_found_by_number() -> None:
    assert SYSTEM.law("(1)") is MOTION
    with pytest.raises(KeyError, match="0 laws"):
        SYSTEM.law("(9)")


MATHEMATICS = {
    "law": replace(SYSTEM, laws=(MOTION, Law("M*d(v)", "-2*k*x", "(2)"))),
    "number of a law": replace(SYSTEM, laws=(MOTION, replace(FORCE, equation="(3)"))),
    "unit": replace(SYSTEM, parameters=(replace(M, unit="1"), replace(K, unit="1/s^2"))),
    "domain": replace(SYSTEM, parameters=(M, replace(K, domain="nonnegative"))),
    "frame": replace(SYSTEM, signals=(replace(X, frame="inertial"), V)),
    "guard": replace(SYSTEM, guards=(replace(FAR, condition="norm(x) >= 0"),)),
    "no guard": replace(SYSTEM, guards=()),
    "formula": replace(SYSTEM, claims=(replace(CLAIM, formula="k > 1"),)),
    "sense": replace(SYSTEM, claims=(replace(CLAIM, sense="upper"),)),
    "printed": replace(SYSTEM, claims=(replace(CLAIM, printed="k > 1"),)),
    "no claim": replace(SYSTEM, claims=()),
    "shape": replace(
        SYSTEM,
        signals=(replace(X, shape=(2,)), replace(V, shape=(2,))),
        parameters=(replace(M, shape=(2, 2)), K),
        dimensions={},
    ),
}

WORDS = {
    "title": replace(SYSTEM, title="Another title"),
    "meaning": replace(SYSTEM, signals=(replace(X, meaning="somewhere"), V)),
    "order": replace(SYSTEM, signals=(V, X), laws=(FORCE, MOTION)),
    "blanks": replace(SYSTEM, laws=(MOTION, Law(" M * d( v )", "- k * x", "(2)"))),
    "unit written otherwise": replace(SYSTEM, parameters=(M, replace(K, unit="N/m"))),
    "title of a claim": replace(SYSTEM, claims=(replace(CLAIM, title="Another title"),)),
}


@pytest.mark.parametrize("change", MATHEMATICS)
def test_digest_changes_with_the_mathematics(change: str) -> None:
    assert MATHEMATICS[change].digest != SYSTEM.digest


def test_all_changes_have_their_own_digest() -> None:
    assert len({system.digest for system in MATHEMATICS.values()}) == len(MATHEMATICS)


@pytest.mark.parametrize("change", WORDS)
def test_digest_does_not_change_with_words_about_it(change: str) -> None:
    assert WORDS[change].digest == SYSTEM.digest


@pytest.mark.parametrize("seed", ["0", "1", "12345"])
def test_digest_is_the_same_in_every_process(seed: str) -> None:
    code = "from theory.systems import SYSTEMS; print(*(s.digest for s in SYSTEMS))"
    run = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        check=True,
        env={**os.environ, "PYTHONHASHSEED": seed},
    )
    assert run.stdout.split() == [system.digest for system in SYSTEMS]
