"""Discrete Lagrange-d'Alembert principle: from an action and a force to the recursion.

Marsden & West, *Discrete mechanics and variational integrators*, Acta Numerica 10 (2001), part 3.
The action sum is h L(x_0, u_0) + ... + h L(x_{N-1}, u_{N-1}) with u_k = (x_{k+1} - x_k)/h. A
variation of the inner node x_k by h e d changes x_k, u_{k-1} and u_k only, so that one equation
in u_{k-1} ("v"), x_k ("x") and u_k ("u") says everything, whatever N is.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from .noncommuting import Form, inverse, letters, scalars

Lagrangian = Callable[[Form, Form], Form]
"""L(x, u) for position and velocity errors, a form of shape 1 by 1."""

Force = Callable[[Form, Form], Form]
"""F(u_{k-1}, u_k), the force at node k."""


@dataclass(frozen=True)
class Recursion:
    """A2 x_{k+2} + A1 x_{k+1} + A0 x_k = 0, the coefficients being forms in h and the gains."""

    a2: Form
    a1: Form
    a0: Form


def first_variation(lagrangian: Lagrangian, last_term: bool = False) -> Form:
    """Gradient of the action sum at an inner node, divided by h.

    Parameters
    ----------
    lagrangian : callable
        L(x, u).
    last_term : bool, optional
        Take the variation at the node x_{N+1} that only the last term h L(x_N, u_N) reaches, as a
        sum up to k = N instead of N - 1 would demand.

    Returns
    -------
    Form
        The g of delta S = (h d)' g, in the letters v = u_{k-1}, x = x_k, u = u_k.
    """
    x, u, v, y, d = letters("x u v y d")
    h, e = scalars("h e")
    before = h * lagrangian(y, v + e * d)
    after = Form({}) if last_term else h * lagrangian(x + e * h * d, u - e * d)
    slope = (before + after).coefficient("e", 1)
    return inverse(h) * (slope.after("d'") + slope.T.after("d'"))


def discrete_equation(lagrangian: Lagrangian, force: Force) -> Form:
    """Left side of the discrete forced Euler-Lagrange equation, zero along every solution.

    Parameters
    ----------
    lagrangian : callable
        L(x, u).
    force : callable
        F(u_{k-1}, u_k), entering as h F' delta x_k.

    Returns
    -------
    Form
        In the letters v = u_{k-1}, x = x_k, u = u_k.
    """
    u, v = letters("u v")
    (h,) = scalars("h")
    return first_variation(lagrangian) + h * force(v, u)


def recursion(equation: Form) -> Recursion:
    """Eliminate the velocities of `discrete_equation` by u_k = (x_{k+1} - x_k)/h.

    The sign is chosen so that a2 multiplies the newest position positively.
    """
    x0, x1, x2 = letters("x0 x1 x2")
    (h,) = scalars("h")
    values = {"v": inverse(h) * (x1 - x0), "u": inverse(h) * (x2 - x1), "x": x1}
    left = -(h * equation.substitute(values))
    return Recursion(left.before("x2"), left.before("x1"), left.before("x0"))
