"""Decide the two lemmas on graphs, in each of their readings.

Proofs are the identities of `theory.algebra.graphs`, handed to the checker as they were derived.
The counterexample to the reading of Lemma 2 as "any generalized inverse" is searched for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import product
from typing import Any

from sensortrack.networks import Network, read_network
from theory.algebra.identities import Identity
from theory.systems.bearing_dac.lemma_statements import (
    BALANCED,
    EIGENVALUES,
    GENERALIZED,
    MOORE_PENROSE,
    TRIANGLE,
)
from verification.certificates.make import certificate
from verification.exact.evaluate import Rows, add, identity, multiply, scaled
from verification.exact.laplacians.gap_vectors import laplacian_rows
from verification.verdict import Decision, Verdict

SYSTEM = "bearing_dac"
SEARCHED = ("path:2", "path:3")
"""Graphs whose Laplacians the search looks at, smallest first."""
ENTRIES = (0, 1, -1)
NODES = ("a", "b", "c")


def universal(name: str, identities: Sequence[Identity], case: str = "PROVED") -> dict[str, Any]:
    """Certificate of a universal statement, whose witness is how each identity was derived.

    Parameters
    ----------
    name : str
        Name of the statement.
    identities : sequence of Identity
        In the order of the statement's predicates.
    case : str, optional

    Returns
    -------
    dict
        The document.

    Raises
    ------
    CertificateError
        The checker refuses it.
    """
    witness = [{"kind": "derivation", **entry.to_data()} for entry in identities]
    return certificate(SYSTEM, name, {}, witness, case)


def lemma_1_quadratic_form() -> Decision:
    """x'Lx >= 0 for balanced directed graphs, zero on constants only."""
    document = universal("lemma_1_quadratic_form", BALANCED)
    return Decision(
        verdict=Verdict.PROVED,
        reason="L + L' = (O - J)W(O - J)' for the tails O, heads J and weights W of the arcs, as "
        "an identity of matrices of any size modulo the balance of weights; so x'Lx is half the "
        "weighted sum of squared differences along arcs, and connectedness leaves the constants.",
        printed="L positive semidefinite",
        sharp="L + L' positive semidefinite",
        relies_on=tuple(document["relies_on"]),
        certificates={"bearing_dac.lemma_1_quadratic_form": document},
    )


def lemma_1_symmetric() -> Decision:
    """The Laplacian of the directed triangle is not symmetric."""
    refuted = universal("lemma_1_symmetric", TRIANGLE, "REFUTED")
    repaired = universal("lemma_1_symmetric_repair", EIGENVALUES)
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="The directed triangle is strongly connected and balanced, and its Laplacian has "
        "-1 at (a, b) and 0 at (b, a): it is not symmetric, so not a semidefinite matrix in the "
        "usual sense.",
        printed="L = L' >= 0",
        sharp="L + L' >= 0",
        margin_text="not symmetric",
        repair="The symmetric part of L is positive semidefinite, and every eigenvalue of L other "
        "than 0 has a positive real part.",
        repair_formula=r"\mathcal{L}+\mathcal{L}^\top\succeq0,\quad"
        r"\operatorname{Re}\mu>0\ \text{for eigenvalues}\ \mu\ne0",
        certificates={
            "bearing_dac.lemma_1_symmetric": refuted,
            "bearing_dac.lemma_1_symmetric_repair": repaired,
        },
        replay=(("row of L", *NODES), *_triangle_rows()),
    )


def _triangle_rows() -> Iterator[tuple[str, ...]]:
    """L = O(O - J)' of the directed triangle: arc k leads from node k to the next."""
    for node, name in enumerate(NODES):
        head = (node + 1) % len(NODES)
        yield name, *(str((other == node) - (other == head)) for other in range(len(NODES)))


