"""Consensus by signs on any graph, as identities and inequalities of any number of nodes.

The law is read as a differential inclusion: the derivative of the error x is M u - beta B g for
some ``g`` that selects, for each link, the sign of the difference along it, and any number between
-1 and 1 where that is zero. So g'B'x is the sum of the sizes of all differences, and |g_k| <= 1.

Letters: ``B L M e`` as in `theory.algebra.graphs`, ``x`` (error), ``u`` (rates of what is
averaged), ``g`` (selection). Scalars: ``b`` (gain beta), ``r`` (1/n).
"""

from __future__ import annotations

from .identities import ONE, Identity, Square
from .noncommuting import Form, letters, scalars
from .rewriting import derive


def one_link() -> tuple[Identity, ...]:
    """What one column of B gives to each node: B sgn(B'x) is the sum over neighbours, node by node.

    A link turned round has the column -(g - t) and the sign -k, and gives the same.

    Returns
    -------
    tuple of Identity
        Letters ``t g o`` (unit vectors of tail, head and any other node), the scalar ``k`` (sign of
        head minus tail).
    """
    t, g, o = letters("t g o")
    (k,) = scalars("k")
    relations = (t.T * t - ONE, g.T * g - ONE, t.T * g, o.T * t, o.T * g)
    words = dict(enumerate(("t' t", "g' g", "t' g", "o' t", "o' g")))
    column = (g - t) * k
    goals = {
        "the head gets the sign of head minus tail": g.T * column - k,
        "the tail gets that of tail minus head": t.T * column + k,
        "another node gets nothing": o.T * column,
    }
    return tuple(derive(name, goal, relations, words) for name, goal in goals.items())


def errors() -> tuple[Identity, ...]:
    """The error of consensus, and what its sum and its mean say about the start.

    Returns
    -------
    tuple of Identity
        Letters ``B M e w f g d`` (internal states, what is averaged, selection, rate of w), ``x``
        (w + f), scalars ``b r m``.
    """
    b, m, e, w, f, g, d, x = letters("B M e w f g d x", ("M",))
    gain, r, level = scalars("b r m")
    relations = (
        e.T * b,
        m - ONE + r * (e * e.T),
        x - w - f,
        d + gain * (b * g),
        r * (e.T * e) - ONE,
    )
    words = {0: "e' B", 1: "M", 2: "x", 3: "d", 4: "r e' e"}
    goals: dict[str, Form] = {
        "x without the average is w + Mf": x - r * (e * e.T * f) - w - m * f,
        "the sum of w stays": e.T * d,
        "the mean of x is the average, if the sum of w is 0": e.T * x - e.T * w - e.T * f,
        "the sum of the error is that of w": e.T * (w + m * f) - e.T * w,
        "errors that agree at m have the mean m": r * (e.T * e) * level - level,
    }
    return tuple(derive(name, goal, relations, words) for name, goal in goals.items())


def mirrored() -> tuple[Identity, ...]:
    """With what is averaged replaced by e minus it, everything runs as a mirror image.

    Returns
    -------
    tuple of Identity
        Letters ``B e w f x g d`` as in `errors`, ``y z h`` (state, internal state and selection of
        the mirror image), the scalar ``b``.
    """
    b, e, w, f, x, g, d, y, z, h = letters("B e w f x g d y z h")
    (gain,) = scalars("b")
    relations = (e.T * b, x - w - f, d + gain * (b * g), y - e + x, z + w, h + g)
    words = {0: "e' B", 1: "x", 2: "d", 3: "y", 4: "z", 5: "h"}
    goals = {
        "y is z plus the mirrored signal": y - z - e + f,
        "differences along links change sign": b.T * y + b.T * x,
        "-d is the rate of z with the selection -g": -d + gain * (b * h),
    }
    return tuple(derive(name, goal, relations, words) for name, goal in goals.items())


def across_cuts() -> tuple[Identity, ...]:
    """Sums over a set of nodes: only the links of its cut count.

    Returns
    -------
    tuple of Identity
        Letters ``B L M e S g u d`` (indicator of the set, selection, rates, rate of the error) and
        ``c`` = B'S, which is 1 or -1 on links that leave the set and 0 on others; the scalars ``b
        r``.
    """
    b, lap, m, e, s, g, u, d, c = letters("B L M e S g u d c", ("L", "M"))
    gain, r = scalars("b r")
    relations = (
        e.T * b,
        lap - b * b.T,
        m - ONE + r * (e * e.T),
        d - m * u + gain * (b * g),
        c - b.T * s,
    )
    words = {0: "e' B", 1: "L", 3: "d", 4: "c"}
    goals = {
        "the set's sum moves by S'Mu - beta c'g": s.T * d - s.T * m * u + gain * (c.T * g),
        "c'c = S'LS": c.T * c - s.T * lap * s,
        "the complement has -c": b.T * (e - s) + c,
    }
    return tuple(derive(name, goal, relations, words) for name, goal in goals.items())


