"""Proofs about cyclic SPSA."""
