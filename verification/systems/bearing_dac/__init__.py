"""Proofs about bearing sensors that agree by sign-based dynamic average consensus."""
