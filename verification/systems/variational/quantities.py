"""What `bound` and `certify` offer about the variational estimator."""

from __future__ import annotations

from verification.answers import Condition, Input, Quantity

from .damping import best_damping
from .delays import delay_step_limit
from .moving import steady_offset
from .noise_gains import noise_gain
from .numbers import abscissa, energy_ratio, spectral_radius
from .peak_gains import peak_gain
from .steps import decide_step, leapfrog_step_limit, step_limit

GAINS = (
    Input("M", "matrix", "inertia-like gain, symmetric positive definite", "kg"),
    Input("K", "matrix", "stiffness-like gain, symmetric positive definite", "kg/s^2"),
    Input("C", "matrix", "damping gain, symmetric positive definite", "kg/s"),
)
STEP = Input("h", "number", "sampling period, above 0", "s")
DELAY = Input("d", "number", "samples by which the position error is late, a whole number")
PLANAR_GAINS = tuple(
    Input(gain.name, "planar matrix", gain.meaning, gain.unit) for gain in GAINS[:2]
)
ACCELERATION = Input("acceleration", "vector", "constant acceleration of the target", "m/s^2")

QUANTITIES = (
    Quantity("step_limit", "supremum of h with (20) Schur stable", GAINS, step_limit, True),
    Quantity(
        "leapfrog_step_limit",
        "the same for the second-order form (dissipation centred at the node)",
        GAINS,
        leapfrog_step_limit,
        True,
    ),
    Quantity("spectral_radius", "of one step of (20)", (*GAINS, STEP), spectral_radius, False),
    Quantity("abscissa", "of the continuous estimator (12)", GAINS, abscissa, False),
    Quantity(
        "energy_ratio",
        "largest one-step growth factor of the printed energy",
        (*GAINS, STEP),
        energy_ratio,
        False,
    ),
    Quantity(
        "noise_gain",
        "stationary traces [cov e from unit white chi, from unit white nu, velocity error from nu]",
        (*GAINS, STEP),
        noise_gain,
        False,
    ),
    Quantity(
        "delay_step_limit",
        "step limit when the position error is used d samples late",
        (*GAINS, DELAY),
        delay_step_limit,
        True,
    ),
    Quantity(
        "peak_gain", "H-infinity norms of the same three maps", (*GAINS, STEP), peak_gain, False
    ),
    Quantity(
        "steady_offset",
        "position error at which (24) settles behind a constant acceleration",
        (*GAINS, STEP, ACCELERATION),
        steady_offset,
        False,
    ),
    Quantity(
        "best_damping",
        "[C, abscissa] of the continuous estimator with the fastest decay, two coordinates",
        PLANAR_GAINS,
        best_damping,
        False,
    ),
)

CONDITIONS = (Condition("step", "(20) is Schur stable at the step h", (*GAINS, STEP), decide_step),)
