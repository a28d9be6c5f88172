"""Printed statements of George that their text does not determine."""

from __future__ import annotations

from ...claims import Gap

GAPS: tuple[Gap, ...] = (
    Gap(
        "George, problem formulation, display 2",
        "the bearing is the row [cos, sin]",
        "a transpose: it is multiplied by rho to give p - s, a column",
    ),
    Gap(
        "George, Theorem 1",
        "the gain is 1 + gamma sqrt(n)/lambda_2, and t* - t0 is |x(t0)|/lambda_2",
        "units: beta and gamma have that of the averaged entry over time, so the 1 is a rate of 1 "
        "m/s for entries of q and of 1/s for those of P, and |x|/lambda_2 has to be divided by it "
        "to be a time; in kilometres the same network would be promised another time",
    ),
    Gap(
        "George, Assumption 2 and Algorithm 1",
        "one gamma and one beta serve all six averaged entries",
        "which unit of length and which origin: rates of q grow with the distance of the sensors "
        "from the origin, those of P do not, and a gain for each would be smaller for one of them",
    ),
    Gap(
        "George, Theorem 1 and Theorem 2",
        "the norm of x(t0) is that of all six entries of all sensors",
        "whether the stacked vector is meant; each entry agrees on its own, and the slowest one "
        "decides",
    ),
    Gap(
        "George, Theorem 1",
        "the algorithm is robust",
        "against what: rates of at most gamma are met exactly; a lost link, a sensor that leaves, "
        "one-way loss and noise in the bearings, which has no rate, are not covered",
    ),
    Gap(
        "George, numerical results, parameters gamma = 100, n^ = 5, lambda2^ = 0.4",
        "the simulations track a maneuvering target",
        "positions, network, speed of the target, step and noise: gamma = 100 may or may not bound "
        "the rates of the run that is drawn",
    ),
    Gap(
        "George, conclusion, point 3",
        "the algorithm can be easily extended to discrete time",
        "which step: with an explicit one it never settles, with an implicit one every step is a "
        "problem for all sensors together",
    ),
    Gap(
        "George, conclusion, point 4",
        "noise, privacy and event-triggered communication are future research",
        "nothing: this is an announcement and no claim",
    ),
)
