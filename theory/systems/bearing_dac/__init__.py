"""Bearing sensors with consensus: the model, its claims, and what certificates prove."""

from .model import SYSTEM
from .statements import STATEMENTS

__all__ = ["STATEMENTS", "SYSTEM"]
