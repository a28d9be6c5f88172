"""Position of a target from bearings, by sign-based dynamic average consensus.

Each of the six entries that the sensors average has its own copy of the consensus laws, so w, x, r
and e_x stand for one entry of all n sensors. Its unit is left open ("c"): 1 for the entries of P, m
for those of q. The printed beta is common to all six, which the units do not allow in general.

The law for w is printed with sgn, and so has no solution that stays in agreement. It is read as a
differential inclusion: the derivative of w is -beta B g for some selection g of SGN(B'x), where the
set-valued SGN is {-1}, [-1, 1] or {1} below, at and above zero. For the error this is
d(e_x) in -beta B SGN(B' e_x) + M d(r), minus beta times the subdifferential of the total variation
|B' e_x|_1, plus the disturbance: it has exactly one solution from every start.

References
----------
J. George, *Distributed Tracking of Maneuvering Target: A Finite-Time Algorithm*, Algorithm 1.
"""

from __future__ import annotations

from ...system import Guard, Law, Parameter, Signal, System
from .claims import CLAIMS
from .gaps import GAPS

SIGNALS = (
    Signal("p", (2,), "m", "inertial", "position of the target"),
    Signal("v", (2,), "m/s", "inertial", "velocity of the target"),
    Signal("theta", (), "rad", "inertial", "bearing of the target at sensor i"),
    Signal("rho", (), "m", "", "distance of the target from sensor i"),
    Signal("phi", (2,), "1", "inertial", "unit vector from sensor i to the target"),
    Signal("h", (2,), "1", "inertial", "phi turned by a right angle, counter-clockwise"),
    Signal("z", (), "m", "", "offset of the line of sight of sensor i"),
    Signal("P", (2, 2), "1", "inertial", "what sensor i knows about the target's position"),
    Signal("q", (2,), "m", "inertial", "the same, times the position"),
    Signal("p_star", (2,), "m", "inertial", "least-squares position from all bearings"),
    Signal("r", ("n",), "c", "sensors", "one entry of P or q, of each sensor: what is averaged"),
    Signal("w", ("n",), "c", "sensors", "internal state of each sensor"),
    Signal("x", ("n",), "c", "sensors", "estimate that each sensor has of the average of r"),
    Signal("e_x", ("n",), "c", "sensors", "error of consensus: x minus the average of r"),
    Signal("P_x", (2, 2), "1", "inertial", "estimate that sensor i has of the average of P"),
    Signal("q_x", (2,), "m", "inertial", "estimate that sensor i has of the average of q"),
    Signal("p_i", (2,), "m", "inertial", "position that sensor i computes"),
)

PARAMETERS = (
    Parameter("s", (2,), "m", "constant", "position of sensor i"),
    Parameter("B", ("n", "m"), "1", "incidence", "incidence matrix of the graph of links"),
    Parameter("L", ("n", "n"), "1", "Laplacian", "Laplacian of that graph"),
    Parameter("e", ("n",), "1", "ones", "the vector of ones"),
    Parameter("beta", (), "c/s", "positive", "gain of the consensus"),
    Parameter("gamma", (), "c/s", "nonnegative", "bound on the rate of every averaged entry"),
)

LAWS = (
    Law("d(p)", "v", "target"),
    Law("rho*phi", "p - s", "bearing"),
    Law("phi", "column(cos(theta), sin(theta))", "bearing, as an angle"),
    Law("h", "column(-sin(theta), cos(theta))", "Proposition 1"),
    Law("z", "T(h)*s", "measurement"),
    Law("P", "h*T(h)", "Algorithm 1, line 5"),
    Law("q", "z*h", "Algorithm 1, line 6"),
    Law("p_star", "inv(mean(P))*mean(q)", "averaged solution"),
    Law("L", "B*T(B)", "Lemma 2"),
    Law("d(w)", "-beta*B*sgn(T(B)*x)", "Algorithm 1, line 9"),
    Law("x", "w + r", "Algorithm 1, line 8"),
    Law("e_x", "x - e*T(e)*r/(T(e)*e)", "error of consensus"),
    Law("p_i", "inv(P_x)*q_x", "Algorithm 1, line 12"),
)

GUARDS = (
    Guard("apart", "rho > 0", "the target sits on a sensor, which then has no bearing"),
    Guard("observable", "det(mean(P)) > 0", "target and sensors are on one line (Assumption 1)"),
    Guard("bounded", "largest(d(r)) <= gamma", "what is averaged moves too fast (Assumption 2)"),
    Guard("balanced", "T(e)*w == 0", "the internal states do not start at sum zero: an offset"),
    Guard("invertible", "det(P_x) != 0", "sensor i cannot compute a position, as at the start"),
)

SYSTEM = System(
    name="bearing_dac",
    title="Bearing sensors with sign-based dynamic average consensus",
    citation="J. George: Distributed Tracking of Maneuvering Target: A Finite-Time Algorithm",
    signals=SIGNALS,
    parameters=PARAMETERS,
    laws=LAWS,
    guards=GUARDS,
    claims=CLAIMS,
    gaps=GAPS,
    dimensions={"n": "number of sensors", "m": "number of links"},
    units={"c": "unit of the averaged entry: 1 for entries of P, m for entries of q"},
)
