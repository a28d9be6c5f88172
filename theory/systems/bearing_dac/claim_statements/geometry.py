"""What certificates about bearings, averages and their rates prove."""

from __future__ import annotations

from ....algebra import averages, plane
from ....statements import Case, Statement
from ..universal import Universal

PLANE = dict.fromkeys("uvfhgqpt", "vector: 2") | {"c": "real", "s": "real", "l": "positive"}
"""Symbols of `theory.algebra.plane`."""
ROWS = {
    "H": "matrix: n 2",
    "z": "vector: n",
    "d": "vector: n",
    "X": "symmetric: 2",
    "Y": "symmetric: 2",
    "g": "vector: 2",
    "y": "vector: 2",
    "p": "vector: 2",
    "r": "positive",
}
STACK = {
    "H": "matrix: n 2",
    "z": "vector: n",
    "E": "matrix: N n",
    "a": "vector: N",
    "h": "vector: 2",
    "K": "matrix: N 2",
    "Z": "vector: N",
    "p": "vector: 2",
    "m": "real",
}
SPREAD = dict.fromkeys("kle", "vector: n") | {
    "M": "positive semidefinite: n",
    "r": "positive",
    "a": "real",
    "b": "real",
}
SUMS, EXACT = averages.stacked()[:2], averages.stacked()[2:]

GEOMETRY: tuple[Universal, ...] = (
    Universal(
        "section_1_bearing",
        "for the bearing f = (c, s), c^2 + s^2 = 1, of a target at p = q + l f, seen from q at the "
        "distance l: l^2 = |p - q|^2, and f has length 1",
        (plane.measured()[0], plane.measured()[2]),
        PLANE,
    ),
    Universal(
        "prop_1_identity",
        "for the bearing f = c u + s v and h = -s u + c v, with axes u, v and c^2 + s^2 = 1: f and "
        "h have length 1, f'h = 0 and ff' + hh' = I",
        plane.turned(),
        PLANE,
    ),
    Universal(
        "prop_1_clockwise",
        "uv' - vu' turns clockwise by a right angle, because it takes the second axis v to the "
        "first, u; h = -s u + c v differs from the bearing f = c u + s v so turned by 2h, whose "
        "length is 2",
        plane.clockwise(),
        PLANE,
        verdict="REFUTED",
    ),
    Universal(
        "prop_1_clockwise_repair",
        "vu' - uv' turns counter-clockwise by a right angle, because it takes the first axis u to "
        "the second, v; it takes f to h; the vector g that the clockwise turn gives has gg' = hh' "
        "and (g'q)g = (h'q)h, so that P and q do not depend on the turn",
        plane.counter_clockwise(),
        PLANE,
    ),
    Universal(
        "section_1_measurement",
        "for the target at p = q + l f, seen from q under the bearing f, and h = f turned by a "
        "right angle: h'q = h'p",
        (plane.measured()[1],),
        PLANE,
    ),
    Universal(
        "section_1_measurement_rows",
        "with one more sensor, at the place a beside E, with the row h' and the measurement m, Kp "
        "- Z is Hp - z beside h'p - m; so if each sensor's measurement is exact, z = Hp holds for "
        "any number of them",
        EXACT,
        STACK,
    ),
    Universal(
        "assumption_1_count_repair",
        "with the cosines k and sines l of twice the bearings of any number of sensors, at least "
        "one, and their means a and b, the averaged P is [[1 - a, -b], [-b, 1 + a]]/2, and four "
        "times its determinant is (k'Mk + l'Ml)/n; it is zero only if k and l are constant, that "
        "is, if the target and all sensors are on one line",
        averages.spread(),
        SPREAD,
    ),
    Universal(
        "section_1_unique",
        "for any number of sensors with an inverse X of H'H and g = XH'z: |z - Hy|^2 = |z - Hg|^2 "
        "+ |H(y - g)|^2 for every position y, so that g alone is best; and XH'd = p for d = Hp",
        averages.least_squares(),
        ROWS,
    ),
    Universal(
        "section_2_averages",
        "with inverses X of H'H and Y of H'H/n, r = 1/n: Y(H'z/n) = XH'z",
        (averages.averaged(),),
        ROWS,
    ),
    Universal(
        "section_2_averages_sums",
        "one more sensor, with the row h' and the measurement m, adds hh' to H'H and mh to H'z; so "
        "these are the sums of P and of q over any number of sensors",
        SUMS,
        STACK,
    ),
    Universal(
        "assumption_2_exists",
        "a target at the distance l that crosses the line of sight with the speed k turns it at "
        "the rate w = k/l, and P changes at this rate along f and h (its off-diagonal entry, if f "
        "is an axis); with k = gl + d, d > 0, this exceeds the bound g by d/l, so that no g is a "
        "bound for all distances",
        plane.unbounded(),
        PLANE
        | {"D": "symmetric: 2", "w": "real", "k": "positive", "g": "positive", "d": "positive"},
        verdict="REFUTED",
    ),
    Universal(
        "assumption_2_exists_repair",
        "for a sensor at q that does not move, at the distance l of a target of velocity t: the "
        "bearing turns at a rate w with l^2 w^2 <= |t|^2, the rate D of P has DD = w^2 I and no "
        "entry above |w|, and the rate g of q is Dq, of length |w||q|; so gamma = v/l max(1, |q|) "
        "bounds all entries for speeds up to v and distances from l on",
        plane.rates(),
        PLANE
        | dict.fromkeys("abi", "vector: 2")
        | {"D": "symmetric: 2", "w": "real", "t": "vector: 2"},
    ),
    Universal(
        "assumption_2_exists_attained",
        "if the target crosses the line of sight f, P changes at the rate w along f and h, so an "
        "entry of P does if f is an axis; and if the bearing is half the angle of the sensor's "
        "position q, the second entry of q changes at w|q|: the bound is attained",
        plane.fastest(),
        PLANE | {"D": "symmetric: 2", "w": "real", "S": "positive"},
    ),
    Universal(
        "algorithm_1_line_12",
        "P = hh' of each sensor takes its own line of sight f to zero, and f is not zero: P_x(t0) "
        "= P has no inverse",
        tuple(e for e in plane.information() if e.name in ("Pf = 0", "f is not 0")),
        PLANE,
        verdict="REFUTED",
    ),
    Universal(
        "section_2_entries_information",
        "P = hh' is symmetric, PP = P, and its trace is 1; its entries are (1 - cos)/2 and -sin/2 "
        "of twice the bearing; and (h'q)h = Pq",
        plane.information(),
        PLANE,
    ),
)


def two_sensors() -> Statement:
    """Two bearings that cross: rank 2 with n = 2."""
    show: tuple[str, ...] = ()
    for i in "01":
        show += (
            f"l{i} > 0",
            f"p - s{i} == l{i}*f{i}",
            f"T(f{i})*f{i} == 1",
            f"T(h{i})*f{i} == 0",
            f"T(h{i})*h{i} == 1",
        )
    matrices = ("p", *(name + i for i in "01" for name in "sfh"))
    return Statement(
        "bearing_dac",
        "assumption_1_count",
        {
            "REFUTED": Case(
                "REFUTED",
                "two sensors at s0 and s1 see the target at p in the directions f0 and f1, and the "
                "rows h0' and h1' have rank 2, because h0h0' + h1h1' is positive definite: the "
                "least-squares position is unique with n = 2",
                (*show, "pd(h0*T(h0) + h1*T(h1))"),
            )
        },
        inputs=dict.fromkeys(matrices, "matrix") | {"l0": "number", "l1": "number"},
    )
