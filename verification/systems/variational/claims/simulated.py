"""How the claims about the simulated form (24) are decided: moving targets and lost sensors."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from verification.certificates.make import certificate
from verification.exact.evaluate import Rows
from verification.verdict import Decision, Verdict

from ..moving import errors_over_time, steady_errors
from .witnesses import derivation

DECAYING = (
    derivation((("h", "1", "C"),)),
    derivation((("2", "1", "M"), ("h", "1", "C"))),
    derivation((("h**2", "1", "K"),)),
)
"""Three of Jury's four conditions hold for all gains."""


def rows(*lines: str) -> Rows:
    """An exact matrix from lines of numbers."""
    return tuple(tuple(map(Fraction, line.split())) for line in lines)


EXAMPLE: dict[str, Rows] = {
    "M": rows("2 1/2 0", "1/2 1 1/5", "0 1/5 3/2"),
    "K": rows("4 1 0", "1 3 -1/2", "0 -1/2 2"),
    "C": rows("1 0 3/10", "0 1/2 0", "3/10 0 4/5"),
}
"""Gains that do not commute."""

ACCELERATION = (Fraction(1), Fraction(-2), Fraction(1, 2))
TENTH = Fraction(1, 10)


def settling(first: tuple[Any, ...] = (), *more: Any) -> list[Any]:
    """Witness that deviations from (o, r) obey (20); `first` shows the target's part of line 1."""
    moved = (("1", "5", "1"), ("-1", "4", "1"), ("-h", "6", "1"), ("1", "0", "1"))
    last = (("M + h*C", "7", "1"), ("-M", "6", "1"), ("h*K", "5", "1"), ("1", "1", "1"))
    return [
        derivation((), *moved, ("h", "3", "1"), *first),
        derivation((), *last, ("-h", "2", "1")),
        derivation((), ("-T(r)", "2", "1")),
        derivation((("1", "1", "C"),)),
        *more,
    ]


def converging(first: tuple[Any, ...] = (), last: tuple[Any, ...] = (), *more: Any) -> list[Any]:
    """Witness that errors obey (20) and that (20) is stable; with what the averages add."""
    return [
        derivation((), ("1", "3", "1"), ("-1", "2", "1"), ("1", "0", "1"), *first),
        derivation((), ("h*K", "3", "1"), ("1", "1", "1"), *last),
        *DECAYING,
        derivation((("1", "1", "Q"),), ("-1", "4", "1")),
        *more,
    ]


def converge() -> Decision:
    """(24) settles at an error proportional to the acceleration; averaged velocities do not."""
    column = tuple((x,) for x in ACCELERATION)
    offset = steady_errors(EXAMPLE, ACCELERATION, TENTH)
    shown = ", ".join(f"{float(x):.6f}" for x in offset)
    inputs = {**EXAMPLE, "a": column, "h": TENTH}
    witness = [{"kind": "matrix", "rows": [[x] for x in offset]}]
    documents = {
        "": certificate("variational", "section_4_converge", {}, settling(), case="REFUTED"),
        "_offset": certificate(
            "variational", "section_4_converge_offset", inputs, witness, case="REFUTED"
        ),
        "_repair": certificate(
            "variational",
            "section_4_converge_repair",
            {},
            converging((("1/2*h", "5", "1"),)),
        ),
        "_uniform": certificate("variational", "section_4_converge_uniform", {}, converging()),
    }
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="With velocities sampled at the start of each step, a target of constant "
        "acceleration a is missed by h^2 a/2 in every step; the errors taken from the constant "
        "pair (o, ha/2) with K o = -(h/2) C a obey (20), as an identity for all gains, so they "
        "tend to that pair and never to zero unless a = 0.",
        printed="0",
        sharp=f"({shown}) for a = ({', '.join(map(str, ACCELERATION))}), h = {TENTH}",
        margin_text="proportional to h and to the acceleration",
        repair="The errors tend to zero for a target of constant velocity; with the mean of the "
        "velocities measured at both ends of the step in the first line of (24), they tend to "
        "zero for constant acceleration too.",
        repair_formula=r"\hat b_{k+1}=\hat b_k+h\left(\tfrac12\sum\lambda_i"
        r"\left(v^i_k-v^{0i}_{k,m}+v^i_{k+1}-v^{0i}_{k+1,m}\right)+u_k\right)",
        certificates={f"variational.section_4_converge{end}": d for end, d in documents.items()},
        replay=_replay(offset),
        figure=errors_over_time(),
    )


