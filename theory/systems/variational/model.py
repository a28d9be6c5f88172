"""Variational observer of a target's position and velocity, in continuous and discrete time.

Errors are signals of their own: x and u are built from what the sensors measure, (6) and (7). The
gains carry mechanical units, so that the energy-like terms are joules and every law can be checked.

References
----------
A. Sanyal, H. Eslamiat, *Target Localization Using Mobile Sensors and a Decentralized and
Distributed Variational Estimator*, equations (1) to (20).
"""

from __future__ import annotations

from ...system import Guard, Law, Parameter, Signal, System
from .claims import CLAIMS
from .gaps import GAPS

SIGNALS = (
    Signal("b", (3,), "m", "inertial", "position of the target"),
    Signal("v", (3,), "m/s", "inertial", "velocity of the target"),
    Signal("b_i", (3,), "m", "inertial", "position of sensor i"),
    Signal("v_i", (3,), "m/s", "inertial", "velocity of sensor i"),
    Signal("b_0i", (3,), "m", "inertial", "position of sensor i relative to the target"),
    Signal("v_0i", (3,), "m/s", "inertial", "velocity of sensor i relative to the target"),
    Signal("chi_i", (3,), "m", "inertial", "noise of the measured relative position, sensor i"),
    Signal("nu_i", (3,), "m/s", "inertial", "noise of the measured relative velocity, sensor i"),
    Signal("b_m0i", (3,), "m", "inertial", "measured position of sensor i relative to the target"),
    Signal("v_m0i", (3,), "m/s", "inertial", "measured velocity of sensor i, relative"),
    Signal("b_hat", (3,), "m", "inertial", "estimate of the target's position"),
    Signal("v_hat", (3,), "m/s", "inertial", "estimate of the target's velocity"),
    Signal("x", (3,), "m", "inertial", "position error, from what the sensors measure"),
    Signal("u", (3,), "m/s", "inertial", "velocity error, the observer's own state"),
    Signal("L", (), "J", "", "Lagrangian: kinetic minus potential energy-like term"),
    Signal("E", (), "J", "", "total energy-like term"),
)

PARAMETERS = (
    Parameter("lambda_i", (), "1", "weights", "weight of sensor i among those that see the target"),
    Parameter("M", (3, 3), "kg", "symmetric positive definite", "gain of the kinetic term"),
    Parameter("K", (3, 3), "kg/s^2", "symmetric positive definite", "gain of the potential term"),
    Parameter("C", (3, 3), "kg/s", "symmetric positive definite", "gain of the dissipation"),
    Parameter("h", (), "s", "positive", "sampling period"),
)

LAWS = (
    Law("b_0i", "b_i - b", "(1)"),
    Law("v_0i", "v_i - v", "(2), difference"),
    Law("v_0i", "d(b_0i)", "(2), derivative"),
    Law("b_m0i", "b_0i + chi_i", "(3), position"),
    Law("v_m0i", "v_0i + nu_i", "(3), velocity"),
    Law("x", "b_hat - sum(lambda_i*(b_i - b_0i))", "(6)"),
    Law("u", "v_hat - sum(lambda_i*(v_i - v_0i))", "(7)"),
    Law("d(x)", "u", "(8)"),
    Law("L", "(T(u)*M*u - T(x)*K*x)/2", "(11)"),
    Law("d(b_hat)", "v_hat", "(12), first line"),
    Law("M*d(u)", "-C*u - K*x", "(12), last line"),
    Law("E", "(T(u)*M*u + T(x)*K*x)/2", "(14)"),
    Law("u", "(next(x) - x)/h", "(19)"),
    Law("x", "b_hat - sum(lambda_i*(b_i - b_m0i))", "(6), measured: reading A of the noise"),
    Law("u", "v_hat - sum(lambda_i*(v_i - v_m0i))", "(7), measured: reading A of the noise"),
    Law("next(x)", "x + h*u", "(17), propagated: reading B of the noise"),
    Law("next(b_hat)", "b_hat + h*v_hat", "(20), first line"),
    Law("(M + h*C)*next(u)", "M*u - h*K*next(x)", "(20), last line"),
    Law("(M + h*C/2)*next(u)", "(M - h*C/2)*u - h*K*next(x)", "(20) by the trapezoidal rule"),
)

GUARDS = (
    Guard(
        "seen",
        "sum(lambda_i) == 1",
        "no sensor sees the target, or weights were not rescaled after a change of the set: "
        "the reference of x and u is not the target",
    ),
)

SYSTEM = System(
    name="variational",
    title="Variational observer of position and velocity",
    citation="A. Sanyal, H. Eslamiat: Target Localization Using Mobile Sensors and a Decentralized "
    "and Distributed Variational Estimator",
    signals=SIGNALS,
    parameters=PARAMETERS,
    laws=LAWS,
    guards=GUARDS,
    claims=CLAIMS,
    gaps=GAPS,
)
