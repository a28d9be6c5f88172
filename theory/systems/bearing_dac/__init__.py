"""Bearing sensors with consensus: the model, its claims, and what certificates prove."""

from .claim_statements import STATEMENTS as CLAIM_STATEMENTS
from .lemma_statements import LEMMA_STATEMENTS
from .model import SYSTEM
from .network_statements import NETWORK_STATEMENTS
from .run_statements import RUN_STATEMENTS
from .statements import STATEMENTS as THEOREM_STATEMENTS

STATEMENTS = (
    *THEOREM_STATEMENTS,
    *RUN_STATEMENTS,
    *NETWORK_STATEMENTS,
    *LEMMA_STATEMENTS,
    *CLAIM_STATEMENTS,
)

__all__ = ["STATEMENTS", "SYSTEM"]
