"""What certificates about the weights, the cost and its constraints prove."""

from __future__ import annotations

from ....algebra import constraints
from ....statements import Statement
from .. import cost_identities
from ..universal import Universal
from .replays import case, numbers

FIT = {"P": "positive semidefinite: N", "o": "vector: N", "z": "vector: N"} | {
    "r": "real",
    "x": "real",
    "g": "positive",
}
RISK = dict.fromkeys("cot", "vector: n") | {
    "M": "matrix: 2 n",
    "d": "vector: 2",
    "k": "positive",
    "l": "positive",
}
COPY = {"C": "positive definite: n", **dict.fromkeys("oxmd", "vector: n"), "r": "real", "t": "real"}
PARTS = dict.fromkeys("ABH", "symmetric: d") | {"d": "vector: d"}
LINEAR = {
    "H": "matrix: l d",
    "N": "matrix: d m",
    "W": "symmetric: m",
    "Y": "symmetric: l",
    "x": "vector: d",
    "q": "vector: l",
    "z": "vector: m",
}

UNIVERSAL: tuple[Universal, ...] = (
    Universal(
        "eq_3_mean_risk_repair",
        "for sensors of weights c = 1/variance whose computed positions are right in the mean "
        "(mean errors M = 0) and l = (K/n) times the sum of c: twice the mean of the cost at the "
        "error d of the estimate is l |d|^2 and a number without d; so it is (3) if l = 1, that is "
        "K = n/(sum of 1/variance)",
        cost_identities.mean_risk(),
        RISK,
    ),
    Universal(
        "eq_3_minimum",
        "for sensors of weights c = 1/variance whose computed positions are right in the mean "
        "(mean errors M = 0) and l = (K/n) times the sum of c, l > 0: twice the mean of the cost "
        "at the error d exceeds that at d = 0 by l |d|^2, for any K",
        cost_identities.mean_risk(),
        RISK,
    ),
    Universal(
        "eq_6_reduced",
        "for H with inverse Y of HH', a basis N of its kernel with inverse W of N'N, and N W N' + "
        "H'Y H = I: with h(x) = W N'x and g(z) = N z + H'Y q, g(h(x)) = x wherever Hx = q, H g(z) "
        "= q and h(g(z)) = z",
        constraints.reduced(),
        LINEAR,
        relies_on=("the kernel of a matrix is the orthogonal complement of its row space",),
    ),
    Universal(
        "eq_7_copies",
        "for the costs (x - 1)^2 and (x + 1)^2 of two sensors: at a common point z the sum exceeds "
        "2 by 2 z^2, so that 2 is the least value, and the copies x = 2 and y = 0, which differ by "
        "2, have the sum (x - 1)^2 + (y + 1)^2 = 2 as well",
        cost_identities.unlike_copies(),
        dict.fromkeys("xyz", "real"),
        verdict="REFUTED",
    ),
    Universal(
        "eq_7_copies_repair",
        "for copies x of one coordinate with weights C, positive definite, each fitted to what has "
        "the mean r: with d = x - r o the mean cost exceeds that of agreement at r by d'Cd, which "
        "is zero only for d = 0",
        cost_identities.like_copies(),
        COPY,
    ),
    Universal(
        "eq_7_subvectors",
        "for A + B = I, 1 on the diagonal at the coordinates of one part and of all others, and a "
        "Hessian H with AHB = 0: d'Hd = (Ad)'H(Ad) + (Bd)'H(Bd), and so on part by part",
        cost_identities.subvectors(),
        PARTS,
    ),
    Universal(
        "eq_20_weights_steady",
        "for any law of finitely many measured coordinates z, of mean r, and a weight g > 0 that "
        "is the same for all: the mean cost at x exceeds that at r by g (x - r)^2",
        cost_identities.constant_weights(),
        FIT,
    ),
)


STATEMENTS: tuple[Statement, ...] = (
    *(entry.statement for entry in UNIVERSAL),
    case(
        "REFUTED",
        "eq_3_mean_risk",
        "two sensors of variances a and b, p = 0 and K = p m + (1 - p)(a + b): the mean of the "
        "cost is (3) times l = (K/2)(1/a + 1/b), up to a number, and l is not 1",
        (
            "a > 0",
            "b > 0",
            "m > 0",
            "p == 0",
            "K == p*m + (1 - p)*(a + b)",
            "l == K/2*(1/a + 1/b)",
            "l != 1",
        ),
        numbers("a", "b", "m", "p", "K", "l"),
    ),
    case(
        "REFUTED",
        "eq_5_measurable",
        "w = 1 or w = -1 with probability 1/2 each, whatever happened before: the cost (x - w)^2/2 "
        "has at x the values f and g, which differ, so that what happened before does not "
        "determine it; its mean m is neither",
        ("f == (x - 1)**2/2", "g == (x + 1)**2/2", "f != g", "m == (f + g)/2", "m != f", "m != g"),
        numbers("x", "f", "g", "m"),
    ),
    case(
        "PROVED",
        "eq_6_reduced_formation",
        "for these numbers: I is the identity (I > 0 and II = I), the rows of H and the columns of "
        "N are independent, N is a basis of the kernel of H, W and Y are the inverses of N'N and "
        "HH', and N W N' + H'Y H = I",
        (
            "pd(I)",
            "I*I == I",
            "H*N == 0*(H*N)",
            "N*W*T(N) + T(H)*Y*H == I",
            "pd(H*T(H))",
            "pd(T(N)*N)",
        ),
        dict.fromkeys(("I", "H", "N", "W", "Y"), "matrix"),
    ),
    case(
        "REFUTED",
        "eq_20_weights_measured",
        "the distance rho errs by +-d with probability 1/2 each, and each measured distance z has "
        "the weight 1/z^2: the mean of (z - x)^2/z^2 is least where (z - x)/z^2 has the mean 0, at "
        "an x below rho",
        (
            "d > 0",
            "rho > d",
            "(rho + d - x)*(rho - d)**2 + (rho - d - x)*(rho + d)**2 == 0",
            "x < rho",
        ),
        numbers("rho", "d", "x"),
    ),
)
