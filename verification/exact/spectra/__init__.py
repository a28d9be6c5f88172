"""Eigenvalues, decay and peaks of dense matrices, enclosed."""
