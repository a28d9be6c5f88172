"""Settings of cyclic SPSA that a scenario asks for."""

from __future__ import annotations

from dataclasses import dataclass, replace

from sensortrack.tables import Vector

from .parts import Scenario

SCALES = ("harmonic", "sum", "mean")
"""K of the weights K/(n sigma^2): so that they add up to one, or of sigma^2 over the sensors."""


@dataclass(frozen=True)
class EstimatorPart:
    """Step, perturbation, limits on neighbours and targets a step; ``scale`` is K of the weights.

    ``reach_m`` is how far sensors see, 0 for without limit; ``diverged_m`` the error above which
    a run counts as diverged.
    """

    system: str
    h_s: float
    alpha: float
    beta_m: float
    n_max: int
    m_max: int
    reading: str = "two"
    scale: str = "harmonic"
    reach_m: float = 0.0
    diverged_m: float = 1e7


@dataclass(frozen=True)
class StartPart:
    """Box in which first estimates are drawn, each coordinate by itself."""

    low_m: Vector
    high_m: Vector


@dataclass(frozen=True)
class VariantPart:
    """Another setting that runs on the same data; what is left out is the estimator's."""

    name: str
    alpha: float | None = None
    beta_m: float | None = None
    reading: str | None = None
    n_max: int | None = None
    m_max: int | None = None


@dataclass(frozen=True)
class Variant:
    """One setting of the algorithm; `table` is where it is said."""

    name: str
    alpha: float
    beta_m: float
    reading: str
    n_max: int
    m_max: int
    table: str = "estimator"


def variants(scenario: Scenario) -> tuple[Variant, ...]:
    """The settings that run: the estimator's, unless variants are listed."""
    part = scenario.estimator
    limits = (part.n_max, part.m_max)
    base = Variant("cyclic_spsa", part.alpha, part.beta_m, part.reading, *limits)
    listed = tuple(
        replace(base, table="variant", **{k: v for k, v in vars(entry).items() if v is not None})
        for entry in scenario.parts["variant"]
    )
    return listed or (base,)
