"""Identities of consensus by signs hold on drawn networks, in continuous and in discrete time."""

import numpy as np
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tests.strategies import connected_networks
from tests.theory.substitution import substituted
from theory.algebra import consensus, discrete_consensus, projections

NUMBERS = st.integers(-5, 5)


def incidence(network):
    columns = sp.zeros(network.n, network.m)
    for k, (i, j) in enumerate(network.edges.tolist()):
        columns[i, k], columns[j, k] = -1, 1
    return columns


def vector(data, n):
    return sp.Matrix(data.draw(st.lists(NUMBERS, min_size=n, max_size=n)))


def holds(entry, values):
    assert entry.holds
    for form in entry.relations:
        assert substituted(form, *values).is_zero_matrix, (entry.name, str(form))
    goal = substituted(entry.goal, *values)
    assert goal.is_zero_matrix or (entry.squares and min(goal) >= 0), entry.name


def graph(network):
    n, b, e = network.n, incidence(network), sp.ones(network.n, 1)
    laplacian, centre = b * b.T, sp.eye(n) - sp.ones(n, n) / n
    moore = (laplacian + sp.ones(n, n) / n).inv() - sp.ones(n, n) / n
    return {"B": b, "L": laplacian, "M": centre, "e": e, "X": moore}, sp.Rational(1, n)


@settings(max_examples=10, deadline=None)
@given(connected_networks(min_nodes=2, max_nodes=4), st.data())
def test_errors_mirror_images_and_sums_over_cuts(network, data):
    known, r = graph(network)
    n, b, gain = network.n, known["B"], sp.Rational(3, 2)
    w, f, u = (vector(data, n) for _ in range(3))
    g = sp.Matrix([sp.sign(x) for x in b.T * (w + f)])
    laws = known | {"w": w, "f": f, "x": w + f, "g": g, "d": -gain * b * g}
    for entry in consensus.errors():
        holds(entry, (laws, {"b": gain, "r": r, "m": sp.Integer(4)}))
    mirror = laws | {"y": known["e"] - w - f, "z": -w, "h": -g}
    for entry in consensus.mirrored():
        holds(entry, (mirror, {"b": gain}))
    inside = sp.Matrix(data.draw(st.lists(st.integers(0, 1), min_size=n, max_size=n)))
    cut = known | {"S": inside, "g": g, "u": u, "c": b.T * inside}
    cut["d"] = known["M"] * u - gain * b * g
    for entry in consensus.across_cuts():
        holds(entry, (cut, {"b": gain, "r": r}))
    leaving = sum(inside[i] != inside[j] for i, j in network.edges.tolist())
    assert (cut["c"].T * cut["c"])[0] == leaving
    still = known | {"x": sp.zeros(n, 1), "g": sp.zeros(network.m, 1)}
    still |= {"u": known["M"] * u, "d": known["M"] * u}
    for entry in consensus.resting():
        holds(entry, (still, {"b": gain, "r": r}))
    holds(consensus.centred(), (known | {"x": w}, {"r": r}))


@settings(max_examples=10, deadline=None)
@given(connected_networks(min_nodes=2, max_nodes=5))
def test_a_link_gives_its_sign_to_two_nodes(network):
    (i, j), unit = network.edges.tolist()[0], sp.eye(network.n)
    others = [k for k in range(network.n) if k not in (i, j)]
    for k in others:
        known = {"t": unit[:, i], "g": unit[:, j], "o": unit[:, k]}
        for entry in consensus.one_link():
            holds(entry, (known, {"k": sp.Integer(-1)}))
    assert incidence(network)[:, 0] == unit[:, j] - unit[:, i]


