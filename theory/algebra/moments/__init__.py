"""Exact moments: of angles, of symmetric laws, of quadratic forms and of random recursions."""

from .angles import COSINE, ONE, SINE, Wave

__all__ = ["COSINE", "ONE", "SINE", "Wave"]
