"""Decisions on claims about cyclic SPSA, each made once for all tests of a run."""

import functools

from verification.systems.cyclic_spsa.claims import DECISIONS


@functools.cache
def decided(name):
    """The decision on ``cyclic_spsa.NAME``."""
    return DECISIONS[f"cyclic_spsa.{name.removeprefix('cyclic_spsa.')}"]()
