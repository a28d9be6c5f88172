"""Positions of moving targets by cyclic simultaneous perturbation stochastic approximation.

A sensor follows the targets that it sees, a block of them at a time. For the block whose turn it
is, theta holds the true positions, theta_hat the estimate, H the Hessian of the cost, which is
diagonal for (20). The two costs of a step are taken at two instants, one sample apart, with a
measurement each; taken at one instant, with the same measurement, they are another algorithm with
another limit of the step. Both are decided wherever the text lets both stand.

References
----------
V. Erofeeva, O. Granichin, *Distributed State Estimation of Moving Targets Using Cyclic Simultaneous
Perturbation Stochastic Approximation*, (1) to (20) and Algorithm 1.
"""

from __future__ import annotations

from ...system import Guard, Law, Parameter, Signal, System
from .claims import CLAIMS
from .gaps import GAPS

SIGNALS = (
    Signal("r", (2,), "m", "inertial", "position of target i"),
    Signal("psi", (), "rad", "inertial", "angle of target i at sensor j, from the second axis"),
    Signal("rho", (), "m", "", "distance of target i from sensor j"),
    Signal("z_1", (), "rad", "inertial", "measured angle"),
    Signal("z_2", (), "m", "", "measured distance"),
    Signal("epsilon_1", (), "rad", "", "error of the measured angle"),
    Signal("epsilon_2", (), "m", "", "error of the measured distance"),
    Signal("p", (2,), "m", "inertial", "position computed from the measurement"),
    Signal("xi", (2,), "m", "inertial", "error of that position"),
    Signal("theta_hat", ("d",), "m", "inertial", "estimate of the block's positions"),
    Signal("Delta", ("d",), "1", "", "simultaneous perturbation, entries +1 or -1"),
    Signal("x_minus", ("d",), "m", "inertial", "first point at which the cost is taken"),
    Signal("x_plus", ("d",), "m", "inertial", "second point at which the cost is taken"),
    Signal("q_minus", ("d",), "m", "inertial", "measured positions for the first point"),
    Signal("q_plus", ("d",), "m", "inertial", "measured positions for the second point"),
    Signal("y_minus", (), "m^2", "", "cost at the first point"),
    Signal("y_plus", (), "m^2", "", "cost at the second point"),
    Signal("g", ("d",), "m", "inertial", "pseudogradient"),
)

PARAMETERS = (
    Parameter("s", (2,), "m", "constant", "position of sensor j"),
    Parameter("H", ("d", "d"), "1", "symmetric positive definite", "Hessian of the cost"),
    Parameter("alpha", (), "1", "positive", "step size"),
    Parameter("beta", (), "m", "positive", "size of the perturbation"),
)

LAWS = (
    Law("rho*column(sin(psi), cos(psi))", "r - s", "(10) to (12), all quadrants"),
    Law("z_1", "psi + epsilon_1", "(1), angle"),
    Law("z_2", "rho + epsilon_2", "(1), distance"),
    Law("p", "s + z_2*column(sin(z_1), cos(z_1))", "(13)"),
    Law("p", "r + xi", "(2)"),
    Law("x_minus", "theta_hat - beta*Delta", "Algorithm 1, step 3.2"),
    Law("y_minus", "T(x_minus - q_minus)*H*(x_minus - q_minus)/2", "(20), first point"),
    Law("x_plus", "theta_hat + beta*Delta", "Algorithm 1, step 3.5"),
    Law("y_plus", "T(x_plus - q_plus)*H*(x_plus - q_plus)/2", "(20), second point"),
    Law("g", "Delta*(y_plus - y_minus)/(2*beta)", "Algorithm 1, step 3.8"),
    Law("next(theta_hat)", "theta_hat - alpha*g", "Algorithm 1, step 3.9"),
)

GUARDS = (Guard("apart", "rho > 0", "the target sits on the sensor, which then has no angle"),)

SYSTEM = System(
    name="cyclic_spsa",
    title="Cyclic simultaneous perturbation stochastic approximation for several targets",
    citation="V. Erofeeva, O. Granichin: Distributed State Estimation of Moving Targets Using "
    "Cyclic Simultaneous Perturbation Stochastic Approximation",
    signals=SIGNALS,
    parameters=PARAMETERS,
    laws=LAWS,
    guards=GUARDS,
    claims=CLAIMS,
    gaps=GAPS,
    dimensions={"d": "number of coordinates of the block, two for each of its targets"},
)
