"""Incidence, Laplacian and cuts of any graph of any size, as identities of matrices.

Letters of an undirected graph of n nodes and m links: ``B`` (n x m, a column for each link, with -1
at the tail and 1 at the head), ``W`` (weights of the links, on the diagonal), ``L`` = B W B', ``e``
(ones), ``M`` = I - e e'/n, ``S`` (indicator of a set of s nodes). The scalar ``r`` is 1/n.

Letters of a directed graph: ``O`` and ``J`` (1 at the tail, 1 at the head of each arc), so that
O W O' holds what leaves each node, O W J' is the adjacency matrix and ``L`` = O W (O - J)'.

That a graph is connected enters as M = (O - J) Y for some Y: the differences along links span all
vectors of sum zero, because the links of a path add up to the difference of its ends. It follows
that x'Lx = 0 for constants only, so that L, being symmetric, reaches all vectors of sum zero as
well: M = L V for some V.
"""

from __future__ import annotations

from .identities import ONE, Identity, Square, Zero, hypotheses, identity
from .noncommuting import Form, letters, scalars
from .rewriting import derive


def _mean(centre: Zero, count: Zero, ones: Form, m: Form, r: Form) -> tuple[Zero, Zero]:
    """M e = 0 and M M = M."""
    null = centre.before(ones) - count.after(ones)
    return null, centre.after(m) - null.between(r, ones.T)


def undirected() -> tuple[Identity, ...]:
    """What holds for the Laplacian, the cuts and the mean of every undirected graph.

    Returns
    -------
    tuple of Identity
        Letters ``B W L M e S x`` and scalars ``r`` (1/n), ``c`` (any), ``s`` (nodes of S).
    """
    b, w, lap, m, e, ind, x = letters("B W L M e S x", ("L", "M", "W"))
    r, c, s = scalars("r c s")
    relations = (
        e.T * b,
        lap - b * w * b.T,
        r * (e.T * e) - ONE,
        m - ONE + r * (e * e.T),
        e.T * ind - s,
        ind.T * ind - s,
    )
    incident, weighted, count, centre, inside, size = hypotheses(relations)
    null = weighted.before(e) + incident.T.after(b * w)
    mean, square = _mean(centre, count, e, m, r)
    kept = centre.before(b) - incident.after(r * e)
    form = weighted.between(x.T, x)
    shifted, other, push = x + c * e, e - ind, 2 * ind - e
    overlap = (inside.after(s) + inside.T.before(e.T * ind)).times(r)
    found: list[tuple[str, Form, Zero]] = [
        ("L e = 0", lap * e, null),
        ("x'Lx = (B'x)'W(B'x)", x.T * lap * x - (b.T * x).T * w * (b.T * x), form),
        (
            "adding a constant to x leaves x'Lx alone",
            shifted.T * lap * shifted - x.T * lap * x,
            null.after(c * shifted.T) + null.T.between(c, x),
        ),
        (
            "a cut and its complement have one weight",
            other.T * lap * other - ind.T * lap * ind,
            null.T.before(other) - null.after(ind.T),
        ),
        (
            "S'MS = s - s^2/n",
            ind.T * m * ind - s + r * s * s,
            centre.between(ind.T, ind) + size - overlap,
        ),
        (
            "the disturbance 2S - e of a cut pushes its sides apart at the rate 2 S'MS",
            push.T * m * ind - 2 * (ind.T * m * ind),
            mean.T.before(ind).times(-1),
        ),
        ("M e = 0", m * e, mean),
        ("M M = M", m * m - m, square),
        ("M B = B", m * b - b, kept),
        ("M L = L", m * lap - lap, weighted.after(m) + kept.before(w * b.T) - weighted),
    ]
    return tuple(identity(name, goal, relations, proof) for name, goal, proof in found)


def balanced() -> tuple[Identity, ...]:
    """What holds for every directed graph that is connected and weight-balanced.

    Returns
    -------
    tuple of Identity
        Letters ``O J W L M Y e x`` and the scalar ``r`` (1/n).
    """
    tails, heads, w, lap, m, y, e, x = letters("O J W L M Y e x", ("M", "W"))
    (r,) = scalars("r")
    d = tails - heads
    relations = (
        lap - tails * w * d.T,
        tails * w * tails.T - heads * w * heads.T,
        e.T * tails - e.T * heads,
        m - ONE + r * (e * e.T),
        m - d * y,
    )
    laplacian, flow, arcs, centre, connected = hypotheses(relations)
    both = laplacian + laplacian.T + flow
    twice = both.between(x.T, x)
    found: list[tuple[str, Form, Zero]] = [
        ("L + L' = (O - J) W (O - J)'", lap + lap.T - d * w * d.T, both),
        ("L e = 0", lap * e, laplacian.before(e) + arcs.T.after(tails * w)),
        (
            "e'L = 0",
            e.T * lap,
            laplacian.after(e.T) + flow.after(e.T) - arcs.before(w * heads.T),
        ),
        (
            "x'Lx + x'L'x = ((O - J)'x)'W((O - J)'x)",
            x.T * (lap + lap.T) * x - x.T * d * w * d.T * x,
            twice,
        ),
        (
            "x without its mean is Y'(O - J)'x",
            x - r * (e * e.T) * x - y.T * d.T * x,
            connected.T.before(x) - centre.before(x),
        ),
    ]
    equalities = [identity(name, goal, relations, proof) for name, goal, proof in found]
    form, square = x.T * (lap + lap.T) * x, Square(ONE, d.T * x, w)
    return (*equalities, identity("x'Lx >= 0", form, relations, twice, [square]))


