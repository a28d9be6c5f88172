"""Consensus on the mean of changing signals: frozen laws, state goes in and comes out."""

from .chatter import chatter_bound
from .isotropic import IsotropicConsensus, IsotropicState
from .linear import LinearConsensus, LinearState
from .members import change_members
from .nodes import DualState, LinkState, NodeState, SignNode, nodes_of
from .stepper import ConsensusState, SignConsensus, StepStatus

__all__ = [
    "ConsensusState",
    "DualState",
    "IsotropicConsensus",
    "IsotropicState",
    "LinearConsensus",
    "LinearState",
    "LinkState",
    "NodeState",
    "SignConsensus",
    "SignNode",
    "StepStatus",
    "change_members",
    "chatter_bound",
    "nodes_of",
]
