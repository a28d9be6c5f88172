"""What certificates about the simulated form (24) prove: moving targets, weights, lost sensors.

One step of (24) leads from the estimate p and the internal state u to q and w, while the target
goes from b to its next position. Deviations from what the errors settle at are (x, s), a step later
(y, t). Sensors are stacked: column i of B is the position of sensor i, of R its position relative
to the target; W and S are their velocities, l the weights and j holds ones.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from ....algebra.noncommuting import Form, letters, scalars
from ....statements import Case, Statement
from .common import ANY_GAINS, DEFINITE, EQUATION, GAINS, HALF, SCHEME, C, K, M, h, pencil

a, b, o, p, q, r, s, t, u, v, w, x, y, z = letters("a b o p q r s t u v w x y z")
j, lam, B, R, S, W = letters("j l B R S W")
(Q,) = letters("Q", "Q")
ONE = Form({((), ()): Fraction(1)})

SENSORS = {"B": "matrix: n N", "R": "matrix: n N", "W": "matrix: n N", "S": "matrix: n N"}
SENSORS |= {"l": "vector: N", "j": "vector: N"}

STABLE = Q - 4 * M - 2 * (h * C) + h * h * K
"""Zero if Q is the form whose sign decides whether (20) is stable."""

FOR_STABLE = "and for every h > 0 with 4M + 2hC - h^2 K > 0 they tend to 0"

UNIFORM = b + h * v
ACCELERATED = UNIFORM + HALF * (h * h * a)
"""The target one step later, at constant velocity and at constant acceleration."""


def last_line(position: Form, old: Form, new: Form) -> Form:
    """Last line of (20), zero along every solution: (M + hC) new - M old + hK position."""
    return -EQUATION.substitute({"x": position, "u": new, "v": old})


def estimator(velocity: Form, position: Form) -> tuple[Form, Form]:
    """(24) from (p, u) to (q, w), each line zero, with these averages of the measurements."""
    return q - p - h * (velocity + u), last_line(q - position, u, w)


def obeys_20(x0: Form, u0: Form, x1: Form, u1: Form) -> tuple[str, str]:
    """Predicates that (x0, u0), (x1, u1) is a step of (20)."""
    return f"{x1 - x0 - h * u0} == 0", f"{last_line(x1, u0, u1)} == 0"


def _vectors(names: str) -> dict[str, str]:
    return dict.fromkeys(names, "vector: n")


def _statement(
    name: str,
    words: str,
    show: tuple[str, ...],
    symbols: Mapping[str, str],
    given: tuple[Form, ...],
    verdict: str = "PROVED",
) -> Statement:
    case = Case(verdict, words, show)
    return Statement(
        "variational", name, {verdict: case}, symbols=symbols, given=tuple(map(str, given))
    )


def _settling(
    name: str,
    words: str,
    lines: tuple[Form, Form],
    position: Form,
    speed: Form,
    more: tuple[Form, ...] = (),
    symbols: Mapping[str, str] | None = None,
    show: tuple[str, ...] = (),
) -> Statement:
    """The errors settle at (o, r) with K o = -C r and r = `speed`, which is not zero."""
    moved = (x - p + b + o, y - q + position + o, s - u + r, t - w + r)
    given = (*lines, K * o + C * r, r - speed, *moved, *more)
    shown = (*obeys_20(x, s, y, t), f"{-(r.T * K * o)} == {r.T * C * r}", "pd(C)", *show)
    kinds = ANY_GAINS | _vectors("bopqrstuwxy") | dict(symbols or {})
    return _statement(name, words, shown, kinds, given, "REFUTED")


def _converging(
    name: str,
    words: str,
    lines: tuple[Form, Form],
    positions: tuple[Form, Form],
    more: tuple[Form, ...],
    symbols: Mapping[str, str],
    show: tuple[str, ...] = (),
) -> Statement:
    """The errors x, u obey (20), which is stable while Q > 0."""
    now, later = positions
    given = (*lines, x - p + now, y - q + later, STABLE, *more)
    shown = (*obeys_20(x, u, y, w), f"schur({pencil(SCHEME)})", *show)
    kinds = ANY_GAINS | _vectors("bpquwxy") | {"Q": "positive definite: n"} | dict(symbols)
    return _statement(name, words, shown, kinds, given)


def _accelerating() -> tuple[Statement, ...]:
    printed = _settling(
        "section_4_converge",
        "for all M, K, C > 0 of any size, every h > 0 and every target with a constant "
        "acceleration a: the errors of (24) without noise, taken from the constant pair (o, r) "
        "with r = ha/2 and K o = -C r, obey (20); since -r'Ko = r'Cr > 0 unless a = 0, no "
        "solution of (24) tends to 0",
        estimator(v, ACCELERATED),
        ACCELERATED,
        HALF * (h * a),
        symbols=_vectors("av"),
    )
    averaged = _converging(
        "section_4_converge_repair",
        "for all M, K, C > 0 of any size and every target with a constant acceleration: with the "
        "mean of the velocities v and z that are measured at both ends of the step in the first "
        f"line of (24), the errors x, u without noise obey (20), {FOR_STABLE}",
        estimator(HALF * (v + z), ACCELERATED),
        (b, ACCELERATED),
        (z - v - h * a,),
        _vectors("avz"),
    )
    uniform = _converging(
        "section_4_converge_uniform",
        "for all M, K, C > 0 of any size and every target with a constant velocity v: the errors "
        f"x, u of (24) as printed, without noise, obey (20), {FOR_STABLE}",
        estimator(v, UNIFORM),
        (b, UNIFORM),
        (),
        _vectors("v"),
    )
    return printed, _offset(), averaged, uniform


def _offset() -> Statement:
    words = (
        "M, K, C are symmetric positive definite, every solution of (20) tends to 0 at the step "
        "h, and the position error of (24) without noise therefore tends to the o with "
        "K o = -(h/2) C a, which is not 0"
    )
    show = (*DEFINITE, "h > 0", f"schur({pencil(SCHEME)})")
    limit = "exists(o, K*o == -h/2*C*a, T(o)*o > 0)"
    case = Case("REFUTED", words, (*show, limit))
    kinds = GAINS | {"a": "matrix", "h": "number"}
    return Statement("variational", "section_4_converge_offset", {"REFUTED": case}, kinds)


def _misprint() -> tuple[Statement, ...]:
    sensors = {name: SENSORS[name] for name in "WSlj"}
    one = j.T * lam - ONE
    literal = (W - z * j.T) * lam
    printed = _settling(
        "eq_24_measured",
        "for all M, K, C > 0 of any size, every h > 0, any number of sensors with weights l of "
        "sum one, and constant velocities W of the sensors and z of the target: if the measured "
        "value of z itself stands in (24) for every sensor, the velocity estimate is wrong by "
        "u - r with r = 2z - W l, and the position error taken from the o with K o = -C r obeys "
        "(20); -r'Ko = r'Cr > 0 unless r = 0",
        estimator(literal, b + h * z),
        b + h * z,
        2 * z - W * lam,
        (one,),
        {name: sensors[name] for name in "Wlj"} | _vectors("z"),
        (f"{literal + u - z} == {u - r}",),
    )
    meant = _converging(
        "eq_24_measured_repair",
        "for all M, K, C > 0 of any size, any number of sensors with weights l of sum one, any "
        "velocities W of theirs and a constant velocity z of the target: with the measured "
        "relative velocities S in (24) the velocity estimate is wrong by u only, the errors x, u "
        f"obey (20), {FOR_STABLE}",
        estimator((W - S) * lam, b + h * z),
        (b, b + h * z),
        (S - W + z * j.T, one),
        sensors | _vectors("z"),
        (f"{(W - S) * lam + u - z} == {u}",),
    )
    return printed, meant


def _lost_sensor() -> tuple[Statement, ...]:
    before, after = (dict(zip("BRWSlj", letters(f"B{k} R{k} W{k} S{k} l{k} j{k}"), strict=True))
                     for k in (1, 2))  # fmt: skip
    given = []
    for at, seen in ((b, before), (UNIFORM, after)):
        given += [seen["R"] - seen["B"] + at * seen["j"].T]
        given += [seen["S"] - seen["W"] + v * seen["j"].T, seen["j"].T * seen["l"] - ONE]
    positions = [(seen["B"] - seen["R"]) * seen["l"] for seen in (before, after)]
    velocities = [(seen["W"] - seen["S"]) * seen["l"] for seen in (before, after)]
    kinds = {f"{name}{k}": kind.replace("N", f"N{k}") for k in (1, 2) for name, kind in
             SENSORS.items()}  # fmt: skip
    loss = _converging(
        "section_4_sensor_loss",
        "for all M, K, C > 0 of any size, any set of sensors with weights of sum one at a sample "
        "(B1, R1, W1, S1, l1) and any other at the next (B2, R2, W2, S2, l2), exact measurements "
        "and a constant velocity of the target: the averages are the target's position and "
        f"velocity before and after, so the errors x, u obey (20) across the change, {FOR_STABLE}",
        estimator(velocities[0], positions[1]),
        (b, UNIFORM),
        tuple(given),
        kinds | _vectors("v"),
        (f"{positions[0]} == {b}", f"{velocities[1]} == {v}"),
    )
    return loss, _kept_weights()


def _kept_weights() -> Statement:
    (share,) = scalars("f")
    return _converging(
        "section_4_sensor_loss_kept",
        "for all M, K, C > 0 of any size, any sensors whose weights have the sum f > 0 instead of "
        "one, exact measurements and a target at rest in b: the estimate taken from f b obeys "
        f"(20), {FOR_STABLE}, so that the position error tends to -(1 - f) b: with two of three "
        "weights 1/3, to a third of the distance from the origin",
        estimator((W - S) * lam, (B - R) * lam),
        (share * b, share * b),
        (R - B + b * j.T, S - W, j.T * lam - share),
        SENSORS | {"f": "positive"},
    )


def _averaged_noise() -> Statement:
    words = (
        "for every linear recursion z+ = A z + G n of any size, N > 1 sensors and the stationary "
        "covariance P of z when n is the mean of N independent white noises of one covariance V: "
        "the mean's covariance is V/N, and with one sensor less N/(N-1) P is stationary; f and g "
        "stand for 1/(N-1) and 1/N, l for equal weights"
    )
    show = ("T(l)*l == g", "f*N*P == A*(f*N*P)*T(A) + f*G*V*T(G)")
    symbols = {"A": "matrix: n", "G": "matrix: n m", "P": "symmetric: n", "V": "symmetric: m"}
    symbols |= {"l": "vector: k", "j": "vector: k"} | dict.fromkeys("Nfg", "positive")
    given = ("P - A*P*T(A) - g*G*V*T(G)", "g*N - 1", "f*N - f - 1", "l - g*j", "T(j)*j - N")
    case = Case("PROVED", words, show)
    return Statement(
        "variational", "section_4_noise_robust", {"PROVED": case}, symbols=symbols, given=given
    )


STATEMENTS: tuple[Statement, ...] = (
    *_accelerating(),
    *_misprint(),
    *_lost_sensor(),
    _averaged_noise(),
)