def lemma_2_moore_penrose() -> Decision:
    """LL^+ = M = B(B'B)^+B' with Moore-Penrose inverses."""
    document = universal("lemma_2_moore_penrose", MOORE_PENROSE)
    return Decision(
        verdict=Verdict.PROVED,
        reason="Both identities are multiplied out for matrices of any size modulo e'B = 0, "
        "L = BB', M = LV and the Moore-Penrose conditions LXL = L, (LX)' = LX and B'BZB'B = B'B; "
        "the other conditions are not needed.",
        printed="M = LL^+ = B(B'B)^+B'",
        sharp="the same",
        margin_text="identical",
        relies_on=tuple(document["relies_on"]),
        certificates={"bearing_dac.lemma_2_moore_penrose": document},
    )


def lemma_2_generalized() -> Decision:
    """LG = M fails for a generalized inverse G that is not Moore and Penrose's."""
    found = next(skew_inverses(), None)
    if found is None:
        return Decision(
            verdict=Verdict.UNDECIDED,
            reason=f"stage: search; no counterexample with entries {ENTRIES} on {SEARCHED}",
        )
    network, inverse = found
    refuted = _refutation(network, inverse)
    repaired = universal("lemma_2_generalized_repair", GENERALIZED)
    laplacian = laplacian_rows(network)
    return Decision(
        verdict=Verdict.CORRECTED,
        reason=f"For the graph {network.label} a search for G with LGL = L and the fewest entries "
        "other than 0 finds one with LG unlike M: the product depends on which generalized "
        "inverse is taken.",
        printed="LG = M",
        sharp="LGM = M",
        margin_text=f"false at n = {network.n}",
        repair="LG = M for those generalized inverses G with (LG)' = LG, Moore and Penrose's among "
        "them; for all others LGM = M only. B(B'B)^-B' = M for every generalized inverse.",
        repair_formula=r"\mathcal{L}G=M\iff(\mathcal{L}G)^\top=\mathcal{L}G,\qquad"
        r"\mathcal{B}(\mathcal{B}^\top\mathcal{B})^{-}\mathcal{B}^\top=M",
        relies_on=tuple(repaired["relies_on"]),
        certificates={
            "bearing_dac.lemma_2_generalized": refuted,
            "bearing_dac.lemma_2_generalized_repair": repaired,
        },
        replay=(
            ("matrix", "rows"),
            ("L", _text(laplacian)),
            ("G", _text(inverse)),
            ("LG", _text(multiply(laplacian, inverse))),
            ("M", _text(centring(network.n))),
        ),
    )


def _refutation(network: Network, inverse: Rows) -> dict[str, Any]:
    inputs = {"graph": network.to_data(), "G": inverse}
    return certificate(SYSTEM, "lemma_2_generalized", inputs, [], "REFUTED")


def skew_inverses() -> Iterator[tuple[Network, Rows]]:
    """Search for generalized inverses G of Laplacians with LG unlike M.

    Yields
    ------
    Network
        One of `SEARCHED`.
    Rows
        G with entries among `ENTRIES`, those with the fewest entries other than 0 first.
    """
    for label in SEARCHED:
        network = read_network(label)
        laplacian, mean_free = laplacian_rows(network), centring(network.n)
        for inverse in _candidates(network.n):
            product_ = multiply(laplacian, inverse)
            if multiply(product_, laplacian) == laplacian and product_ != mean_free:
                yield network, inverse


def _candidates(n: int) -> Iterator[Rows]:
    cells = product(ENTRIES, repeat=n * n)
    for flat in sorted(cells, key=lambda entries: sum(map(abs, entries))):
        yield tuple(tuple(Fraction(x) for x in flat[i : i + n]) for i in range(0, n * n, n))


def centring(n: int) -> Rows:
    """M = I - 11'/n."""
    return add(identity(n), scaled(Fraction(-1, n), ((Fraction(1),) * n,) * n))


def _text(rows: Rows) -> str:
    return "; ".join(" ".join(map(str, row)) for row in rows)


LEMMA_DECISIONS: Mapping[str, Callable[[], Decision]] = {
    "bearing_dac.lemma_1_quadratic_form": lemma_1_quadratic_form,
    "bearing_dac.lemma_1_symmetric": lemma_1_symmetric,
    "bearing_dac.lemma_2_moore_penrose": lemma_2_moore_penrose,
    "bearing_dac.lemma_2_generalized": lemma_2_generalized,
}
