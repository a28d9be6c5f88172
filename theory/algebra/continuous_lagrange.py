"""Continuous Lagrange-d'Alembert principle: from an action and a force to a system of order 2.

Forms are those of `theory.algebra.lagrange`: L(x, u) with u = dx/dt, and a force F(x, u). The
variation of the path by e d, with d' = p, changes the action's integrand by

    L(x + e d, u + e p) - L(x, u) = e (d'dL/dx + p'dL/du) + terms of higher order in e,

and the bracket plus the work d'F is the rate of d'dL/du less d' (left side of the equation of
motion). The rate integrates to zero when d vanishes at both ends; what is left must be zero
because d is arbitrary.

Letters: ``x``, ``u`` and ``w`` for position, velocity and acceleration, ``d`` and ``p`` for the
variation and its rate. A number that is a product of letters differs from its transpose as a
word, so that numbers are written as half the sum of the two, `symmetrised`.

References
----------
H. Goldstein, *Classical Mechanics*, 2nd ed. (1980), chapters 1 and 2.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from .identities import ONE, Identity, Square
from .lagrange import Lagrangian
from .noncommuting import Form, letters, scalars
from .quadratic_forms import gradient, symmetrised
from .rewriting import derive

Force = Callable[[Form, Form], Form]
"""F(x, u), the force at position x and velocity u."""

MOTION = {"x": letters("u")[0], "u": letters("w")[0], "d": letters("p")[0]}
"""The rate of each letter that moves."""

CLOCK = "clock"


@dataclass(frozen=True)
class SecondOrder:
    """mass w + damping u + stiffness x = 0, the coefficients being forms in the gains."""

    mass: Form
    damping: Form
    stiffness: Form

    @property
    def left(self) -> Form:
        """Left side of the equation, in the letters w, u, x."""
        x, u, w = letters("x u w")
        return self.mass * w + self.damping * u + self.stiffness * x


def unrestricted(form: Form, *names: str) -> Form:
    """The same form where these letters need not equal their transposes.

    Parameters
    ----------
    form : Form
    *names : str
        Letters that were declared symmetric.

    Returns
    -------
    Form
    """
    return Form(form.terms, form.symmetric - frozenset(names))


def along(form: Form, rates: Mapping[str, Form] = MOTION) -> Form:
    """Time derivative of a form by the product rule.

    Parameters
    ----------
    form : Form
    rates : mapping of str to Form, optional
        Letters that move, and their derivatives; u for x, w for u and p for d unless told.

    Returns
    -------
    Form
    """
    (t,) = scalars(CLOCK)
    moved = {name: letters(name, form.symmetric)[0] + t * rate for name, rate in rates.items()}
    return form.substitute(moved).coefficient(CLOCK, 1)


def equation(lagrangian: Lagrangian, force: Force) -> Form:
    """Left side of d/dt dL/du - dL/dx - F = 0.

    Parameters
    ----------
    lagrangian : callable
        L(x, u).
    force : callable
        F(x, u).

    Returns
    -------
    Form
        In the letters x, u and w = du/dt.
    """
    x, u = letters("x u")
    action = lagrangian(x, u)
    return along(gradient(action, "u")) - gradient(action, "x") - force(x, u)


def second_order(motion: Form) -> SecondOrder:
    """Coefficients of an equation of motion that is linear.

    Parameters
    ----------
    motion : Form
        As `equation` returns it.

    Returns
    -------
    SecondOrder

    Raises
    ------
    ValueError
        Something is left that is no multiple of w, u or x.
    """
    found = SecondOrder(motion.before("w"), motion.before("u"), motion.before("x"))
    rest = motion - found.left
    if rest.terms:
        raise ValueError(f"motion: {rest} is left; a sum of multiples of w, u and x is needed")
    return found


def pairing(left: Form, right: Form) -> Form:
    """The number left'right, written as half the sum with its transpose."""
    return symmetrised(left.T * right)


def first_variation(lagrangian: Lagrangian) -> Form:
    """First variation d'dL/dx + p'dL/du of the action's integrand.

    Parameters
    ----------
    lagrangian : callable
        L(x, u).

    Returns
    -------
    Form
        In the letters x, u, d, p.
    """
    x, u, d, p = letters("x u d p")
    action = lagrangian(x, u)
    return pairing(d, gradient(action, "x")) + pairing(p, gradient(action, "u"))


def principle(lagrangian: Lagrangian, force: Force) -> tuple[Identity, Identity, Identity]:
    """The principle as identities: they hold for every path and every variation.

    Parameters
    ----------
    lagrangian : callable
        L(x, u), quadratic.
    force : callable
        F(x, u).

    Returns
    -------
    tuple of Identity
        The integrand's change is e times the first variation plus e^2 L(d, p); the rate of the
        boundary term is what the product rule says; the first variation plus the work of the
        force is that rate less d' (left side of the equation of motion).

    Raises
    ------
    ValueError
        The Lagrangian is not quadratic.
    """
    x, u, w, d, p = letters("x u w d p")
    e, h = scalars("e h")
    first = first_variation(lagrangian)
    boundary = pairing(d, gradient(lagrangian(x, u), "u"))
    moved = boundary.substitute({"d": d + h * p, "u": u + h * w})
    change = lagrangian(x + e * d, u + e * p) - lagrangian(x, u) - e * e * lagrangian(d, p)
    second = boundary.substitute({"d": p, "u": w})
    work = pairing(d, force(x, u)) + pairing(d, equation(lagrangian, force))
    return (
        derive("the integrand's change", change - e * first, (), {}),
        derive(
            "the boundary term's rate",
            moved - boundary - h * along(boundary) - h * h * second,
            (),
            {},
        ),
        derive("the first variation with the work", first + work - along(boundary), (), {}),
    )


def expansion(form: Form) -> Identity:
    """A quadratic form a little later: what stands before the short time h is its derivative.

    Parameters
    ----------
    form : Form
        Quadratic in the letters x and u.

    Returns
    -------
    Identity
        form(x + h u, u + h w) = form(x, u) + h (its rate) + h^2 form(u, w).

    Raises
    ------
    ValueError
        The form is not quadratic.
    """
    x, u, w = letters("x u w")
    (h,) = scalars("h")
    later = form.substitute({"x": x + h * u, "u": u + h * w})
    tail = form.substitute({"x": u, "u": w})
    return derive("a short time later", later - form - h * along(form) - h * h * tail, (), {})


def decay(
    form: Form,
    rate: Form,
    given: Sequence[Form],
    words: Mapping[int, str],
    squares: Sequence[Square],
) -> Identity:
    """How fast a quadratic form falls along a motion, at least.

    Parameters
    ----------
    form : Form
        Quadratic in the letters x and u.
    rate : Form
        A scalar r, or the empty form.
    given : sequence of Form
        Hypotheses, the equation of motion among them.
    words : mapping of int to str
        The word that each hypothesis does away with, as in `theory.algebra.rewriting.rules`.
    squares : sequence of Square
        What -(d/dt form) - r form is a sum of.

    Returns
    -------
    Identity

    Raises
    ------
    ValueError
        It is another sum.
    """
    goal = -along(form) - rate * form
    return derive("at least so fast", goal, given, words, squares)


def whole(weight: Form, factor: Form = ONE) -> Square:
    """A weight as a square of its own, which makes a sum of squares strictly positive."""
    return Square(factor, ONE, weight)