def _replay(offset: tuple[Fraction, ...]) -> tuple[tuple[str, ...], ...]:
    """The fixed point and the two sides of K o = -(h/2) C a."""
    head = ("coordinate", "o", "(K o)_i", "-(h/2) (C a)_i")
    lines = [head]
    for i, x in enumerate(offset):
        pull = sum(k * y for k, y in zip(EXAMPLE["K"][i], offset, strict=True))
        push = sum(c * y for c, y in zip(EXAMPLE["C"][i], ACCELERATION, strict=True))
        lines.append((str(i + 1), str(x), str(pull), str(-TENTH / 2 * push)))
    return tuple(lines)


def measured() -> Decision:
    """Read as printed, (24) takes the target's velocity for a relative one."""
    extra = derivation((), ("1", "3", "1"), ("-z", "8", "1"))
    refuted = certificate(
        "variational",
        "eq_24_measured",
        {},
        settling((("-h*z", "8", "1"),), extra),
        case="REFUTED",
    )
    repaired = certificate(
        "variational",
        "eq_24_measured_repair",
        {},
        converging(
            (("-h", "5", "l"), ("h*z", "6", "1")),
            (),
            derivation((), ("-1", "5", "l"), ("z", "6", "1")),
        ),
    )
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="With the target's own velocity z in place of the relative one, the average of (24) "
        "is wrong by W l - 2z (W l: weighted velocity of the sensors), and the position error "
        "settles at K^-1 C (W l - 2z), as an identity for any number of sensors.",
        printed="measured value of v_k^0",
        sharp="measured value of v_k^0i",
        margin_text="wrong by the weighted velocity of the sensors less twice the target's",
        repair="The measured value is that of the relative velocity of sensor i; then the velocity "
        "estimate is wrong by u only, and the errors obey (20).",
        repair_formula=r"v^{0i}_{k,m}=v^{0i}_k+\nu^{0i}_k",
        certificates={
            "variational.eq_24_measured": refuted,
            "variational.eq_24_measured_repair": repaired,
        },
    )


def sensor_loss() -> Decision:
    """Exact averages do not depend on which sensors make them up, if weights are rescaled."""
    loss = converging(
        (("-h", "6", "l1"), ("h*v", "7", "1")),
        (("-h*K", "8", "l2"), ("h*K*(b + h*v)", "10", "1")),
        derivation((), ("-1", "5", "l1"), ("b", "7", "1")),
        derivation((), ("-1", "9", "l2"), ("v", "10", "1")),
    )
    kept = converging((("-h", "6", "l"),), (("-h*K", "5", "l"), ("h*K*b", "7", "1")))
    documents = {
        "": certificate("variational", "section_4_sensor_loss", {}, loss),
        "_kept": certificate("variational", "section_4_sensor_loss_kept", {}, kept),
    }
    return Decision(
        verdict=Verdict.PROVED,
        reason="Exact measurements give the target's position and velocity with any weights of sum "
        "one, so the errors obey (20) across every change of the set: no jump, and they tend to "
        "zero at every stable step. Rescaling matters: with two weights of 1/3 kept, the error "
        "tends to a third of the target's distance from the origin.",
        sharp="no jump",
        margin_text="needs weights rescaled to the sum one, and no acceleration",
        certificates={
            f"variational.section_4_sensor_loss{end}": document
            for end, document in documents.items()
        },
    )


DECISIONS: Mapping[str, Callable[[], Decision]] = {
    "variational.section_4_converge": converge,
    "variational.eq_24_measured": measured,
    "variational.section_4_sensor_loss": sensor_loss,
}