@settings(max_examples=10, deadline=None)
@given(connected_networks(min_nodes=2, max_nodes=5), st.data())
def test_selections_and_rates_on_drawn_networks(network, data):
    """Any number below lambda_2 will do; no entry of the flow exceeds the gain."""
    known, r = graph(network)
    n, b = network.n, known["B"]
    lam = sp.Rational(int(1000 * np.linalg.eigvalsh(np.array(known["L"], float))[1]) - 1, 1000)
    assume(lam > 0)
    u, bound = vector(data, n), sp.Integer(5)
    gain = bound * sp.Rational(int(1000 * float(sp.sqrt(n / lam))) + 1, 1000)
    flow = b.T * known["X"] * u
    matrices = known | {"P": known["L"] - lam * known["M"], "u": u, "q": flow}
    scalars = {"l": lam, "b": gain, "c": bound, "n": n, "r": r}
    scalars |= {"j": gain**2 * lam - bound**2 * n, "k": bound**2 * n - (u.T * u)[0]}
    assert min(scalars["j"], scalars["k"]) >= 0
    for entry in consensus.selected():
        holds(entry, (matrices, scalars))
    assert max(abs(x) for x in flow) <= gain
    x = known["M"] * vector(data, n)
    spread = sum(abs(y) for y in b.T * x)
    scalars |= {"t": spread, "y": (x.T * x)[0], "j": spread**2 - (x.T * known["L"] * x)[0]}
    assert scalars["j"] >= 0
    for entry in consensus.decreasing():
        holds(entry, (matrices | {"x": x}, scalars))


@settings(max_examples=10, deadline=None)
@given(connected_networks(min_nodes=2, max_nodes=4), st.data())
def test_projections_on_cuts_and_cycles(network, data):
    known, r = graph(network)
    b, links = known["B"], known["B"].T * known["X"] * known["B"]
    around = (sp.eye(network.m) - links) * vector(data, network.m)
    matrices = known | {"V": known["X"], "y": around}
    for entry in projections.projections():
        holds(entry, (matrices, {"r": r}))
    assert b * around == sp.zeros(network.n, 1)
    assert links.rank() == network.n - 1


def test_the_error_of_two_sensors_flips_at_each_explicit_step():
    v, h, b = sp.Matrix([-1, 1]), sp.Rational(1, 7), sp.Rational(5, 3)
    x = h * b * v / 2
    known = {"v": v, "x": x, "y": -x, "z": x}
    for entry in discrete_consensus.flipping():
        holds(entry, (known, {"h": h, "b": b}))
    step = x - h * b * v * sp.sign((v.T * x)[0])
    assert step == -x
    assert step - h * b * v * sp.sign((v.T * step)[0]) == x


@settings(max_examples=15, deadline=None)
@given(st.sampled_from([(3, 4), (-5, 12), (8, -15)]), st.tuples(NUMBERS, NUMBERS))
def test_one_explicit_step_stays_below_its_bound(numbers, push):
    x = sp.Matrix(numbers)
    size = sp.sqrt((x.T * x)[0])
    s = sp.Matrix(push) + 2 * x
    pull, square = (x.T * s)[0], (s.T * s)[0]
    h, r = sp.Rational(1, 3), pull / size / 2
    q = square + 1 + 2 * r * size / h
    limit = h * q / (2 * r)
    scalars = {"h": h, "r": r, "Q": q, "X": size, "Z": limit, "a": limit - size}
    scalars |= {"j": pull - r * size, "k": q - square}
    assert min(scalars.values()) >= 0
    for entry in discrete_consensus.explicit():
        holds(entry, ({"x": x, "s": s, "y": x - h * s}, scalars))


def test_an_implicit_step_shortens_the_error_by_the_step_times_the_rate():
    """Three sensors in a row, 4, 0 and -4 after the step."""
    b = sp.Matrix([[-1, 0], [1, -1], [0, 1]])
    centre, e = sp.eye(3) - sp.ones(3, 3) / 3, sp.ones(3, 1)
    y, g, h, gain = sp.Matrix([4, 0, -4]), sp.Matrix([-1, -1]), sp.Rational(1, 4), sp.Integer(2)
    u = sp.zeros(3, 1)
    x = y + h * gain * b * g
    new, old = sp.sqrt((y.T * y)[0]), sp.sqrt((x.T * x)[0])
    pull = gain * (y.T * b * g)[0]
    rate = pull / new
    scalars = {"h": h, "b": gain, "a": rate, "r": sp.Rational(1, 3), "X": old, "Y": new}
    scalars |= {"w": (y.T * x)[0], "j": sp.Integer(0)}
    known = {"B": b, "M": centre, "e": e, "x": x, "y": y, "g": g, "u": u, "f": sp.zeros(2, 1)}
    for entry in discrete_consensus.implicit():
        holds(entry, (known, scalars))
    assert sp.simplify(old - new - h * rate) >= 0
