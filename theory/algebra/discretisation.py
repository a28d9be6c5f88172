"""Any rule for the action integral: the recursion it gives, its continuous limit and its order.

The Lagrangian and the work of the force over one step are evaluated at points between the two ends,
with the velocity u_k = (x_{k+1} - x_k)/h. Marsden & West, *Discrete mechanics and variational
integrators*, Acta Numerica 10 (2001), sections 1.1, 3.2 and 2.3 (order of accuracy).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from math import factorial

from .lagrange import Lagrangian, Recursion, recursion
from .noncommuting import Form, inverse, letters, scalars

Damping = Callable[[Form], Form]
"""F(u), the force at a velocity."""

MOST_ORDER = 6
"""Powers of the step that `order` looks at."""


@dataclass(frozen=True)
class Rule:
    """Where the action's integrand is evaluated within a step.

    Parameters
    ----------
    name : str
        For messages.
    points : tuple of (Fraction, Fraction)
        Weight, and place between the older end (0) and the newer one (1).

    Raises
    ------
    ValueError
        The weights do not sum to one, or a place is outside the step.
    """

    name: str
    points: tuple[tuple[Fraction, Fraction], ...]

    def __post_init__(self) -> None:
        if sum(weight for weight, _ in self.points) != 1:
            raise ValueError(f"points: the weights of {self.name} do not sum to one")
        if any(not 0 <= place <= 1 for _, place in self.points):
            raise ValueError(f"points: a place of {self.name} is outside the step")


HALF, ZERO, ONE = Fraction(1, 2), Fraction(0), Fraction(1)
LEFT = Rule("rectangle at the older end", ((ONE, ZERO),))
RIGHT = Rule("rectangle at the newer end", ((ONE, ONE),))
MIDPOINT = Rule("midpoint", ((ONE, HALF),))
TRAPEZOID = Rule("trapezoid", ((HALF, ZERO), (HALF, ONE)))


def discretised(lagrangian: Lagrangian, damping: Damping, rule: Rule) -> Recursion:
    """The recursion that makes the action stationary under the force.

    Parameters
    ----------
    lagrangian : callable
        L(x, u), quadratic.
    damping : callable
        F(u).
    rule : Rule
        Where both are evaluated.

    Returns
    -------
    Recursion
        A2 x_{k+2} + A1 x_{k+1} + A0 x_k = 0, of the sign of `lagrange.recursion`.
    """
    u, v, x, d = letters("u v x d")
    h, e = scalars("h e")
    action = pushed = Form({})
    for weight, place in rule.points:
        # the node x is the newer end of the step with velocity v, the older one of that with u
        before = lagrangian(x - (1 - place) * (h * v) + e * place * (h * d), v + e * d)
        after = lagrangian(x + place * (h * u) + e * (1 - place) * (h * d), u - e * d)
        action = action + weight * (h * (before + after))
        pushed = pushed + weight * (h * (place * damping(v) + (1 - place) * damping(u)))
    slope = action.coefficient("e", 1)
    gradient = inverse(h) * (slope.after("d'") + slope.T.after("d'"))
    return recursion(gradient + pushed)


def residual(scheme: Recursion) -> tuple[Form, ...]:
    """What a smooth motion leaves of the recursion, by powers of the step.

    Parameters
    ----------
    scheme : Recursion

    Returns
    -------
    tuple of Form
        Coefficients of h^2, h^3, ... in the derivatives q0, q1, q2, ... at the middle node, after
        the continuous limit, the first of them, has been used to remove the highest derivatives.
    """
    (h,) = scalars("h")
    names = [f"q{i}" for i in range(MOST_ORDER + 5)]
    derivatives = letters(" ".join(names))
    moved = []
    for shift in (1, 0, -1):
        terms = [Fraction(shift**i, factorial(i)) for i in range(len(names))]
        power, total = Form({((), ()): ONE}), Form({})
        for factor, derivative in zip(terms, derivatives, strict=True):
            total = total + factor * (power * derivative)
            power = power * h
        moved.append(total)
    left = scheme.a2 * moved[0] + scheme.a1 * moved[1] + scheme.a0 * moved[2]
    parts = [left.coefficient("h", power) for power in range(2, MOST_ORDER + 3)]
    limit = parts[0]
    return (limit, *(_reduced(part, limit, names) for part in parts[1:]))


def order(scheme: Recursion) -> int:
    """Order of accuracy: the power of the step that the first term beside the limit carries.

    Parameters
    ----------
    scheme : Recursion
        Of the second order in time.

    Returns
    -------
    int
        At most `MOST_ORDER`.
    """
    rest = residual(scheme)[1:]
    return next((k for k, part in enumerate(rest, start=1) if part.terms), MOST_ORDER)


def _reduced(part: Form, limit: Form, names: list[str]) -> Form:
    """Without M q_i, i >= 2, by the limit M q_2 + ... = 0 and its derivatives."""
    inertia = limit.before("q2")
    for i in range(len(names) - 1, 1, -1):
        factor = _multiple(part.before(names[i]), inertia)
        later = {name: letters(names[j + i - 2])[0] for j, name in enumerate(names[:3])}
        part = part - factor * limit.substitute(later)
    return part


def _multiple(form: Form, unit: Form) -> Fraction:
    """How often a form holds `unit`, one product of letters."""
    ((word, size),) = unit.terms.items()
    return form.terms.get(word, ZERO) / size
