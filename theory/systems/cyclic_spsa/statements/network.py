"""What a certificate about all sensors and blocks of a network proves."""

from __future__ import annotations

from ....statements import Case, Statement
from .assumptions import semidefinite

LOAD = "G*(2*h + (reading - 1)*diag(h)*(s/(2*beta**2) + e/(4*beta**2)))"
"""Of each block, the sum of h (1 + N) over its coordinates."""

RELIES = (
    "the second moments of the error of a block whose Hessian is diagonal tend to 0 if and only if "
    "0 < alpha < 2/sum h_i (1 + N_ii): off the diagonal each is a multiple of itself, and those on "
    "it form a positive matrix, a diagonal one plus one of rank 1"
)


def _network() -> Statement:
    words = (
        "G has a row for each block of each sensor and a column for each pair of a sensor and a "
        "target that it follows, with a 1 where the target is in the block; h, s and e are, a row "
        "for each such pair, the weight in the cost (20), the trace of the covariance of the "
        "measured position and the squared drift of a sample; reading is 2 if the two costs of an "
        "update use two measurements and 1 if they use one: every block is mean-square stable for "
        "every step 0 < alpha < upper, and some block is not for any alpha >= upper"
    )
    worst = "exists(c, T(unit)*c == 1, diag(c)*c == c, upper*T(load)*c == 2)"
    within = semidefinite("diag(2*unit - upper*load)", "1")
    show = (
        "pd(diag(h))",
        "pd(diag(s))",
        "beta > 0",
        "(reading - 1)*(reading - 2) == 0",
        "exists(one, diag(h)*one == h)",
        f"exists(load, load == {LOAD}, pd(diag(load)))",
        "exists(unit, diag(load)*unit == load, T(G)*unit == one)",
        within,
        worst,
        "exists(p, exists(q, e == diag(p)*p + diag(q)*q))",
    )
    inputs = dict.fromkeys(("G", "h", "s", "e"), "matrix") | dict.fromkeys(
        ("beta", "reading"), "number"
    )
    cases = {"PROVED": Case("PROVED", words, show, {"upper": None})}
    return Statement("cyclic_spsa", "network_step_limit", cases, inputs, relies_on=(RELIES,))


STATEMENTS: tuple[Statement, ...] = (_network(),)
