"""Exact arithmetic: rationals, definiteness, roots, cuts and routings."""
