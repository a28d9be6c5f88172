"""What (24) leaves of the errors when the target accelerates."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError
from theory.systems.variational.statements.common import EQUATION
from verification.answers import Answer
from verification.exact.evaluate import Rows, add, at, dot
from verification.exact.rationals import nearest
from verification.exact.solving import solved
from verification.figure import Axis, Curve, Plot

from .error_systems import stable_question

ONE: Rows = ((Fraction(1),),)
SHOWN: dict[str, Rows] = dict.fromkeys("MKC", ONE)
LONGEST_NOTE = 200
UNSETTLED = "(20) is not stable at this step: the error settles nowhere"
SHOWN_STEP, SAMPLES, PUSH = Fraction(1, 2), 40, Fraction(1)


def steady_errors(
    gains: Mapping[str, Rows], acceleration: Sequence[Fraction], h: Fraction
) -> tuple[Fraction, ...]:
    """Position error at which (24) rests while the target accelerates constantly, without noise.

    Each step misses h^2 a/2, so that the internal state rests at u = ha/2 and the last line of (20)
    gives the position error: its terms with u and the one with x cancel.

    Parameters
    ----------
    gains : mapping of str to Rows
        ``M``, ``K``, ``C``, symmetric positive definite.
    acceleration : sequence of Fraction
        In the length unit of the error per squared time unit of the gains.
    h : Fraction
        Step.

    Returns
    -------
    tuple of Fraction

    Raises
    ------
    InputError
        K is singular.
    """
    resting = [h / 2 * a for a in acceleration]
    internal = add(at(EQUATION.before("u"), gains, h), at(EQUATION.before("v"), gains, h))
    offset = solved(at(EQUATION.before("x"), gains, h), [-dot(resting, row) for row in internal])
    if offset is None:
        raise InputError("K", "a singular matrix", "a positive definite matrix is needed")
    return offset


def steady_offset(values: Mapping[str, Any]) -> Answer:
    """Position error at which (24) settles while the target accelerates constantly.

    Parameters
    ----------
    values : mapping
        ``M``, ``K``, ``C``: exact symmetric positive definite matrices of one size; ``h``: a
        positive rational in the time unit of the gains; ``acceleration``: n rationals, m/s^2.

    Returns
    -------
    Answer
        n numbers in m, each the double nearest to the exact rational; no value where (20) is not
        stable, because the error then settles nowhere.

    Raises
    ------
    InputError
        A gain is not symmetric positive definite, or h <= 0.
    """
    gains, h, stable = stable_question(values)
    if not stable:
        return Answer(verdict="UNDECIDED", notes=(UNSETTLED,))
    exact = steady_errors(gains, values["acceleration"], h)
    return Answer(value=[nearest(x) for x in exact], notes=(_solved_note(exact),))


def _solved_note(exact: Sequence[Fraction]) -> str:
    texts = ", ".join(map(str, exact))
    return f"solved in rationals: {texts}" if len(texts) <= LONGEST_NOTE else "solved in rationals"


def errors_over_time() -> Plot:
    """Position error of (24) for an accelerating target, with sampled and averaged velocities.

    M = K = C = 1, h = 1/2, a = 1, from the right start.
    """
    level = float(steady_errors(SHOWN, (PUSH,), SHOWN_STEP)[0])
    sampled = _errors(SHOWN_STEP**2 / 2 * PUSH, Fraction(0))
    averaged = _errors(Fraction(0), Fraction(level))
    samples = tuple(float(k) for k in range(SAMPLES))
    low, high = min(*sampled, level), max(*averaged, -level / 4)
    return Plot(
        title="Position error behind an accelerating target",
        finding=f"With sampled velocities the error settles at {level:.4g} instead of 0; with "
        "averaged velocities it tends to 0 from there.",
        caption="M = K = C = 1, h = 1/2, acceleration 1, no noise: from the true position, (24) "
        "drifts to -(h/2) C a/K and stays; with averaged velocities it leaves that level for zero.",
        x=Axis("sample k", "", 0.0, float(SAMPLES - 1)),
        y=Axis("position error", "m", low * 1.1, max(high * 1.1, 0.05), ticks=(level, 0.0)),
        curves=(
            Curve("printed", samples, sampled, "sampled, (24)"),
            Curve("sharp", samples, averaged, "averaged"),
            Curve("guide", (0.0, float(SAMPLES - 1)), (level, level)),
        ),
    )


def _errors(missed: Fraction, start: Fraction) -> tuple[float, ...]:
    """Position errors of one coordinate when each step misses the target by this much."""
    newer, position, older = (at(EQUATION.before(x), SHOWN, SHOWN_STEP)[0][0] for x in "uxv")
    e, u, found = start, Fraction(0), []
    for _ in range(SAMPLES):
        found.append(float(e))
        e = e + SHOWN_STEP * u - missed
        u = -(older * u + position * e) / newer
    return tuple(found)
