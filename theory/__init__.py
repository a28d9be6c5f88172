"""Symbolic truth: what the papers say, as data, and the algebra that derives it."""
