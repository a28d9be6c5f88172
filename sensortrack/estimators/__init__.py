"""Estimators: frozen values with ``init`` and ``step``; state goes in and comes out."""

from .bearing_dac import BearingDac
from .bearing_state import BearingState
from .cyclic_spsa import CyclicSpsa
from .spsa_state import SpsaState, SpsaStatus
from .variational import Variational, VariationalState

__all__ = [
    "BearingDac",
    "BearingState",
    "CyclicSpsa",
    "SpsaState",
    "SpsaStatus",
    "Variational",
    "VariationalState",
]
