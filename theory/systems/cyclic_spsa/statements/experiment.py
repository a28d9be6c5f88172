"""What certificates about the experiment of section 5 prove."""

from __future__ import annotations

from ....algebra.identities import ONE
from ....algebra.noncommuting import Form, scalars
from ....algebra.rewriting import derive
from ....statements import Case, Statement
from ..descent import term
from ..universal import Universal

SENSORS = 6


def _names(letter: str) -> tuple[str, ...]:
    return tuple(f"{letter}{j}" for j in range(1, SENSORS + 1))


def _interval() -> Universal:
    """Six printed Lipschitz constants cannot all be small."""
    largest, total, mean = scalars("M K mean")
    variances, sums, means = (scalars(" ".join(_names(letter))) for letter in "vpq")
    added = Form({})
    for entry in variances:
        added = added + entry
    scaled = [2 * SENSORS * largest * v for v in variances]
    relations = (
        total - added,
        SENSORS * mean - added,
        *(entry - total - p for entry, p in zip(scaled, sums, strict=True)),
        *(entry - mean - q for entry, q in zip(scaled, means, strict=True)),
    )

    goals = {
        "K": 2 * SENSORS * largest * total - SENSORS * total,
        "mean": 2 * SENSORS**2 * largest * mean - SENSORS * mean,
    }
    proofs = tuple(
        derive(
            name,
            goal,
            relations,
            {k: name} | {2 + SENSORS * k + j: f"M v{j + 1}" for j in range(SENSORS)},
            tuple(map(term, slacks)),
        )
        for k, ((name, goal), slacks) in enumerate(zip(goals.items(), (sums, means), strict=True))
    )
    words = (
        "six sensors whose variances for one target are v1 to v6, and M at least each of the six "
        "printed constants K/(12 vj), with p_sigma = 0: K = v1 + ... + v6 gives 12 M K >= 6 K, so "
        "that M >= 1/2, and with the mean instead of the sum 72 M mean >= 6 mean, so that M >= "
        "1/12. For 12 coordinates the limit of that sensor is at most 1/(432 M): at most 1/216, or "
        "1/36 with the mean, and 1/20 is above both"
    )
    symbols = dict.fromkeys(("M", "K", "mean", *_names("v")), "positive")
    symbols |= dict.fromkeys((*_names("p"), *_names("q")), "nonnegative")
    return Universal("section_5_step_interval", words, proofs, symbols, verdict="REFUTED")


def _slower() -> Universal:
    a, c, f = scalars("a c f")
    relations = (a + c - ONE, f - c * c * c)
    words = {0: "a", 1: "c**3"}
    proofs = (
        derive("three", f - f * f, relations, words, (term(f * a * (ONE + c + c * c)),)),
        derive("one", c - f, relations, words, (term(c * a * (ONE + c)),)),
    )
    said = (
        "an update multiplies the mean error by c = 1 - alpha h, 0 <= c <= 1 (a = alpha h), and "
        "with m_max targets at a time each of six has its turn every 2k samples, k = 6/m_max: "
        "after 12 samples the factor is c^6 for m_max = 6, f = c^3 for 3, and c for 1, and c^6 = "
        "f^2 <= f <= c"
    )
    symbols = dict.fromkeys("acf", "nonnegative")
    return Universal("section_5_few_targets", said, proofs, symbols)


def _best() -> Statement:
    def settled(moment: str, size: int) -> str:
        kept = f"(1 - 2*alpha*h + {size}*(alpha*h)**2)"
        return f"{moment} == {kept}*{moment} + {size}*{size}*(alpha*h)**2*variance"

    words = (
        "six targets at rest, a Hessian of h times the identity, noise of the variance `variance` "
        "in each coordinate and one instant. An update of D coordinates takes the mean square p of "
        "their error to (1 - 2 alpha h + D (alpha h)^2) p + D (alpha h)^2 (D variance), because "
        "the mean of (Delta'x)^2 is x'x and Delta'Delta = D; few and all are its fixed points for "
        "one target and for six at a time. Six times few is below all: with one target at a time "
        "the error that stays is smaller"
    )
    show = (
        "alpha > 0",
        "h > 0",
        "variance > 0",
        "12*alpha*h < 2",
        settled("few", 2),
        settled("all", 12),
        "6*few < all",
    )
    names = ("alpha", "h", "variance", "few", "all")
    return Statement(
        "cyclic_spsa",
        "section_5_most_targets",
        {"REFUTED": Case("REFUTED", words, show)},
        dict.fromkeys(names, "number"),
    )


UNIVERSAL: tuple[Universal, ...] = (_interval(), _slower())
STATEMENTS: tuple[Statement, ...] = (*(entry.statement for entry in UNIVERSAL), _best())
