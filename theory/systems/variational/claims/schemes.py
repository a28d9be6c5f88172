"""Claims about the action sum, and about damping that is not symmetric."""

from __future__ import annotations

from ....claims import Assumption, Claim
from .assumptions import DAMPING, GAINS, NOISELESS, STEP

PLAIN = Assumption("A30", "C + C' is positive definite; C need not be symmetric")
BELOW = Assumption("A31", "4M + h(C + C') - h^2 K is positive definite")

ACTION = Claim(
    id="variational.eq_21_action",
    system="variational",
    source="Sanyal & Eslamiat, (21)",
    title="The action sum runs over all samples, the last one included",
    statement="The recursion (20) makes the sum (21) stationary, whose last term is that of "
    "sample N.",
    formula=r"\sum_{k=0}^{N} h\,\mathcal{L}_k",
    sense="equality",
    assumes=(GAINS, DAMPING, STEP),
    printed="up to N",
)

UNSYMMETRIC = Claim(
    id="variational.discrete_stability_unsymmetric",
    system="variational",
    source="Sanyal & Eslamiat, Proposition 4.1 and after (23)",
    title="Damping that is positive definite but not symmetric keeps the step limit",
    statement="Reading: a matrix C is positive definite if its quadratic form is. Every solution "
    "of (20) tends to zero while 4M + h(C + C') - h^2 K is positive definite.",
    formula=r"(x_k, u_k) \to 0",
    sense="property",
    assumes=(GAINS, PLAIN, BELOW, NOISELESS),
    printed="stable",
)

CLAIMS: tuple[Claim, ...] = (ACTION, UNSYMMETRIC)
