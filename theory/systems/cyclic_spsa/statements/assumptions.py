"""What certificates about the constants of Assumptions 1 to 5 prove, for quadratic costs.

The cost of a block is (x - theta_t - xi_t)'H(x - theta_t - xi_t)/2, and y = x - theta_(t-1). From
one sample to the next it changes at x by q - y'Hp with p = eta + xi_t - xi_(t-1), so that the mean
square of the change is y'Qy - 2 b'y + e. Only second moments of xi enter Q = H E pp' H and
b = H E pq; e = E q^2 needs the variance of xi'H xi.
"""

from __future__ import annotations

from ....statements import Case, Statement

SPREAD = "(2*trace(H*Xi*H*Xi) + kappa*trace(diag(H*Xi)*diag(H*Xi)))"
"""Variance of xi'H xi: Gaussian for kappa = 0, else with independent coordinates."""

PULL = "T(eta)*H*eta"
FORM = "H*(2*Xi + eta*T(eta))*H"
SLOPE = f"(H*(Xi*H*eta + eta*({PULL})/2))"
LEVEL = f"((({PULL})*({PULL}) + 4*T(eta)*H*Xi*H*eta + 2*{SPREAD})/4)"
"""Q, b and e."""

UNIT = "exists(I, I*H == H)"
SIZES = ("Xi - T(Xi) == 0*H", "T(eta)*eta >= 0", "0*(eta*T(eta)) == 0*H")
"""Xi is symmetric and as large as H, and eta a column of as many entries."""
SETTING = ("pd(H)", *SIZES, "kappa >= -2", "kappa*(Xi - diag(Xi)) == 0*Xi")
INPUTS = {"H": "matrix", "Xi": "matrix", "eta": "matrix"} | dict.fromkeys(
    ("kappa", "mu", "M", "c2", "c3", "c4", "delta"), "number"
)
COST = (
    "the cost of a block is (x - theta - xi)'H(x - theta - xi)/2 with H positive definite and xi "
    "of mean 0 and covariance Xi, symmetric and new in each sample (Gaussian for kappa = 0; else "
    "its coordinates are independent with the excess kurtosis kappa), and theta moves by eta in a "
    "sample: "
)


def semidefinite(matrix: str, name: str) -> str:
    """Predicate that a symmetric matrix is positive semidefinite: L D L' with D > 0."""
    left, pivots = f"L{name}", f"D{name}"
    factored = f"{matrix} == {left}*diag({pivots})*T({left})"
    return f"exists({left}, exists({pivots}, pd(diag({pivots})), {factored}))"


NOISE = semidefinite("Xi", "0")
"""Xi is a covariance."""


def _holds() -> Case:
    words = (
        "mu, M, c2, delta and, for every x, c3 and c4 are constants of Assumptions 1 to 5: "
        "(x - theta)'grad F(x) >= mu |x - theta|^2, grad f is Lipschitz with M, "
        "E|grad f(theta)|^2 <= c2, E(f_t(x) - f_(t-1)(x))^2 <= c3 |x - theta_(t-1)|^2 + c4, and "
        "|eta| <= delta"
    )
    show = (
        *SETTING,
        UNIT,
        "mu > 0",
        semidefinite("H - mu*I", "1"),
        semidefinite("M*I - H", "2"),
        "c2 >= trace(H*Xi*H)",
        semidefinite(f"c3*I - {FORM}", "3"),
        f"exists(z, (c3*I - {FORM})*z == {SLOPE}, c4 >= {LEVEL} + T({SLOPE})*z)",
        "delta >= 0",
        "delta**2 >= T(eta)*eta",
        NOISE,
    )
    return Case("PROVED", COST + words, show)


def _fails(words: str, *show: str) -> Case:
    return Case("REFUTED", COST + words, (*SETTING, *show, NOISE))


