"""What certificates about sensors, weights and communication prove."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import combinations

from ....statements import Case, Statement

SENSORS = 6
LINE = ("p0", "p1", "p2")
PLACES = tuple(f"p{k}" for k in range(SENSORS))
TWO_TRIANGLES = frozenset({(0, 1), (0, 2), (1, 2), (2, 3), (3, 4), (3, 5), (4, 5)})
"""Links of six sensors of which each has two neighbours and one link, 2 to 3, is a bridge."""


def _links(places: Iterable[str], links: Iterable[tuple[int, int]]) -> tuple[str, ...]:
    """Which pairs are within the range r, and that no other is."""
    within = {*links}
    return tuple(
        f"T({a} - {b})*({a} - {b}) {'<=' if (i, j) in within else '>'} r**2"
        for (i, a), (j, b) in combinations(enumerate(places), 2)
    )


def _placed(
    name: str, words: str, places: tuple[str, ...], links: Iterable[tuple[int, int]]
) -> Statement:
    inputs = dict.fromkeys(places, "matrix") | {"r": "number"}
    show = ("r > 0", *_links(places, links))
    return Statement("variational", name, {"REFUTED": Case("REFUTED", words, show)}, inputs)


def _universal(
    name: str, words: str, show: tuple[str, ...], symbols: dict[str, str], given: tuple[str, ...]
) -> Statement:
    return Statement(
        "variational", name, {"PROVED": Case("PROVED", words, show)}, symbols=symbols, given=given
    )


def _observed() -> tuple[Statement, Statement]:
    letters = dict.fromkeys("bpr", "vector: n")
    refuted = Statement(
        "variational",
        "eq_1_observed_by",
        {
            "REFUTED": Case(
                "REFUTED",
                "for a target at b and a sensor at p with r = p - b, (1): what the sensor sees, "
                "b - p, differs from r by 2r, which is zero only if the target sits on the sensor",
                ("r - (b - p) == 2*r",),
            )
        },
        symbols=letters,
        given=("r - p + b",),
    )
    words = "r = p - b of (1) is the sensor as seen from the target, p - b"
    return refuted, _universal(
        "eq_1_observed_by_repair", words, ("r == p - b",), letters, ("r - p + b",)
    )


def _errors() -> Statement:
    return _universal(
        "eq_6_errors",
        "for all positions: with weights l + m + n = 1 of three sensors the weighted mean of what "
        "they report is the target's position b, and so it is with weights f + g = 1 of two of "
        "them; the same holds for velocities",
        (
            "l*(p - (p - b)) + m*(q - (q - b)) + n*(s - (s - b)) == b",
            "f*(p - (p - b)) + g*(q - (q - b)) == b",
        ),
        dict.fromkeys("lmnfg", "positive") | dict.fromkeys("bpqs", "vector: n"),
        ("l + m + n - 1", "f + g - 1"),
    )


def _kinematics_measured() -> Statement:
    words = (
        "with the averaged noise p of the positions and n of the velocities the measured errors "
        "are x + p and u + n: with x' = d = u and p' = q, the derivative r = d + q of the one "
        "differs from the other, m = u + n, by q - n, which is zero only for noises with p' = n"
    )
    return Statement(
        "variational",
        "eq_8_kinematics_measured",
        {"REFUTED": Case("REFUTED", words, ("r - m == q - n",))},
        symbols=dict.fromkeys("dmnqru", "vector: n"),
        given=("r - d - q", "m - u - n", "d - u"),
    )


def _kinematics() -> Statement:
    return _universal(
        "eq_8_kinematics",
        "if the estimate's position has the derivative c = w, its velocity, and the target's the "
        "derivative d = v, the error's derivative c - d is the velocity error w - v; by (6) and "
        "(7) the weights do not enter",
        ("c - d == w - v",),
        dict.fromkeys("cdwv", "vector: n"),
        ("c - w", "d - v"),
    )


STATEMENTS: tuple[Statement, ...] = (
    *_observed(),
    _errors(),
    _kinematics(),
    _kinematics_measured(),
    _placed(
        "section_2_neighbours",
        "three sensors at these places communicate within the range r along the path p0 - p1 - p2 "
        "and no more: any two are joined, and p0 has one neighbour only",
        LINE,
        ((0, 1), (1, 2)),
    ),
    _placed(
        "section_2_two_edge_connected",
        "six sensors at these places communicate within the range r as two triangles, p0 p1 p2 and "
        "p3 p4 p5, that are joined by the link p2 - p3 alone: each has two neighbours, and without "
        "that link the network falls apart",
        PLACES,
        TWO_TRIANGLES,
    ),
)
