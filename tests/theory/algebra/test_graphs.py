"""Identities of graphs of any size hold for the graphs that one can write down."""

from fractions import Fraction

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.networks import Network
from tests.strategies import connected_networks, networks
from tests.theory.substitution import substituted
from theory.algebra import graphs
from theory.algebra.identities import Identity

Values = tuple[dict[str, sp.Matrix], dict[str, sp.Rational]]
ALL = [
    *graphs.undirected(),
    *graphs.balanced(),
    graphs.eigenvalues(),
    *graphs.directed_triangle(),
    *graphs.pseudo_inverse(),
    *graphs.generalized_inverse(),
]


@pytest.mark.parametrize("entry", ALL, ids=lambda entry: entry.name)
def test_the_combination_leaves_nothing(entry: Identity) -> None:
    assert entry.holds


def ones(n: int) -> sp.Matrix:
    return sp.ones(n, 1)


def mean_free(n: int) -> sp.Matrix:
    return sp.eye(n) - sp.ones(n, n) / n


def rational(x: Fraction) -> sp.Rational:
    return sp.Rational(x.numerator, x.denominator)


def incidence(network: Network) -> sp.Matrix:
    columns = sp.zeros(network.n, network.m)
    for k, (i, j) in enumerate(network.edges.tolist()):
        columns[i, k], columns[j, k] = -1, 1
    return columns


def holds(entry: Identity, values: Values) -> None:
    """Hypotheses and goal are zero for these matrices."""
    for form in (*entry.relations, *([] if entry.squares else [entry.goal])):
        assert substituted(form, *values).is_zero_matrix, (entry.name, str(form))


@given(networks(min_nodes=2, max_nodes=5, weighted=True), st.data())
@settings(max_examples=30)
def test_undirected_identities_hold_for_drawn_networks(
    network: Network, data: st.DataObject
) -> None:
    if network.m == 0:
        return
    n, b = network.n, incidence(network)
    numbers = st.lists(st.integers(-5, 5), min_size=n, max_size=n)
    inside = sp.Matrix(data.draw(st.lists(st.integers(0, 1), min_size=n, max_size=n)))
    w = sp.diag(*map(rational, network.weights or [Fraction(1)] * network.m))
    matrices = {"B": b, "W": w, "L": b * w * b.T, "M": mean_free(n), "e": ones(n), "S": inside}
    matrices["x"] = sp.Matrix(data.draw(numbers))
    scalars = {"r": sp.Rational(1, n), "c": sp.Integer(3), "s": sum(inside)}
    for entry in graphs.undirected():
        holds(entry, (matrices, scalars))
    cut = sum(
        (w[k, k] for k, (i, j) in enumerate(network.edges.tolist()) if inside[i] != inside[j]),
        sp.Integer(0),
    )
    assert (inside.T * matrices["L"] * inside)[0] == cut


@st.composite
def balanced_values(draw: st.DrawFn) -> Values:
    """A directed cycle through all nodes and more cycles, each with one weight."""
    n = draw(st.integers(2, 4))
    shorter = st.permutations(range(n)).map(lambda order: order[: max(2, n - 1)])
    cycles = [list(range(n)), *draw(st.lists(shorter, max_size=2))]
    arcs = [
        (cycle[k - 1], node, weight)
        for cycle in cycles
        for weight in [draw(st.integers(1, 4))]
        for k, node in enumerate(cycle)
    ]
    return directed(n, arcs, draw(st.lists(st.integers(-5, 5), min_size=n, max_size=n)))


def directed(n: int, arcs: list[tuple[int, int, int]], x: list[int]) -> Values:
    """Tails, heads, weights and Laplacian of a directed graph, as matrices."""
    tails, heads = sp.zeros(n, len(arcs)), sp.zeros(n, len(arcs))
    for k, (i, j, _) in enumerate(arcs):
        tails[i, k], heads[j, k] = 1, 1
    d, w = tails - heads, sp.diag(*(weight for _, _, weight in arcs))
    m = mean_free(n)
    reach = d.T * (d * d.T + sp.ones(n, n) / n).inv() * m
    matrices = {"O": tails, "J": heads, "W": w, "L": tails * w * d.T, "M": m, "Y": reach}
    return matrices | {"e": ones(n), "x": sp.Matrix(x)}, {"r": sp.Rational(1, n)}


