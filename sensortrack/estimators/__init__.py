"""Estimators: frozen values with ``init`` and ``step``; state goes in and comes out."""

from .bearing_dac import BearingDac
from .bearing_state import BearingState
from .variational import Variational, VariationalState

__all__ = ["BearingDac", "BearingState", "Variational", "VariationalState"]
