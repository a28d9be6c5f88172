"""Loops over graphs and batches in C, with NumPy where no compiler is."""
