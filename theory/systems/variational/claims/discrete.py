"""What Sanyal & Eslamiat claim about the discrete estimator."""

from __future__ import annotations

from ....claims import Claim
from .assumptions import DAMPING, GAINS, NOISELESS, STEP

PROPOSITION = Claim(
    id="variational.prop_4_1",
    system="variational",
    source="Sanyal & Eslamiat, Proposition 4.1 and (20)",
    title="The discrete estimator follows from an action by the discrete Lagrange-d'Alembert "
    "principle",
    statement="Stationarity of the action sum (21) under the force -Cu_k, for variations that "
    "vanish at both ends, gives the last line of (20).",
    formula=r"(M + hC)\,u_{k+1} = M u_k - hK x_{k+1}",
    sense="equality",
    assumes=(GAINS, DAMPING, STEP),
)

ENERGY = Claim(
    id="variational.discrete_energy",
    system="variational",
    source="Sanyal & Eslamiat, after (23)",
    title="The discrete estimator never increases its total energy",
    statement="Along every solution of (20), the sum of the kinetic and the potential energy-like "
    "term at one index is not larger a sample later.",
    formula=r"\mathcal{T}(u_{k+1}) + \mathcal{U}(x_{k+1}) \le \mathcal{T}(u_k) + \mathcal{U}(x_k)",
    sense="property",
    assumes=(GAINS, DAMPING, STEP, NOISELESS),
)

PAIRING = Claim(
    id="variational.discrete_energy_pairing",
    system="variational",
    source="Sanyal & Eslamiat, after (23), the potential term read at the newer position",
    title="The discrete estimator never increases the energy of its newer position",
    statement="Along every solution of (20), kinetic term at one index plus potential term at the "
    "next is not larger a sample later.",
    formula=r"\mathcal{T}(u_{k+1}) + \mathcal{U}(x_{k+2}) \le \mathcal{T}(u_k) + "
    r"\mathcal{U}(x_{k+1})",
    sense="threshold",
    assumes=(GAINS, DAMPING, STEP, NOISELESS),
    printed="every h > 0",
)

STABILITY = Claim(
    id="variational.discrete_stability",
    system="variational",
    source="Sanyal & Eslamiat, after (23)",
    title="The discrete estimator is stable for every sampling period",
    statement="Every solution of (20) tends to zero, however large the sampling period h is.",
    formula=r"(x_k, u_k) \to 0 \quad \text{for every } h > 0",
    sense="threshold",
    assumes=(GAINS, DAMPING, STEP, NOISELESS),
    printed="every h > 0",
)

CLAIMS = (PROPOSITION, ENERGY, PAIRING, STABILITY)
