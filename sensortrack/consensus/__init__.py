"""Consensus on the mean of changing signals: frozen laws, state goes in and comes out."""

from .chatter import chatter_bound
from .stepper import ConsensusState, SignConsensus, StepStatus

__all__ = ["ConsensusState", "SignConsensus", "StepStatus", "chatter_bound"]
