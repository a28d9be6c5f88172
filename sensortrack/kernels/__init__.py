"""Loops over graphs and batches in C, with NumPy or Python where no compiler is."""

from sensortrack.kernels.build import Kernel, kernel

__all__ = ["Kernel", "kernel"]
