"""The laws of the systems say what the derivations say."""

from collections.abc import Mapping

import pytest

from theory.algebra.noncommuting import Form, letters, scalars
from theory.expressions import Tree, parse
from theory.system import System
from theory.systems import STATEMENTS, SYSTEMS
from theory.systems.bearing_dac import SYSTEM as BEARING
from theory.systems.variational import SYSTEM as VARIATIONAL
from theory.systems.variational.statements.common import (
    PRINTED,
    SYMMETRIC,
    centred_dissipation,
    discrete_equation,
    dissipation,
    energy,
    lagrangian,
)

X, U, V = letters("x u v", SYMMETRIC)
(H,) = scalars("h")
GAINS = dict(zip(SYMMETRIC, letters(" ".join(SYMMETRIC), SYMMETRIC), strict=True))


def form_of(tree: Tree, leaves: Mapping[Tree, Form]) -> Form:
    """A law's side as a form; ``leaves`` says what names and values of other times are."""
    if tree in leaves:
        return leaves[tree]
    match tree:
        case ("number", number):
            return Form({((), ()): number}, frozenset(SYMMETRIC))
        case ("+", left, right):
            return form_of(left, leaves) + form_of(right, leaves)
        case ("-", left, right):
            return form_of(left, leaves) - form_of(right, leaves)
        case ("*", left, right):
            return form_of(left, leaves) * form_of(right, leaves)
        case ("/", left, ("number", number)):
            return form_of(left, leaves) * (1 / number)
        case ("call", "T", inner):
            return form_of(inner, leaves).T
    raise AssertionError(tree)


def leaves(**values: Form) -> dict[Tree, Form]:
    named = GAINS | {"h": H} | values
    return {("name", name): form for name, form in named.items()}


def test_printed_recursion_of_the_system_is_the_derived_one() -> None:
    """With the index of (20) lowered by one: u_k is the old velocity v, u_{k+1} the new one."""
    law = VARIATIONAL.law("(20), last line")
    known = leaves(u=V) | {parse("next(u)"): U, parse("next(x)"): X}
    sides = [form_of(parse(side), known) for side in (law.left, law.right)]
    assert not (sides[0] - sides[1] - PRINTED).terms
    assert not (sides[1] - sides[0] - discrete_equation(lagrangian, dissipation)).terms


def test_second_order_recursion_of_the_system_is_the_derived_one() -> None:
    law = VARIATIONAL.law("(20) by the trapezoidal rule")
    known = leaves(u=V) | {parse("next(u)"): U, parse("next(x)"): X}
    sides = [form_of(parse(side), known) for side in (law.left, law.right)]
    derived = discrete_equation(lagrangian, centred_dissipation)
    assert not (sides[1] - sides[0] - derived).terms


@pytest.mark.parametrize("equation, form", [("(11)", lagrangian(X, U)), ("(14)", energy(X, U))])
def test_energies_of_the_system_are_those_of_the_derivation(equation: str, form: Form) -> None:
    law = VARIATIONAL.law(equation)
    twice = parse(law.right)
    assert twice[0] == "/"
    assert twice[2] == ("number", 2)
    assert not (form_of(twice[1], leaves(x=X, u=U)) - 2 * form).terms


def test_units_show_that_the_printed_time_is_none() -> None:
    """|x|/lambda_2 has the unit of the averaged entry; only divided by a rate it is a time."""
    kinds = BEARING.kinds()
    assert kinds["beta"] == kinds["gamma"]
    assert str(kinds["x"].unit / kinds["beta"].unit) == "s"
    assert str(kinds["x"].unit / kinds["L"].unit) == "c"


SHARED = {
    "cyclic_spsa.theorem_1_interval_one_instant": "cyclic_spsa.theorem_1_mean_step_at_once",
    "cyclic_spsa.theorem_1_bound_static": "cyclic_spsa.theorem_1_static",
    "cyclic_spsa.theorem_2_c3": "cyclic_spsa.theorem_2_c4_repair",
    "cyclic_spsa.section_5_stable_two_instants": "cyclic_spsa.step",
    "cyclic_spsa.section_5_stable_one_instant": "cyclic_spsa.step",
}
"""Claims that a statement with a wider use decides."""


@pytest.mark.parametrize("system", SYSTEMS, ids=lambda system: system.name)
def test_every_claim_has_a_statement_of_its_name_or_one_that_it_shares(system: System) -> None:
    names = {f"{statement.system}.{statement.name}" for statement in STATEMENTS}
    own = {name for name in SHARED if name.startswith(f"{system.name}.")}
    assert {claim.id for claim in system.claims} - names == own
    assert {SHARED[name] for name in own} <= names


def test_names_are_unique() -> None:
    assert len({system.name for system in SYSTEMS}) == len(SYSTEMS)
    named = [(statement.system, statement.name) for statement in STATEMENTS]
    assert len({*named}) == len(named)
    assert {system for system, _ in named} == {system.name for system in SYSTEMS}


@pytest.mark.parametrize("system", SYSTEMS, ids=lambda system: system.name)
def test_claims_hold_no_verdicts(system: System) -> None:
    words = ("PROVED", "REFUTED", "CORRECTED", "SUPPORTED", "UNDECIDED")
    assert not any(word in str(claim) for claim in system.claims for word in words)