def eigenvalues() -> Identity:
    """Eigenvalues a + ib of the L of a weight-balanced graph have a >= 0.

    Returns
    -------
    Identity
        Letters ``O J W L x y`` and scalars ``a b``; x + iy is an eigenvector.
    """
    tails, heads, w, lap, x, y = letters("O J W L x y", ("W",))
    a, b = scalars("a b")
    d = tails - heads
    relations = (
        lap - tails * w * d.T,
        tails * w * tails.T - heads * w * heads.T,
        lap * x - a * x + b * y,
        lap * y - a * y - b * x,
    )
    laplacian, flow, real, imaginary = hypotheses(relations)
    both = laplacian + laplacian.T + flow
    along = real.after(x.T) + imaginary.after(y.T)
    proof = both.between(x.T, x) + both.between(y.T, y) - along - along.T
    squares = (Square(ONE, d.T * x, w), Square(ONE, d.T * y, w))
    goal = 2 * (a * (x.T * x + y.T * y))
    return identity("2 a |x + iy|^2 >= 0", goal, relations, proof, squares)


def directed_triangle() -> tuple[Identity, ...]:
    """The directed cycle on three nodes: balanced, and its Laplacian is not symmetric.

    Returns
    -------
    tuple of Identity
        Letters ``L a b c``: the unit vectors of the three nodes, with the arcs ab, bc and ca.
    """
    lap, a, b, c = letters("L a b c")
    arcs = ((a, b), (b, c), (c, a))
    relations = (
        lap - sum((tail * (tail - head).T for tail, head in arcs), Form({})),
        *(node.T * node - ONE for node in (a, b, c)),
        *(tail.T * head for tail, head in arcs),
    )
    words = dict(enumerate(("L", "a' a", "b' b", "c' c", "a' b", "b' c", "c' a")))
    everywhere = a + b + c
    goals = {
        "every row of L has sum 0": lap * everywhere,
        "every column of L has sum 0": everywhere.T * lap,
        "the entry of L at (a, b) is -1": a.T * lap * b + ONE,
        "the entry of L at (b, a) is 0": b.T * lap * a,
    }
    return tuple(derive(name, goal, relations, words) for name, goal in goals.items())


def pseudo_inverse() -> tuple[Identity, ...]:
    """L X = M and B Z B' = M for the Moore-Penrose inverses X of L and Z of B'B.

    Of the four Moore-Penrose conditions L X L = L and (L X)' = L X are used for X, and for Z only
    G Z G = G with G = B'B, so that every generalized inverse Z will do. The graph is connected and
    has no weights.

    Returns
    -------
    tuple of Identity
        Letters ``B L M X Z V e`` and the scalar ``r`` (1/n).
    """
    b, lap, m, x, z, v, e = letters("B L M X Z V e", ("L", "M"))
    (r,) = scalars("r")
    relations = (
        e.T * b,
        lap - b * b.T,
        r * (e.T * e) - ONE,
        m - ONE + r * (e * e.T),
        m - lap * v,
        lap * x * lap - lap,
        b.T * b * z * b.T * b - b.T * b,
        (lap * x).T - lap * x,
    )
    incident, plain, _, centre, connected, inner, inner_z, upright = hypotheses(relations)
    kept = centre.before(b) - incident.after(r * e)
    laplacian = plain.after(m) + kept.before(b.T) - plain

    # L X M = L X L V = L V = M, then its transpose M L X = M, then M L = L.
    right = connected.after(lap * x) + inner.before(v) - connected
    first = (upright.before(m) + right).T - laplacian.before(x)
    # N = B Z B' has N B = B, as M = V'L = V'B B' shows; then N M = M and N M = N.
    n = b * z * b.T
    short = connected + plain.before(v)
    fixed = short.T.before(n * b - b) + inner_z.after(v.T * b) - kept.before(z * b.T * b) + kept
    second = short.after(n) + fixed.before(b.T * v) - short - kept.T.after(b * z)
    return (
        identity("L X = M", lap * x - m, relations, first),
        identity("B Z B' = M", n - m, relations, second),
    )


def generalized_inverse() -> tuple[Identity, ...]:
    """What is left of L X = M for any generalized inverses X of L and Z of B'B: L X M = M.

    Returns
    -------
    tuple of Identity
        As `pseudo_inverse`, without the last hypothesis, (L X)' = L X.
    """
    _, second = pseudo_inverse()
    lap, m, x, v = letters("L M X V", ("L", "M"))
    relations = second.relations[:-1]
    _, _, _, _, connected, inner, _ = hypotheses(relations)
    proof = connected.after(lap * x) + inner.before(v) - connected
    return (
        identity("L X M = M", lap * x * m - m, relations, proof),
        identity(second.name, second.goal, relations, Zero(second.goal, second.combination)),
    )
