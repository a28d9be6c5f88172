"""Numeric steppers, generated from theory; never edited by hand."""
