"""Printed statements of Sanyal & Eslamiat that their text does not determine."""

from __future__ import annotations

from ...claims import Gap

GAPS: tuple[Gap, ...] = (
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
