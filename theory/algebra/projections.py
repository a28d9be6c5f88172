"""Cut space and cycle space of a graph: projections made with the Laplacian's inverse.

Letters are those of `theory.algebra.graphs` for a connected graph without weights, with ``X`` for
the Moore-Penrose inverse L^+ of L.
"""

from __future__ import annotations

from .identities import ONE, Identity, hypotheses, identity
from .noncommuting import letters, scalars


def projections() -> tuple[Identity, ...]:
    """L L^+, L^+ L and B'L^+B project: on vectors of sum zero, and on differences along links.

    B'L^+B keeps every vector of differences B'x (the cut space) and takes circulations y, those
    with By = 0 (the cycle space), to zero.

    Returns
    -------
    tuple of Identity
        Letters ``B L M X V e`` and ``y`` (a circulation), the scalar ``r`` (1/n).
    """
    b, lap, m, x, v, e, y = letters("B L M X V e y", ("L", "M"))
    (r,) = scalars("r")
    relations = (
        e.T * b,
        lap - b * b.T,
        r * (e.T * e) - ONE,
        m - ONE + r * (e * e.T),
        m - lap * v,
        lap * x * lap - lap,
        x * lap * x - x,
        (lap * x).T - lap * x,
        (x * lap).T - x * lap,
        b * y,
    )
    incident, plain, _, centre, reach, inner, outer, upright, level, around = hypotheses(relations)
    kept = centre.before(b) - incident.after(r * e)  # M B = B
    laplacian = plain.after(m) + kept.before(b.T) - plain  # M L = L
    # L X M = L X L V = L V = M, its transpose M L X = M, and M L = L
    mean = reach.after(lap * x) + inner.before(v) - reach
    right = (upright.before(m) + mean).T - laplacian.before(x)  # L X = M
    # M X L = V'L X L = V'L = M; its transpose with (X L)' = X L and L M = L
    turned = reach.T.before(x * lap) + inner.after(v.T) - reach.T
    left = (level.after(m) + turned).T - laplacian.T.after(x)  # X L = M
    fixed = outer - left.before(x)  # M X = X L X = X
    # X'M = X'L X = M X = X, whose transpose says M X = X'
    same = right.T.before(x) - right.after(x.T) + fixed
    upright_inverse = fixed.T - same
    links, inside = b.T * x * b, kept.T + left.after(b.T) - plain.after(b.T * x)
    twice = outer.between(b.T, b) - plain.between(b.T * x, x * b)
    found = {
        "L X = M": (lap * x - m, right),
        "X L = M": (x * lap - m, left),
        "M X = X": (m * x - x, fixed),
        "X = X'": (x - x.T, upright_inverse),
        "B'X B is symmetric": (links - links.T, upright_inverse.between(b.T, b)),
        "B'X B projects": (links * links - links, twice),
        "B'X B keeps differences": (links * b.T - b.T, inside),
        "B'X B takes circulations to zero": (links * y, around.after(b.T * x)),
    }
    return tuple(identity(name, goal, relations, proof) for name, (goal, proof) in found.items())
