"""Searches that end in an exact counterexample."""
