"""What certificates about Theorem 2 and its proof prove."""

from __future__ import annotations

from itertools import product

from ....statements import Case, Statement
from ..bounds import PRINTED, Bound
from ..target_bound import C2, C4, GIVEN_2, LIPSCHITZ, NESTED, PRINTED_2
from .bound_lines import SIGNS, inputs_of, mean, promise
from .common import BLOCK, WELL_POSED
from .stability import IDENTITY, NOT_DECAYING
from .theorem_2_proofs import UNIVERSAL

NUMBERS_2 = inputs_of(PRINTED_2, GIVEN_2)
WEIGHT = "K/(n*high)"
ONE_TARGET = (
    *("n == 1", "d == 2", "k == 1", "low == high", "K == high", "high > 0"),
    *("ratio == 1", "level == 0"),
)
"""One sensor, one target, noise with |xi|^2 = sigma^2 = high, so that the Hessian is 1."""
SETTING = (
    "one sensor, one target, K = sigma^2, so that the cost is |x - theta - xi|^2/2; xi is one of "
    "four places on the axes at the distance sigma, equally likely and new in every sample, so "
    "that tr Xi = sigma^2, E|xi|^4 = sigma^4 and Xi = sigma^2/2 I"
)
PROMISED_2 = "the step is in the interval of Theorem 2, which promises at most `bound`"
PROMISED_1 = (
    "the step is in the interval of Theorem 1 with the constants mu = M = 1/2, as printed, or 1, "
    "which is sharp, and (21) promises at most `bound`"
)
NESTED_TARGET = (
    "d == 2",
    "k == 1",
    "M == mu",
    "(mu - 1)*(2*mu - 1) == 0",
    "high > 0",
    "c2 == mu*high",
    "c3 == 0",
    "c4 == 0",
    "c_v2 == 0",
)


def _refuted(
    name: str, words: str, show: tuple[str, ...], inputs: dict[str, str] | tuple[str, ...]
) -> Statement:
    kinds = inputs if isinstance(inputs, dict) else dict.fromkeys(inputs, "number")
    return Statement("cyclic_spsa", name, {"REFUTED": Case("REFUTED", words, show)}, kinds)


def _gradient() -> Statement:
    def cost(z: str) -> str:
        return f"K/(2*n*high)*({z} - r)**2"

    words = (
        "for one target, n sensors and sigma^2 = high, the derivative of the mean cost at x, as "
        "its central difference gives it exactly, is not the printed K x/(2 n sigma^2) - r"
    )
    show = (
        "K > 0",
        "n >= 1",
        "high > 0",
        f"slope == ({cost('(x + 1)')} - {cost('(x - 1)')})/2",
        "printed == K*x/(2*n*high) - r",
        "printed != slope",
    )
    return _refuted(
        "theorem_2_gradient", words, show, ("K", "n", "high", "x", "r", "slope", "printed")
    )


def _lipschitz() -> Statement:
    words = (
        "for one target, n sensors and sigma^2 = low, the derivatives of the cost at x + z and x, "
        "as central differences give them, differ by twice the printed M times z"
    )

    def slope(x: str) -> str:
        return f"(K/(2*n*low)*({x} + 1 - r)**2 - K/(2*n*low)*({x} - 1 - r)**2)/2"

    show = (
        "K > 0",
        "n >= 1",
        "low > 0",
        "z > 0",
        f"M == {LIPSCHITZ.text}",
        f"{slope('(x + z)')} - {slope('x')} == 2*M*z",
    )
    return _refuted("theorem_2_lipschitz", words, show, ("K", "n", "low", "x", "z", "r", "M"))


def _c2() -> Statement:
    words = (
        "targets with sigma^2 = high and noise with |xi|^2 = high always: each adds (K/(n "
        "sigma^2))^2 |xi|^2 to the square of the gradient at the true positions, and the sum is "
        "above the printed c2"
    )
    show = (
        "K > 0",
        "n >= 1",
        "high > 0",
        "targets >= 1",
        "ratio == 1",
        f"c2 == {C2.text}",
        f"square == targets*({WEIGHT})*({WEIGHT})*high",
        "square > c2",
    )
    return _refuted(
        "theorem_2_c2", words, show, ("K", "n", "high", "targets", "ratio", "c2", "square")
    )


def _every_point() -> Statement:
    def cost(p: str) -> str:
        return f"K/(2*n*high)*(z - ({p})*shift)**2"

    pairs = list(product(SIGNS, repeat=2))
    changes = [f"({cost(p)} - {cost(q)})*({cost(p)} - {cost(q)})" for p, q in pairs]
    words = (
        "one target with noise of shift or -shift along an axis, equally likely and new in every "
        "sample, shift^2 = sigma^2 = high: the printed c3 and c4 are 0, while at the distance z on "
        "that axis the mean square of the change of the cost is 2 (K/(n sigma^2))^2 sigma^2 z^2"
    )
    show = (
        "K > 0",
        "n >= 1",
        "high > 0",
        "shift**2 == high",
        "level == 0",
        f"c4 == {C4.text}",
        f"forall(z, 0, 1, {mean(changes)} == 2*({WEIGHT})*({WEIGHT})*high*z**2)",
        f"2*({WEIGHT})*({WEIGHT})*high*far**2 > c4",
    )
    names = ("K", "n", "high", "shift", "level", "c4", "far")
    return _refuted("theorem_2_c3_every_point", words, show, names)


LEVEL = "level == targets*(fourth/(high*high) + fourth/(high*high) - 2)"


