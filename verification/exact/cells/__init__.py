"""Routings of large networks, cell by cell."""
