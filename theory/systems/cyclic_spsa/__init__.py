"""Cyclic SPSA: the model, its claims, and what certificates about it prove."""

from .model import SYSTEM
from .statements import STATEMENTS

__all__ = ["STATEMENTS", "SYSTEM"]
