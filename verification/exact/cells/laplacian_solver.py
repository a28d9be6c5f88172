"""Potentials of currents in a large network, in floating point: proposals, never proofs."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..laplacians.blas import one_thread
from ..laplacians.sparse_ldl import Factor, FactorError, analyse, factorise
from .wiring import Nodes

Floats = NDArray[np.float64]


class Grounded:
    """Laplacian systems of one network whose conductances change; some nodes stay at zero.

    Parameters
    ----------
    n : int
        Number of nodes.
    first, second : ndarray of int32, shape (m,)
        Ends of the edges.
    ground : ndarray of bool, shape (n,)
        One node of every connected part.
    order : ndarray of int32, shape (n,)
        Order of elimination.
    """

    def __init__(
        self,
        n: int,
        first: Nodes,
        second: Nodes,
        ground: NDArray[np.bool_],
        order: Nodes,
    ) -> None:
        self.ground = ground
        edges = np.column_stack([first, second]).astype(np.int64)
        self._symbolic = analyse(n, edges, order)
        self._factor: Factor | None = None

    def factorise(self, conductance: Floats) -> None:
        """Take these conductances, shape (m,), positive, from now on.

        Raises
        ------
        ArithmeticError
            They are too unlike each other.
        """
        self._factor = None  # its memory is needed
        try:
            with one_thread():
                self._factor = factorise(self._symbolic, conductance, self.ground.astype(float))
        except FactorError as error:
            raise ArithmeticError(str(error)) from error

    def solve(self, demand: Floats) -> Floats:
        """Potentials of which the currents leave this much at each node.

        Parameters
        ----------
        demand : ndarray, shape (n, columns)
            With the sum zero in every connected part.

        Returns
        -------
        ndarray, shape (n, columns)
            Near zero at grounded nodes.
        """
        assert self._factor is not None
        with one_thread():
            return self._factor.solve(demand)
