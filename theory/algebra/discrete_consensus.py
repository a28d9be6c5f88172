"""Consensus by signs in discrete time: explicit and implicit steps of any length.

The letters are those of `theory.algebra.consensus`; ``y`` is the error after the step ``h`` from
``x``.
"""

from __future__ import annotations

from .identities import ONE, Identity, Square
from .noncommuting import letters, scalars
from .rewriting import derive


def flipping() -> tuple[Identity, ...]:
    """Two sensors under explicit steps: the error x changes sign in each step.

    Returns
    -------
    tuple of Identity
        Letters ``v`` (the column of B), ``x y z`` (successive errors), scalars ``h b`` (step,
        gain).
    """
    v, x, y, z = letters("v x y z")
    h, b = scalars("h b")
    relations = (
        v.T * v - 2 * ONE,
        2 * x - h * b * v,
        y - x + h * b * v,
        z - y - h * b * v,
    )
    words = {0: "v' v", 1: "x", 2: "y", 3: "z"}
    goals = {
        "the difference is positive": v.T * x - h * b,
        "after one step it is negative": v.T * y + h * b,
        "one step changes the sign of the error": y + x,
        "two steps lead back": z - x,
    }
    return tuple(derive(name, goal, relations, words) for name, goal in goals.items())


def explicit() -> tuple[Identity, ...]:
    """How far an explicit step can lead from agreement.

    The error ``x`` of size X moves by -h s with x's >= r X and |s|^2 <= Q. With Z = hQ/(2r) the
    error falls where X > Z, and for X = Z - a the new square is at most the mean of Z^2 and h^2 Q
    with the weights X/Z and a/Z.

    Returns
    -------
    tuple of Identity
        Letters ``x y s``; scalars ``h r Q X Z a`` and the slacks ``j k``.
    """
    x, y, s = letters("x y s")
    h, r, q, size, limit, a, j, k = scalars("h r Q X Z a j k")
    relations = (
        y - x + h * s,
        size * size - x.T * x,
        x.T * s - r * size - j,
        s.T * s - q + k,
        2 * r * limit - h * q,
        limit - size - a,
    )
    words = {0: "y", 1: "X**2", 2: "x' s", 3: "s' s", 4: "Q h", 5: "Z"}
    slack = (Square(2 * h * j, ONE, ONE), Square(h * h * k, ONE, ONE))
    step = size * size - 2 * h * r * size + h * h * q - y.T * y
    near = size * limit + 2 * h * r * a - y.T * y
    alone = {number: word for number, word in words.items() if number < 4}
    return (
        derive("the new square", step, relations, alone, slack),
        derive("near agreement", near, relations, words, (Square(a * size, ONE, ONE), *slack)),
    )


def implicit() -> tuple[Identity, ...]:
    """An implicit step keeps the sum and agreement, and shortens every other error by h times a.

    ``g`` selects the signs of the differences of ``y``; its pull b y'Bg - y'Mu is at least a Y, as
    at the same gain in continuous time. ``f`` is a selection at agreement.

    Returns
    -------
    tuple of Identity
        Letters ``B M e x y g f u``; scalars ``h b a r X Y w`` (sizes X, Y of x and y; w = y'x),
        slack ``j``.
    """
    b, m, e, x, y, g, f, u = letters("B M e x y g f u", ("M",))
    h, gain, rate, r, old, new, w, j = scalars("h b a r X Y w j")
    relations = (
        y - x - h * (m * u) + h * gain * (b * g),
        gain * (y.T * b * g) - y.T * m * u - rate * new - j,
        new * new - y.T * y,
        old * old - x.T * x,
        w - y.T * x,
        e.T * b,
        m - ONE + r * (e * e.T),
        r * (e.T * e) - ONE,
        gain * (b * f) - m * u,
    )
    sums = {0: "x", 5: "e' B", 6: "M", 7: "r e' e"}
    falls = {0: "x", 1: "b y' B g", 2: "Y**2", 4: "w"}
    sizes = {2: "y' y", 3: "x' x", 4: "y' x"}
    longer = new * new * x - w * y
    return (
        derive("the sum stays", e.T * y - e.T * x, relations, sums),
        derive("agreement stays", h * (m * u) - h * gain * (b * f), relations, {8: "b B f"}),
        derive(
            "Y(Y + ha) <= w",
            w - new * new - h * rate * new,
            relations,
            falls,
            [Square(h * j, ONE, ONE)],
        ),
        derive(
            "w <= XY",
            new * new * (new * new * old * old - w * w),
            relations,
            sizes,
            [Square(ONE, longer, ONE)],
        ),
    )
