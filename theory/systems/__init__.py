"""The estimators, each a folder; this tuple is the list that everything else walks."""

from ..statements import Statement
from ..system import System
from . import bearing_dac, cyclic_spsa, variational

MODULES = (bearing_dac, cyclic_spsa, variational)
"""Each offers SYSTEM and STATEMENTS."""

SYSTEMS: tuple[System, ...] = tuple(module.SYSTEM for module in MODULES)

STATEMENTS: tuple[Statement, ...] = tuple(
    statement for module in MODULES for statement in module.STATEMENTS
)

__all__ = ["STATEMENTS", "SYSTEMS"]
