"""What certificates about the positions that sensors compute prove: runs on genuine bearings.

A vector ``a`` is the indicator of one sensor if its entries are at least zero and both their sum
and the sum of their squares are 1. Bounds of `cut_drifts` must not be negative, which is how the
language says so of all entries of ``a``.
"""

from __future__ import annotations

from ....statements import Case, Statement
from ..statements import WITHIN_THEOREM

ONE_SENSOR = (
    "T(a)*ones(graph)*a == 1",
    "T(a)*a == 1",
    "cut_drifts(graph, a, 0)",
)
FROM_MEAN = "(eye(graph) - 1/nodes(graph)*ones(graph))*a"
NUMBERS = {"graph": "unweighted graph", "a": "nodes", "beta": "number", "t": "number"}


def late_position() -> Statement:
    """A target that rests, and a sensor that is wrong about it after the printed time."""
    words = (
        "one sensor, with the indicator a (of sum and sum of squares 1, and without an entry below "
        "zero, as the bounds of cut_drifts), sees a target that rests at (k, 0) under the bearing "
        "(c, s), all others under (c, -s); rates are zero, and the gain is as printed; P_12 is -sc "
        "and sc, its error starts at -2sc Ma and is zero at the time t, that of the second entry "
        "of q, kP_12, starts at k times it and is y; the average of P, with the diagonal s^2, c^2, "
        "has an inverse; at the time t, after the printed |x(t0)|/lambda_2, |x(t0)|^2 = n(1 + k^2 "
        "s^2), the position of sensor a is wrong, because its P_x is the average and its q_x is not"
    )
    show = (
        *WITHIN_THEOREM,
        "gamma > 0",
        "c**2 + s**2 == 1",
        "nodes(graph) >= 3",
        "(s*c)**2 > ((1 - 2/nodes(graph))*s*c)**2",
        *ONE_SENSOR,
        f"run(graph, beta, 0, -2*s*c*{FROM_MEAN}, 0*a, t)",
        f"run(graph, beta, 0, -2*k*s*c*{FROM_MEAN}, y, t)",
        "T(a)*y != 0",
        "t > 0",
        "t**2*lambda_2**2 > nodes(graph)*(1 + k**2*s**2)",
    )
    numbers = dict.fromkeys(("gamma", "lambda_2", "c", "s", "k"), "number")
    return Statement(
        "bearing_dac",
        "theorem_2_time",
        {"REFUTED": Case("REFUTED", words, show)},
        inputs=NUMBERS | numbers | {"y": "nodes"},
    )


def singular_later() -> Statement:
    """A matrix P_x that has an inverse for a while and loses it again."""
    words = (
        "one sensor, with the indicator a (of sum and sum of squares 1, and without an entry below "
        "zero, as the bounds of cut_drifts), sees a target that rests under the bearing (d, e), "
        "all others under (c, s), on other lines, so that the average of P has an inverse; the "
        "errors of P_11 and P_12 run to y and -z in the time t > 0, and with these P_x of sensor a "
        "has determinant zero"
    )
    first = "(s*s + (e*e - s*s)/nodes(graph) + T(a)*y)"
    second = "(s*c + (e*d - s*c)/nodes(graph) + T(a)*z)"
    show = (
        "pd(laplacian(graph) + ones(graph))",
        "beta > 0",
        "d**2 + e**2 == 1",
        "c**2 + s**2 == 1",
        "(d*s - e*c)**2 > 0",
        *ONE_SENSOR,
        f"run(graph, beta, 0, (e*e - s*s)*{FROM_MEAN}, y, t)",
        f"run(graph, beta, 0, -(e*d - s*c)*{FROM_MEAN}, -z, t)",
        "t > 0",
        f"{first}*(1 - {first}) - {second}*{second} == 0",
    )
    inputs = NUMBERS | dict.fromkeys("cdes", "number") | dict.fromkeys("yz", "nodes")
    return Statement(
        "bearing_dac",
        "algorithm_1_line_12_later",
        {"REFUTED": Case("REFUTED", words, show)},
        inputs=inputs,
    )
