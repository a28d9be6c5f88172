"""Scenarios from TOML, the engine that runs them, and the run that comes out."""

from .engine import simulate
from .parts import Scenario
from .run import Run
from .scenario import read_scenario, shipped_scenarios

__all__ = ["Run", "Scenario", "read_scenario", "shipped_scenarios", "simulate"]
