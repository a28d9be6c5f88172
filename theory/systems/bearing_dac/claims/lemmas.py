"""Claims about Laplacians of graphs, in their readings."""

from __future__ import annotations

from ....claims import Claim
from .assumptions import BALANCED, CONNECTED, GENERALIZED, MOORE_PENROSE

SYSTEM = "bearing_dac"

FORM = Claim(
    id="bearing_dac.lemma_1_quadratic_form",
    system=SYSTEM,
    source="George, Lemma 1",
    title="The Laplacian of a balanced directed graph has a quadratic form that is never negative",
    statement="For every x, x'Lx is at least zero; it is zero for constant vectors only; the ones "
    "are a left and a right null vector. (Reading: semidefinite means the quadratic form.)",
    formula=r"x^\top \mathcal{L} x \ge 0, \quad x^\top \mathcal{L} x = 0 \iff x \in "
    r"\operatorname{span}\{\mathbf{1}\}",
    sense="property",
    assumes=(BALANCED,),
)

SYMMETRIC = Claim(
    id="bearing_dac.lemma_1_symmetric",
    system=SYSTEM,
    source="George, Lemma 1",
    title="The Laplacian of a balanced directed graph is symmetric with eigenvalues of at least "
    "zero",
    statement="L equals its transpose and has no negative eigenvalue. (Reading: semidefinite "
    "matrices are symmetric, as most books define.)",
    formula=r"\mathcal{L} = \mathcal{L}^\top \succeq 0",
    sense="property",
    assumes=(BALANCED,),
)

IDENTITY = (
    r"M = \mathcal{L}\mathcal{L}^{+} = \mathcal{B}\mathcal{B}^\top(\mathcal{B}\mathcal{B}^\top)^{+}"
    r" = \mathcal{B}(\mathcal{B}^\top\mathcal{B})^{+}\mathcal{B}^\top"
)

MOORE = Claim(
    id="bearing_dac.lemma_2_moore_penrose",
    system=SYSTEM,
    source="George, Lemma 2",
    title="The Laplacian times its Moore-Penrose inverse removes the mean",
    statement="M = I - 11'/n equals LL^+ and B(B'B)^+B' with the Moore-Penrose inverse.",
    formula=IDENTITY,
    sense="equality",
    assumes=(CONNECTED, MOORE_PENROSE),
)

ANY_INVERSE = Claim(
    id="bearing_dac.lemma_2_generalized",
    system=SYSTEM,
    source="George, Lemma 2",
    title="The Laplacian times any of its generalized inverses removes the mean",
    statement="M = I - 11'/n equals LG for every G with LGL = L. (Reading: the generalized inverse "
    "of the text is any such G.)",
    formula=IDENTITY,
    sense="equality",
    assumes=(CONNECTED, GENERALIZED),
)

CLAIMS: tuple[Claim, ...] = (FORM, SYMMETRIC, MOORE, ANY_INVERSE)
