"""The interval and the bound of Theorem 1: as printed, and as its proof gives them."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError
from theory.systems.cyclic_spsa.bounds import CUTS, PRINTED, PROVED, SPLIT, Bound, evaluated, table
from verification.answers import Answer, Input
from verification.enclosures import ball, enclosure, ends, listed, single
from verification.exact.spectra.spectral import Enclosure
from verification.input_words import positive

BITS = 256
COORDINATES = Input("d", "number", "coordinates of a block, a whole number")
CONVEXITY = Input("mu", "number", "constant of Assumption 1, above 0", "F/m^2")
SMOOTHNESS = Input("M", "number", "Lipschitz constant of Assumption 2, at least mu", "F/m^2")
PERTURBATION = Input("beta", "number", "size of the perturbation, above 0", "m")
CHANGE = Input("c3", "number", "constant of Assumption 5, at least 0", "F^2/m^2", "0")
INTERVAL = (COORDINATES, CONVEXITY, SMOOTHNESS, PERTURBATION, CHANGE)
ERROR = (
    COORDINATES,
    CONVEXITY,
    SMOOTHNESS,
    Input("alpha", "number", "step size, above 0", "m^2/F"),
    PERTURBATION,
    Input("delta", "number", "bound on the drift of a sample, at least 0", "m"),
    Input("c2", "number", "constant of Assumption 3, at least 0", "F^2/m^2", "0"),
    CHANGE,
    Input("c4", "number", "constant of Assumption 5, at least 0", "F^2", "0"),
    Input("c_v2", "number", "square of the constant of Assumption 6, at least 0", "F^2", "0"),
    Input("k", "number", "blocks of the cycle", "", "1"),
)

NEVER = (
    "the second branch never occurs: M >= mu makes gamma >= 3 d^2 M^2 >= 3 mu^2, and it needs "
    "mu^2 >= 2 gamma"
)
IMPOSSIBLE = "M < mu: no cost has such constants, which Assumptions 1 and 2 make M >= mu"
OUTSIDE = "alpha is not inside the interval, 0 < alpha < mu/gamma = {}"
ALL_BLOCKS = "for all {} blocks together, each beside its positions at its own last update; "
ONE_BLOCK = "for each block alone: the bound over the root of {}"


def printed_interval(values: Mapping[str, Any]) -> Answer:
    """The set of steps that Theorem 1 prints.

    Parameters
    ----------
    values : mapping
        ``d``: a whole number; ``mu``, ``M``, ``beta``: positive rationals; ``c3``: a rational of
        at least 0.

    Returns
    -------
    Answer
        [0, mu/gamma], or [[0, r1], [r2, mu/gamma]] where mu^2 >= 2 gamma, in m^2/F.

    Raises
    ------
    InputError
        A number is out of range; M < mu alone is not: the note says that no cost has it.
    """
    given = _numbers(values, INTERVAL)
    limit = interval_end(PRINTED, given)
    split = evaluated(SPLIT.tree, {**given, **_lines(PRINTED, given)})
    possible = given["M"] >= given["mu"]
    note = NEVER if possible else IMPOSSIBLE
    whole = (enclosure(Fraction(0), Fraction(0)), enclosure(limit, limit, f"mu/gamma = {limit}"))
    if split < 0:
        return listed(whole, (note,))
    low, high = (_cut(line.tree, given, split) for line in CUTS)
    found = listed((whole[0], low, high, whole[1]), (note,))
    numbers = found.value
    pairs = [numbers[:2], numbers[2:]]
    return Answer(value=pairs, verdict=found.verdict, notes=found.notes)


def printed_bound(values: Mapping[str, Any]) -> Answer:
    """The bound (21) with its printed constants; c1 = 0, epsilon tending to 0.

    Parameters
    ----------
    values : mapping
        ``d``, ``k``: whole numbers; ``mu``, ``M``, ``alpha``, ``beta``: positive rationals, M >=
        mu; ``delta``, ``c2``, ``c3``, ``c4``, ``c_v2``: rationals of at least 0.

    Returns
    -------
    Answer
        Root-mean-square error of all k blocks together in m, in certified bounds; ``"inf"`` where
        alpha is not inside the printed interval.

    Raises
    ------
    InputError
        A number is out of range.
    """
    return _bounded(PRINTED, values)


def corrected_bound(values: Mapping[str, Any]) -> Answer:
    """The bound of Theorem 1 that its proof gives once its slips are repaired.

    Parameters, returns and errors are those of `printed_bound`, the interval being the corrected
    one. Assumption 5 is taken for every x, with the squared distance: c3 and c4 bound the mean
    square of the difference of two successive costs at x by c3 |x - theta_{t-1}|^2 + c4.
    """
    return _bounded(PROVED, values)


def _bounded(bound: Bound, values: Mapping[str, Any]) -> Answer:
    given = _numbers(values, ERROR)
    if given["M"] < given["mu"]:
        raise InputError("M", f"{given['M']}, mu being {given['mu']}", "M >= mu is needed")
    limit, blocks = interval_end(bound, given), given["k"]
    if given["alpha"] >= limit:
        return Answer(value="inf", verdict="PROVED", notes=(OUTSIDE.format(limit),))
    notes = (ALL_BLOCKS.format(blocks) + ONE_BLOCK.format(blocks),) if blocks > 1 else ()
    return single(bound_between(bound, given), notes)


def bound_between(bound: Bound, given: Mapping[str, Fraction]) -> Enclosure:
    """A bound in certified doubles, for a step inside its interval.

    Parameters
    ----------
    bound : Bound
    given : mapping of str to Fraction
        The names that Assumptions 1 to 7 speak of.
    """
    import flint

    with flint.ctx.workprec(BITS):
        balls = {name: ball(x) for name, x in given.items()}
        # q is a sum of terms of which none is negative; a ball may reach below zero by rounding
        found = table(bound, balls, lambda x: x.sqrt())
        return enclosure(*ends(found[bound.value.name]))


def _lines(bound: Bound, given: Mapping[str, Fraction]) -> dict[str, Fraction]:
    found = dict(given)
    for line in bound.limit:
        found[line.name] = evaluated(line.tree, found)
    return found


def interval_end(bound: Bound, given: Mapping[str, Fraction]) -> Fraction:
    """mu/gamma, the supremum of the steps.

    Parameters
    ----------
    bound : Bound
    given : mapping of str to Fraction
        ``d``, ``mu``, ``M``, ``beta`` and ``c3``.
    """
    return _lines(bound, given)[bound.limit[-1].name]


def _cut(tree: Any, given: Mapping[str, Fraction], split: Fraction) -> Enclosure:
    """One end of what the second branch leaves out."""
    import flint

    with flint.ctx.workprec(BITS):
        balls = {name: ball(x) for name, x in _lines(PRINTED, given).items()}
        return enclosure(*ends(evaluated(tree, {**balls, "root_s": ball(split).sqrt()})))


def _numbers(values: Mapping[str, Any], inputs: tuple[Input, ...]) -> dict[str, Fraction]:
    """The numbers of Theorem 1, each in its range."""
    found: dict[str, Fraction] = {}
    for entry in inputs:
        name, value = entry.name, values[entry.name]
        if name in {"d", "k"}:
            if value.denominator != 1 or value < 1:
                raise InputError(name, f"{value}", "a whole number of at least 1 is needed")
        elif name in {"mu", "M", "alpha", "beta"}:
            positive(values, name)
        elif value < 0:
            raise InputError(name, f"{value}", "a number of at least 0 is needed")
        found[name] = value
    return found
