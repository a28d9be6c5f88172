"""What Sanyal & Eslamiat claim about the continuous estimator."""

from __future__ import annotations

from ....claims import Assumption, Claim
from .assumptions import DAMPING, GAINS

EXACT = Assumption(
    "A10",
    "measurements are exact and the weights of the sensors that see the target sum to one, so "
    "that x' = u (8) and the last line of (12) rule alone",
)
FIXED_ENDS = Assumption(
    "A11", "variations of the path are smooth and vanish at both ends of the time interval"
)
CITED = Assumption(
    "A12",
    "Theorem 8.4 of Khalil's Nonlinear Systems (2001) is the one for z' = f(t, z): from V between "
    "two positive definite functions of z and V' <= -W(z) <= 0 it concludes that solutions are "
    "bounded and that W(z(t)) tends to 0",
)

PROPOSITION = Claim(
    id="variational.prop_3_1",
    system="variational",
    source="Sanyal & Eslamiat, Proposition 3.1, (12) and (13)",
    title="The continuous estimator follows from its Lagrangian by the Lagrange-d'Alembert "
    "principle",
    statement="Stationarity of the action of (11) under the force -Cu, for variations that vanish "
    "at both ends, gives the last line of (12).",
    formula=r"M\dot u^0 = -Cu^0 - Kx^0",
    sense="equality",
    assumes=(GAINS, DAMPING, FIXED_ENDS),
)

DISSIPATION = Claim(
    id="variational.eq_15_dissipation",
    system="variational",
    source="Sanyal & Eslamiat, (15)",
    title="The continuous estimator never increases its total energy",
    statement="Along every solution of (12) the energy (14) has the rate -u'Cu, which is at most "
    "zero.",
    formula=r"\dot{\mathcal{E}}(x^0, u^0) = -(u^0)^{\mathsf T}Cu^0 \le 0",
    sense="equality",
    assumes=(GAINS, DAMPING, EXACT),
)

STABILITY = Claim(
    id="variational.theorem_3_2_stability",
    system="variational",
    source="Sanyal & Eslamiat, Theorem 3.2",
    title="Both errors of the continuous estimator tend to zero for all admissible gains",
    statement="The zero of (12) is asymptotically stable, and from every start the position error "
    "and the velocity error tend to zero.",
    formula=r"(x^0(t), u^0(t)) \to (0, 0)",
    sense="property",
    assumes=(GAINS, DAMPING, EXACT),
)

CITATION = Claim(
    id="variational.theorem_3_2_citation",
    system="variational",
    source="Sanyal & Eslamiat, proof of Theorem 3.2, citing Theorem 8.4 of Khalil",
    title="The cited Theorem 8.4 carries the dissipation of energy to convergence of both errors",
    statement="From (14) and (15) alone, the cited theorem concludes that the position error and "
    "the velocity error tend to zero.",
    formula=r"\dot{\mathcal{E}} = -u^{\mathsf T}Cu \;\Rightarrow\; (x, u) \to (0, 0)",
    sense="property",
    assumes=(GAINS, DAMPING, CITED),
)

CLAIMS: tuple[Claim, ...] = (PROPOSITION, DISSIPATION, STABILITY, CITATION)
