"""Variational estimator: what can be asked about it and how its claims are decided."""
