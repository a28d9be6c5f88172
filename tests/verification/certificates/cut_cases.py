"""Networks with loads and errors, and all their cuts from the definitions."""

from fractions import Fraction
from itertools import combinations

from hypothesis import strategies as st

from tests.strategies import rationals

from .samples import cuts, enumeration

KINDS = {"graph": "graph", "gamma": "nodes", "b": "number", "f": "number", "e": "nodes"}


CLEAR = ["cuts_clear(graph, gamma, b, f, e)"]


REACHED = ["cut_reaches(graph, gamma, b, f, e)"]


THRESHOLD = {"graph": "graph", "gamma": "nodes", "b": "number"}


ABOVE = ["cuts_clear(graph, gamma, b, 1, 0)"]


BELOW = ["cut_reaches(graph, gamma, b, 1, 0)"]


DRIFTS = ["cut_drifts(graph, gamma, b)"]


FREE = {"graph": "graph", "b": "number", "f": "number", "s": "number"}


SPREAD = ["cuts_clear(graph, 0, b, f, s)"]


def all_cuts(network, gamma, error):
    """(nodes, k, N, p, E) of every cut of every component, from the definitions."""
    weights = network.weights or [1] * network.m
    links = [(i, j, w) for (i, j), w in zip(network.edges.tolist(), weights, strict=True)]
    for part in network.components():
        n = len(part)
        mean = sum(error[i] for i in part) / Fraction(n)
        spread = sum((error[i] - mean) ** 2 for i in part)
        for s in range(1, n):
            for inside in combinations(part, s):
                k = sum(Fraction(w) for i, j, w in links if (i in inside) != (j in inside))
                indicator = {i: (i in inside) - Fraction(s, n) for i in part}  # M 1_S
                load = sum(gamma[i] * abs(indicator[i]) for i in part)
                yield inside, k, load, sum(v * v for v in indicator.values()), spread


def clear(b, f, cut):
    _, k, load, p, spread = cut
    return b * k >= load and f * (b * k - load) ** 2 >= spread * p


def reached(b, f, cut):
    _, k, load, p, spread = cut
    return b * k <= load or f * (b * k - load) ** 2 <= spread * p


def some_nodes(draw, n, entries):
    return draw(st.lists(entries, min_size=n, max_size=n))


POSITIVE = rationals(Fraction(1, 20), 10)


SMALL = rationals(0, 3, 4)


@st.composite
def cases(draw, drawn):
    """A network with loads, an error, and numbers on which the two conditions are balanced."""
    network = draw(drawn)
    gamma = some_nodes(draw, network.n, SMALL)
    error = some_nodes(draw, network.n, rationals(-2, 2, 3))
    every = list(all_cuts(network, gamma, error))
    b, f = draw(SMALL), draw(POSITIVE)
    if every and draw(st.booleans()):  # exactly at the worst cut, or a little beside it
        b = max(cut[2] / cut[1] for cut in every) + draw(st.sampled_from([0, 1, Fraction(1, 99)]))
        rest = [(cut[4] * cut[3], (b * cut[1] - cut[2]) ** 2) for cut in every]
        if all(free for _, free in rest):
            scale = draw(st.sampled_from([1, 1, Fraction(98, 99), 2]))
            f = max(due / free for due, free in rest) * scale or f
    return network, gamma, error, b, f, every


def data(network, gamma, error, b, f):
    numbers = {"gamma": [*map(str, gamma)], "e": [*map(str, error)]}
    return {"graph": network.to_data(), "b": str(b), "f": str(f), **numbers}


def whole_enumerations(network, shuffle):
    return cuts(*(enumeration(*shuffle(range(len(part)))) for part in network.components()))


def without(inputs, *names):
    return {key: value for key, value in inputs.items() if key not in names}