def selected() -> tuple[Identity, ...]:
    """A selection that keeps agreement at the gain gamma sqrt(n/lambda_2): an electrical flow.

    The selection is q/beta for the flow q = B'L^+u, whose length is at most beta. ``P`` stands for
    L - lambda_2 M, which is positive semidefinite.

    Returns
    -------
    tuple of Identity
        Letters ``B L M P X e u q``; scalars ``l`` (lambda_2), ``b`` (beta), ``c`` (gamma), ``n``,
        ``r``, and the slacks ``j`` of beta^2 lambda_2 >= gamma^2 n and ``k`` of gamma^2 n >= |u|^2.
    """
    b, lap, m, p, x, e, u, q = letters("B L M P X e u q", ("L", "M", "P", "X"))
    lam, gain, bound, count, r, j, k = scalars("l b c n r j k")
    relations = (
        lap - b * b.T,
        p - lap + lam * m,
        m - ONE + r * (e * e.T),
        e.T * lap,
        r * (e.T * e) - ONE,
        lap * x - m,
        e.T * x,
        q - b.T * x * u,
        lam * (gain * gain) - bound * bound * count - j,
        bound * bound * count - u.T * u - k,
    )
    words = dict(
        enumerate(("B B'", "P", "M", "e' L", "r e' e", "L X", "e' X", "q", "b**2 l", "c**2 n"))
    )
    squares = (
        Square(j, ONE, ONE),
        Square(k, ONE, ONE),
        Square(r, e.T * u, ONE),
        Square(ONE, p * x * u, ONE),
        Square(lam, x * u, p),
    )
    short = lam * (gain * gain) - lam * (q.T * q)
    return (
        derive("B q = M u", b * q - m * u, relations, words),
        derive("q is at most beta long", short, relations, words, squares),
    )


def decreasing() -> tuple[Identity, ...]:
    """How fast the error falls: the sum of all differences against the push of the disturbance.

    Half the derivative of |x|^2 is u'x - beta t, t being the sum of the sizes of all differences.

    Returns
    -------
    tuple of Identity
        Letters ``L M P e x u``; scalars ``l`` (lambda_2), ``r``, ``t``, ``y`` (|x|^2), the slack
        ``j`` of t^2 >= x'Lx, and as in `selected` ``c n k``.
    """
    lap, m, p, e, x, u = letters("L M P e x u", ("L", "M", "P"))
    lam, r, t, y, j, c, n, k = scalars("l r t y j c n k")
    relations = (
        p - lap + lam * m,
        m - ONE + r * (e * e.T),
        e.T * x,
        t * t - x.T * lap * x - j,
        y - x.T * x,
        c * c * n - u.T * u - k,
    )
    words = dict(enumerate(("P", "M", "e' x", "t**2", "x' x", "c**2 n")))
    along = y * u - x * x.T * u
    return (
        derive(
            "differences add up to at least sqrt(lambda_2) |x|",
            t * t - lam * y,
            relations,
            words,
            (Square(j, ONE, ONE), Square(ONE, x, p)),
        ),
        derive(
            "the push is at most gamma sqrt(n) |x|",
            y * (y * (c * c * n)) - y * (u.T * x * x.T * u),
            relations,
            words,
            (Square(ONE, along, ONE), Square(y * y * k, ONE, ONE)),
        ),
    )


def resting() -> tuple[Identity, ...]:
    """With all signs zero, as at agreement, nothing holds the error against a disturbance.

    Returns
    -------
    tuple of Identity
        Letters ``B M e x g u d`` (rate of the error), scalars ``b r``.
    """
    b, m, e, x, g, u, d = letters("B M e x g u d", ("M",))
    gain, r = scalars("b r")
    relations = (x, g, e.T * u, m - ONE + r * (e * e.T), d - m * u + gain * (b * g))
    words = {0: "x", 1: "g", 2: "e' u", 3: "M", 4: "d"}
    goals = {"all differences are zero": b.T * x, "the error moves": d - u}
    return tuple(derive(name, goal, relations, words) for name, goal in goals.items())


def centred() -> Identity:
    """What is left of a vector without its mean is no longer than the vector.

    Returns
    -------
    Identity
        Letters ``M e x``, the scalar ``r``.
    """
    m, e, x = letters("M e x", ("M",))
    (r,) = scalars("r")
    relations = (m - ONE + r * (e * e.T), r * (e.T * e) - ONE)
    goal = x.T * x - (m * x).T * (m * x)
    words = {0: "M", 1: "r e' e"}
    return derive("|Mx| <= |x|", goal, relations, words, [Square(r, e.T * x, ONE)])
