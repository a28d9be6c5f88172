"""What certificates about the variational estimator prove, in the order of the paper."""

from __future__ import annotations

from ....statements import Statement
from . import continuous, design, discrete, framework, late, noise, schemes

STATEMENTS: tuple[Statement, ...] = (
    *framework.STATEMENTS,
    *continuous.STATEMENTS,
    *noise.STATEMENTS,
    *discrete.STATEMENTS,
    *schemes.STATEMENTS,
    *late.STATEMENTS,
    *design.STATEMENTS,
)