def _assumptions() -> Statement:
    change = f"T(y)*{FORM}*y - 2*T({SLOPE})*y + {LEVEL}"
    cases = {
        "PROVED": _holds(),
        "REFUTED_mu": _fails(
            "mu is no constant of Assumption 1, as x'grad F < mu |x|^2 at theta + x shows",
            "exists(x, T(x)*H*x < mu*T(x)*x)",
        ),
        "REFUTED_M": _fails(
            "M is no constant of Assumption 2, as the gradients at theta + x and theta show",
            "exists(x, T(x)*H*x > M*T(x)*x)",
        ),
        "REFUTED_c2": _fails("c2 is below E|grad f(theta)|^2 = tr(H Xi H)", "trace(H*Xi*H) > c2"),
        "REFUTED_c3": _fails(
            "whatever c4 is, E(f_t(x) - f_(t-1)(x))^2 is above c3 |x - theta_(t-1)|^2 + c4 far out "
            "on the line of y",
            f"exists(y, T(y)*{FORM}*y > c3*T(y)*y)",
        ),
        "REFUTED_c4": _fails(
            "E(f_t(x) - f_(t-1)(x))^2 is above c3 |x - theta_(t-1)|^2 + c4 at theta_(t-1) + y",
            f"exists(y, {change} > c3*T(y)*y + c4)",
        ),
        "REFUTED_delta": _fails("|eta| is above delta", "T(eta)*eta > delta**2"),
    }
    return Statement("cyclic_spsa", "assumptions", cases, INPUTS)


ROUND = "(2*trace(Xi*Xi) + kappa*trace(diag(Xi)*diag(Xi)))"
"""Variance of |xi|^2."""

FOURTH = f"(trace(Xi)**2 + {ROUND})"
MOVED = "T(eta)*eta"
FURTHER = f"(({MOVED})*({MOVED}) + 4*T(eta)*Xi*eta + {FOURTH} + 2*({MOVED})*trace(Xi))"
"""E|xi|^4 and E|eta + xi|^4."""


def _of_all() -> Statement:
    words = (
        "the cost of a block is f(x - theta - xi) with f even and its Hessian between low I and "
        "high I everywhere, and xi of mean 0 and covariance Xi, symmetric and new in each sample "
        "(Gaussian for kappa = 0; else its coordinates are independent with the excess kurtosis "
        "kappa), and theta moves by eta in a sample: mu, M, c2, delta and, for every x, c3 and c4 "
        "are constants of Assumptions 1 to 5"
    )
    show = (
        "low > 0",
        "high >= low",
        *SETTING,
        UNIT,
        "H == high*I",
        "mu > 0",
        "mu <= low",
        "M >= high",
        "c2 >= high**2*trace(Xi)",
        semidefinite("c3*I - 2*high**2*(2*Xi + eta*T(eta))", "1"),
        f"c4 >= high**2*({FURTHER} + 2*({MOVED} + trace(Xi))*trace(Xi) + {FOURTH})/2",
        "delta >= 0",
        "delta**2 >= T(eta)*eta",
        NOISE,
    )
    relies = (
        "mean value theorem and Taylor's remainder: |grad f(x) - grad f(y)| <= high |x - y|, "
        "(x - y)'(grad f(x) - grad f(y)) >= low |x - y|^2, and f(y - u) = f(y) - grad f(y)'u + r "
        "with |r| <= high |u|^2/2"
    )
    inputs = INPUTS | {"low": "number", "high": "number"}
    cases = {"PROVED": Case("PROVED", words, show)}
    return Statement("cyclic_spsa", "assumptions_of_all", cases, inputs, relies_on=(relies,))


def _of_two() -> Statement:
    words = (
        "the cost of a block is (x - theta - xi)'H(x - theta - xi)/2 in a sample and the same with "
        "G in the one before it, with xi of mean 0 and covariance Xi, and theta moves by eta in "
        "between: E(f_t(x) - f_(t-1)(x))^2, which is at least the square of the mean, is above "
        "c3 |x - theta_(t-1)|^2 + c4 at theta_(t-1) + y, so that c3 and c4 are no constants of "
        "Assumption 5 with x on both sides"
    )
    mean = f"T(y)*(H - G)*y - 2*T(eta)*H*y + {PULL} + trace((H - G)*Xi)"
    show = (
        "pd(H)",
        "pd(G)",
        *SIZES,
        f"exists(y, ({mean})*({mean}) > 4*(c3*T(y)*y + c4))",
        NOISE,
    )
    inputs = dict.fromkeys(("H", "G", "Xi", "eta"), "matrix") | dict.fromkeys(
        ("c3", "c4"), "number"
    )
    cases = {"REFUTED": Case("REFUTED", words, show)}
    return Statement("cyclic_spsa", "assumptions_of_two", cases, inputs)


STATEMENTS: tuple[Statement, ...] = (_assumptions(), _of_all(), _of_two())