@given(balanced_values())
@settings(max_examples=30)
def test_balanced_graphs_satisfy_hypotheses_and_goals(values: Values) -> None:
    for entry in graphs.balanced():
        holds(entry, values)
    matrices, _ = values
    laplacian, x = matrices["L"], matrices["x"]
    form = (x.T * laplacian * x)[0]
    assert form >= 0
    assert (form == 0) == (len({*x}) == 1)
    assert all(laplacian[i, j] <= 0 for i in range(x.rows) for j in range(x.rows) if i != j)


def test_without_balance_the_quadratic_form_can_be_negative() -> None:
    matrices, scalars = directed(2, [(0, 1, 1)], [1, 2])
    x, (_, balance, *_) = matrices["x"], graphs.balanced()[0].relations
    assert not substituted(balance, matrices, scalars).is_zero_matrix
    assert (x.T * matrices["L"] * x)[0] < 0


def test_without_connection_the_quadratic_form_has_more_zeros() -> None:
    arcs = [(0, 1, 1), (1, 0, 1), (2, 3, 1), (3, 2, 1)]
    tails = sp.Matrix(4, 4, lambda i, k: int(arcs[k][0] == i))
    heads = sp.Matrix(4, 4, lambda i, k: int(arcs[k][1] == i))
    x = sp.Matrix([1, 1, 0, 0])
    assert (x.T * tails * (tails - heads).T * x)[0] == 0
    assert (tails - heads).rank() < 3


def test_complex_eigenvalues_of_the_directed_triangle() -> None:
    matrices, _ = directed(3, [(0, 1, 1), (1, 2, 1), (2, 0, 1)], [0, 0, 0])
    root = sp.sqrt(3)
    values = {sp.nsimplify(value) for value in matrices["L"].eigenvals()}
    assert values == {0, sp.Rational(3, 2) + sp.I * root / 2, sp.Rational(3, 2) - sp.I * root / 2}
    x, y = (
        sp.Matrix([1, -sp.Rational(1, 2), -sp.Rational(1, 2)]),
        sp.Matrix([0, root / 2, -root / 2]),
    )
    for b in (root / 2, -root / 2):
        scalars = {"a": sp.Rational(3, 2), "b": b}
        known = matrices | {"x": x, "y": y}
        entry = graphs.eigenvalues()
        left = [substituted(form, known, scalars) for form in entry.relations]
        if all(form.is_zero_matrix for form in left):
            squares = sum(substituted(s.form, known, scalars)[0] for s in entry.squares)
            assert substituted(entry.goal, known, scalars)[0] == squares == 3 * sp.Integer(3)
            break
    else:
        raise AssertionError("no sign of b makes x + iy an eigenvector")


def test_the_triangle_is_what_the_letters_say() -> None:
    unit = {name: sp.eye(3)[:, k] for k, name in enumerate("abc")}
    laplacian = directed(3, [(0, 1, 1), (1, 2, 1), (2, 0, 1)], [0, 0, 0])[0]["L"]
    for entry in graphs.directed_triangle():
        holds(entry, (unit | {"L": laplacian}, {}))
    assert laplacian != laplacian.T


@given(connected_networks(min_nodes=2, max_nodes=4), st.data())
@settings(max_examples=25)
def test_inverses_of_drawn_networks(network: Network, data: st.DataObject) -> None:
    n, m, b = network.n, network.m, incidence(network)
    laplacian, e, centre = b * b.T, ones(n), mean_free(n)
    inverse = (laplacian + sp.ones(n, n) / n).inv()
    moore = inverse - sp.ones(n, n) / n
    row = sp.Matrix([data.draw(st.lists(st.integers(-3, 3), min_size=n, max_size=n))])
    cells = st.lists(st.integers(-3, 3), min_size=m * m, max_size=m * m)
    g, moore_g = b.T * b, b.T * moore * moore * b
    z = moore_g + (sp.eye(m) - moore_g * g) * sp.Matrix(m, m, data.draw(cells))
    matrices = {"B": b, "L": laplacian, "M": centre, "V": inverse * centre, "e": e}
    upright = matrices | {"X": moore + e * row, "Z": z}
    skew = matrices | {"X": moore + row.T * e.T, "Z": z}
    scalars = {"r": sp.Rational(1, n)}
    for entry in graphs.pseudo_inverse():
        holds(entry, (upright, scalars))
    for entry in graphs.generalized_inverse():
        holds(entry, (skew, scalars))
    # dropping (L X)' = L X breaks L X = M, unless the added rows change nothing
    assert (laplacian * skew["X"] == centre) == (laplacian * row.T).is_zero_matrix
