"""How the forms that the gain of Theorem 1 may have meant are decided.

Each is proved for every graph of any size; beside it stands an exact comparison on every connected
graph on up to seven nodes.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

from sensortrack.networks import read_network
from verification.adversary.universal_graphs import compared, table
from verification.certificates.make import certificate
from verification.verdict import Decision, Verdict

from ..claim_figures import form_over_graphs
from .common import SYSTEM, Document, file_of, lettered, proofs, reliances, squares
from .theorem_1 import gain_repair, time_repair

LABELS = {
    "root": "γ √(n/λ2)",
    "twice": "2γ/λ2",
    "printed": "γ √n/λ2",
}
PATH_GAIN = Fraction(4, 3)
"""Threshold of three sensors in a row for gamma = 1: its middle link carries 2p = 4/3."""


def _seen(form: str, one: bool) -> str:
    """What the comparison on small graphs says, in words."""
    graphs = compared()
    signs = [entry.signs[form] for entry in graphs]
    largest = max(entry.network.n for entry in graphs)
    return (
        f"{'Without the one, compared' if one else 'Compared'} exactly on all {len(graphs)} "
        f"connected graphs on 2 to {largest} nodes, it is below the threshold on {signs.count(-1)} "
        f"and equal to it on {signs.count(0)}."
    )


def _form(
    form: str,
    reason: str,
    certificates: dict[str, Document],
    margin: str,
    one: bool = False,
) -> Decision:
    text = {
        "root": "gamma sqrt(n/lambda_2)",
        "twice": "2 gamma/lambda_2",
        "printed": "gamma sqrt(n)/lambda_2",
    }[form]
    head = ("nodes", "graphs", "fails", "sharp", "over threshold")
    at = table()[0].index(f"{form}: fails")
    rows = [(*row[:2], *row[at : at + 3]) for row in table()[1:]]
    return Decision(
        verdict=Verdict.PROVED,
        reason=f"{reason} {_seen(form, one)}",
        printed=f"1 + {text}" if one else text,
        sharp="largest 2 gamma p/k of a cut",
        margin_text=margin,
        relies_on=reliances(certificates),
        certificates=certificates,
        replay=(head, *rows),
        figure=None if one else form_over_graphs(compared(), form, LABELS[form]),
    )


def root() -> Decision:
    """gamma sqrt(n/lambda_2) by an electrical flow."""
    return _form(
        "root",
        "At this gain the flow B'L^+u, divided by beta, selects signs that balance any "
        "disturbance, and above it the error falls at the rate beta sqrt(lambda_2) - gamma "
        "sqrt(n), as identities for every connected graph.",
        proofs("theorem_1_form_root", "theorem_1_form_root_one"),
        "enough on every network, just enough on two sensors",
    )


def root_one() -> Decision:
    """With the one, a rate and so a time."""
    return _form(
        "root",
        "The differences along links add up to at least sqrt(lambda_2)|x| and a disturbance pushes "
        "with at most gamma sqrt(n)|x|, as identities for every connected graph; so the one that "
        "is added buys the rate sqrt(lambda_2).",
        proofs("theorem_1_form_root_one", "theorem_1_stays_filippov"),
        "enough on every network",
        one=True,
    )


def twice() -> Decision:
    """2 gamma/lambda_2 by x'Lx >= lambda_2 |x|^2 at indicators."""
    return _form(
        "twice",
        "k >= lambda_2 p for every cut, from x'Lx >= lambda_2 |x|^2 at its indicator, for every "
        "connected graph.",
        file_of("theorem_1_form_twice", gain_repair("theorem_1_form_twice")),
        "enough on every network, just enough on complete ones",
    )


def twice_one() -> Decision:
    """With the one, the rate of the repaired time."""
    return _form(
        "twice",
        "k >= 1 and k >= lambda_2 p for every cut give (beta k - 2 gamma p)^2 >= lambda_2 p, a "
        "polynomial with positive coefficients.",
        file_of("theorem_1_form_twice_one", time_repair("theorem_1_form_twice_one")),
        "enough on every network",
        one=True,
    )


def printed() -> Decision:
    """From four nodes on sqrt(n) >= 2; three in a row are looked at."""
    witness = [
        {
            "kind": "derivation",
            "squares": [["2*g", "S", "P"]],
            "relations": [["-2*g*T(S)", "0", "S"]],
        },
        *squares("g**2*a"),
    ]
    network = read_network("path:3")
    path = {"graph": lettered(network), "gamma": Fraction(1), "beta": PATH_GAIN}
    clear: list[Document] = [
        {"kind": "vector", "x": [1, 0, -1]},
        {"kind": "cuts", "parts": [{"kind": "tree"}]},
    ]
    certificates = {
        **file_of(
            "theorem_1_form_printed", certificate(SYSTEM, "theorem_1_form_printed", {}, witness)
        ),
        **file_of(
            "theorem_1_form_printed_path",
            certificate(SYSTEM, "theorem_1_form_printed_path", path, clear),
        ),
    }
    return _form(
        "printed",
        "From four nodes on sqrt(n) >= 2, so it is at least 2 gamma/lambda_2; three sensors in a "
        "row, with lambda_2 = 1, need 4/3 of gamma, less than sqrt(3).",
        certificates,
        "enough but on two sensors and on the triangle",
    )


DECISIONS: Mapping[str, Callable[[], Decision]] = {
    "bearing_dac.theorem_1_form_root": root,
    "bearing_dac.theorem_1_form_root_one": root_one,
    "bearing_dac.theorem_1_form_twice": twice,
    "bearing_dac.theorem_1_form_twice_one": twice_one,
    "bearing_dac.theorem_1_form_printed": printed,
}
