"""What certificates about the two lemmas on graphs prove.

Universal statements are written by the identities that prove them, so that the hypotheses and the
goals of a certificate are those of the algebra.
"""

from __future__ import annotations

from ...algebra.graphs import (
    balanced,
    directed_triangle,
    eigenvalues,
    generalized_inverse,
    pseudo_inverse,
)
from ...algebra.identities import Identity
from ...statements import Case, Statement
from ...universal import needed
from .universal import Universal

PATHS = (
    "paths: in a connected graph the difference of any two nodes is a sum of differences along "
    "links, so that M = (O - J)Y for some Y"
)
RANGE = (
    "a symmetric matrix reaches all that is orthogonal to its null vectors; those of a connected "
    "graph's Laplacian are the constants, so that M = LV for some V"
)

BALANCED: tuple[Identity, ...] = needed(balanced())
TRIANGLE: tuple[Identity, ...] = needed(directed_triangle())
EIGENVALUES: tuple[Identity, ...] = needed((eigenvalues(),))
MOORE_PENROSE: tuple[Identity, ...] = needed(pseudo_inverse())
GENERALIZED: tuple[Identity, ...] = needed(generalized_inverse())

ARCS = {
    "O": "matrix: n m",
    "J": "matrix: n m",
    "W": "positive definite: m",
    "L": "matrix: n",
}
"""Symbols of a directed graph: tails, heads and weights of its arcs, and its Laplacian."""

LINKS = {
    "B": "matrix: n m",
    "L": "symmetric: n",
    "M": "symmetric: n",
    "X": "matrix: n",
    "Z": "matrix: m",
    "V": "matrix: n",
    "e": "vector: n",
    "r": "positive",
}
"""Symbols of an undirected graph, with X and Z for the inverses of L and of B'B."""


def _form() -> Statement:
    return Universal(
        "lemma_1_quadratic_form",
        "for every directed graph with tails O, heads J and positive weights W of its arcs that is "
        "weight-balanced (OWO' = JWJ') and connected (M = (O - J)Y), L = OW(O - J)' has row and "
        "column sums 0 and x'Lx + x'L'x = z'Wz >= 0 with the differences z = (O - J)'x along arcs; "
        "x without its mean is Y'z, so x'Lx = 0 for constants only, and 0 is a simple eigenvalue "
        "because Lx = e would give e'e = e'Lx = 0",
        BALANCED,
        ARCS
        | {
            "M": "symmetric: n",
            "Y": "matrix: m n",
            "e": "vector: n",
            "x": "vector: n",
            "r": "positive",
        },
        (PATHS,),
    ).statement


def _symmetric() -> Statement:
    return Universal(
        "lemma_1_symmetric",
        "the directed triangle with unit vectors a, b, c of its nodes and the arcs ab, bc, ca is "
        "strongly connected, being a cycle, and balanced, because its Laplacian has row and column "
        "sums 0; the entry at (a, b) is -1 and at (b, a) is 0, so the Laplacian is not symmetric",
        TRIANGLE,
        {"L": "matrix: n"} | dict.fromkeys("abc", "vector: n"),
        verdict="REFUTED",
    ).statement


def _symmetric_repair() -> Statement:
    return Universal(
        "lemma_1_symmetric_repair",
        "for every weight-balanced directed graph, an eigenvector x + iy of L with the eigenvalue "
        "a + ib has 2a(|x|^2 + |y|^2) = z'Wz + t'Wt >= 0 with the differences z and t of x and y "
        "along arcs; a = 0 only if these are 0, thus, in a connected graph, for constant x + iy "
        "and the eigenvalue 0",
        EIGENVALUES,
        ARCS | {"x": "vector: n", "y": "vector: n", "a": "real", "b": "real"},
    ).statement


def _moore_penrose() -> Statement:
    return Universal(
        "lemma_2_moore_penrose",
        "for every connected graph (M = LV) with incidence matrix B and L = BB', and every X with "
        "LXL = L and (LX)' = LX, as the Moore-Penrose inverse of L has: LX = M = I - ee'/n; and "
        "BZB' = M for every Z with B'BZB'B = B'B, as the Moore-Penrose inverse of B'B has",
        MOORE_PENROSE,
        LINKS,
        (RANGE,),
    ).statement


def _generalized() -> Statement:
    return Statement(
        "bearing_dac",
        "lemma_2_generalized",
        {
            "REFUTED": Case(
                "REFUTED",
                "the graph is connected, G is a generalized inverse of its Laplacian (LGL = L), "
                "and LG is not M = I - 11'/n",
                (
                    "pd(laplacian(graph) + ones(graph))",
                    "laplacian(graph)*G*laplacian(graph) == laplacian(graph)",
                    "laplacian(graph)*G != eye(graph) - 1/nodes(graph)*ones(graph)",
                ),
            )
        },
        inputs={"graph": "graph", "G": "matrix"},
    )


def _generalized_repair() -> Statement:
    return Universal(
        "lemma_2_generalized_repair",
        "for every connected graph (M = LV) and every X with LXL = L: LXM = M, so that LX moves "
        "only what is not of sum zero; and BZB' = M for every Z with B'BZB'B = B'B, symmetric or "
        "not",
        GENERALIZED,
        LINKS,
        (RANGE,),
    ).statement


LEMMA_STATEMENTS = (
    _form(),
    _symmetric(),
    _symmetric_repair(),
    _moore_penrose(),
    _generalized(),
    _generalized_repair(),
)