def _c4() -> Statement:
    values = ("0", "2*high")
    changes = [
        f"({WEIGHT}*({a} - {b})/2)*({WEIGHT}*({a} - {b})/2)" for a, b in product(values, repeat=2)
    ]
    words = (
        "targets with sigma^2 = high and independent noises with |xi|^2 = 0 or 2 high, equally "
        "likely and new in every sample, so that E|xi|^2 = high and E|xi|^4 = fourth as for a "
        "Gaussian in the plane: each adds the mean of (K/(n sigma^2))^2 (|xi_t|^2 - "
        "|xi_(t-1)|^2)^2/4 to the mean square of the change of the cost at the true positions, and "
        "the sum is above the printed c4"
    )
    show = (
        "K > 0",
        "n >= 1",
        "high > 0",
        "targets >= 1",
        f"fourth == {mean(['0', '(2*high)**2'])}",
        LEVEL,
        f"c4 == {C4.text}",
        f"square == targets*({mean(changes)})",
        "square > c4",
    )
    names = ("K", "n", "high", "targets", "fourth", "level", "c4", "square")
    return _refuted("theorem_2_c4", words, show, names)


def _c4_unlike() -> Statement:
    words = (
        "a target whose noise is on a circle, |xi|^2 = sigma^2 = high, in one sample and zero in "
        "the sample before, so that E|xi|^4 is at most fourth = sigma^4 in both and sigma^2 is the "
        "largest variance: the cost at the true position changes by K/(2 n sigma^2) |xi|^2 = "
        "change, and the printed bound on its square is 0"
    )
    show = (
        "K > 0",
        "n >= 1",
        "high > 0",
        "targets == 1",
        "fourth == high*high",
        LEVEL,
        f"c4 == {C4.text}",
        "change == K/(2*n*high)*high",
        "c4 == 0",
        "change > 0",
    )
    names = ("K", "n", "high", "targets", "fourth", "level", "c4", "change")
    return _refuted("theorem_2_c4_unlike", words, show, names)


def _nested() -> Statement:
    words = (
        "the printed l_bar of Theorem 2 is another number than that of Theorem 1 with the same "
        "constants"
    )
    sensor = ("n >= 1", "K > 0", "high >= low", "low > 0")
    show = (*promise(PRINTED_2), *sensor, f"nested == {NESTED}", "l_bar != nested")
    return _refuted("theorem_2_l", words, show, NUMBERS_2 | {"nested": "number"})


def _next(x: str, y: str, first: str, second: str) -> str:
    """First coordinate of the error after a step, in the mean over the noise.

    In the mean the noise adds half of its mean square to either cost.
    """
    late, early = f"({x} - 2*delta)", f"({x} - delta)"
    plus = f"(({late} + {first}*beta)**2 + ({y} + {second}*beta)**2 + high)/2"
    minus = f"(({early} - {first}*beta)**2 + ({y} - {second}*beta)**2 + high)/2"
    return f"({late} - alpha*{first}*({plus} - {minus})/(2*beta))"


def _lag(name: str, bound: Bound, promised: str, fixed: tuple[str, ...]) -> Statement:
    def mean_next(x: str, y: str) -> str:
        return mean([_next(x, y, first, second) for first, second in product(SIGNS, repeat=2)])

    words = (
        f"{promised}; {SETTING}. The target moves by delta along the first axis in every sample, "
        "two instants. The mean of the first coordinate of the error after a step is an affine "
        "function of it, of slope 1 - alpha, that returns `error`, whatever the second coordinate "
        "y is: the mean error tends to it, and its size is above the bound"
    )
    show = (
        *promise(bound),
        *fixed,
        "delta > 0",
        f"forall(y, 0, 1, {mean_next('error', 'y')} == error)",
        f"forall(y, 0, 1, {mean_next('(error + 1)', 'y')} == error + 1 - alpha)",
        f"forall(x, 0, 1, {mean_next('(error + x)', '0')} == error + (1 - alpha)*x)",
        "-error > bound",
    )
    inputs = NUMBERS_2 if bound is PRINTED_2 else inputs_of(PRINTED) | {"high": "number"}
    return _refuted(name, words, show, inputs | {"error": "number"})


def _diverges(name: str, bound: Bound, promised: str, fixed: tuple[str, ...]) -> Statement:
    words = (
        f"{promised}; {SETTING}. For a target at rest and two instants the second moments of the "
        "error do not tend to a limit: some are kept by a step c <= alpha, and larger steps do not "
        "bring them down"
    )
    show = (
        *promise(bound),
        *fixed,
        "delta == 0",
        *WELL_POSED,
        IDENTITY,
        "trace(I) == d",
        "diag(h) == 1*I",
        "H == 0*I",
        "Xi == high/2*I",
        "T(eta)*eta == 0",
        "reading == 2",
        NOT_DECAYING,
    )
    inputs = NUMBERS_2 if bound is PRINTED_2 else inputs_of(PRINTED) | {"high": "number"}
    return _refuted(name, words, show, inputs | BLOCK)


STATEMENTS: tuple[Statement, ...] = (
    *(entry.statement for entry in UNIVERSAL),
    _gradient(),
    _lipschitz(),
    _c2(),
    _every_point(),
    _c4(),
    _c4_unlike(),
    _nested(),
    _diverges("theorem_2_interval", PRINTED_2, PROMISED_2, ONE_TARGET),
    _diverges("theorem_2_interval_nested", PRINTED, PROMISED_1, NESTED_TARGET),
    _lag("theorem_2_bound", PRINTED_2, PROMISED_2, ONE_TARGET),
    _lag("theorem_2_bound_nested", PRINTED, PROMISED_1, NESTED_TARGET),
)
