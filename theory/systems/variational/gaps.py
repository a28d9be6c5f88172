"""Printed statements of Sanyal & Eslamiat that their text does not determine."""

from __future__ import annotations

from ...claims import Gap

GAPS: tuple[Gap, ...] = (
    Gap(
        "Sanyal & Eslamiat, section 1",
        "minimum-energy filters can only be solved approximately, which speaks for this estimator",
        "a nonlinear model: here measurements and motion are linear, and the minimum-energy filter "
        "is a Kalman filter in closed form",
    ),
    Gap(
        "Sanyal & Eslamiat, section 2, citing Robbins",
        "the network is strongly connected by Robbins' theorem",
        "an orientation of the links: that theorem is about one-way links, and with links that "
        "carry both ways strong connection is the assumed path between any two sensors",
    ),
    Gap(
        "Sanyal & Eslamiat, (3)",
        "the measured relative velocity is the true one plus itself",
        "a symbol for the velocity noise; it is read as the true velocity plus that noise",
    ),
    Gap(
        "Sanyal & Eslamiat, section 1",
        "relative velocities can be obtained by filtering relative positions",
        "the filter; the backward difference, which the simulations offer, is one reading",
    ),
    Gap(
        "Sanyal & Eslamiat, sections 1 and 3",
        "the observer is distributed and decentralized",
        "how each sensor gets the two weighted sums, and how late; for a stated number of samples "
        "delay_step_limit answers",
    ),
    Gap(
        "Sanyal & Eslamiat, section 4, Figures 2 to 8",
        "the simulations confirm stability and robustness to noise",
        "the gains M, K, C, the sampling period, the noise, the weights and the trajectories",
    ),
)
