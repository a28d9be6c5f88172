"""Estimators: frozen values with ``init`` and ``step``; state goes in and comes out."""

from .variational import Variational, VariationalState

__all__ = ["Variational", "VariationalState"]
