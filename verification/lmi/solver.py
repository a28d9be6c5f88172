"""The only place that speaks to a solver of semidefinite programs; nothing it says is believed."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from typing import Any

import numpy as np

from sensortrack.errors import MissingExtra

from .affine import Affine, Unknown


def maximal_margin(
    positive: Mapping[str, Affine], unknowns: Mapping[str, Unknown], box: float | None
) -> tuple[str, float | None, dict[str, Any]]:
    """What the solver says: status, largest margin, values of the unknowns; all to be doubted.

    Parameters
    ----------
    positive : mapping of str to Affine
        The blocks that are to be at least t I, with t as large as possible.
    unknowns : mapping of str to Unknown
        All unknowns, by name.
    box : float or None
        Bound on the entries of the unknowns; None: the traces of the blocks sum up to their sizes.

    Returns
    -------
    status : str
    margin : float or None
        None if there are no numbers.
    values : dict of str to array

    Raises
    ------
    MissingExtra
        cvxpy or Clarabel is not installed.
    """
    try:
        import clarabel  # noqa: F401 - cvxpy would name it only when solving
        import cvxpy
    except ImportError as error:
        raise MissingExtra(error.name or "cvxpy", "verify") from error

    variables = {
        name: cvxpy.Variable((u.rows, u.columns), symmetric=u.symmetric and u.rows > 1)
        for name, u in unknowns.items()
    }
    t = cvxpy.Variable()
    blocks = [affine.expression(variables) for affine in positive.values()]
    rules = [(b + b.T) / 2 - t * np.eye(b.shape[0]) >> 0 for b in blocks]
    if box is None:
        traces = [b[i, i] for b in blocks for i in range(b.shape[0])]
        rules.append(sum(traces) == len(traces))
    else:
        rules += [side * x <= box for x in variables.values() for side in (1, -1)]
    problem = cvxpy.Problem(cvxpy.Maximize(t), rules)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # that the status is inaccurate, which is passed on
            problem.solve(solver=cvxpy.CLARABEL)
    except cvxpy.SolverError as error:
        return str(error).splitlines()[0], None, {}
    if t.value is None or any(x.value is None for x in variables.values()):
        return str(problem.status), None, {}
    values = {name: np.asarray(x.value, dtype=float) for name, x in variables.items()}
    return str(problem.status), float(t.value), values
