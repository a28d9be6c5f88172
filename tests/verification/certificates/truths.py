"""What some statements say, computed by another road: a forgery that is believed has to be true."""

from fractions import Fraction
from itertools import combinations

import numpy as np

SLACK = 1e-9


def rows(value):
    return np.array([[float(Fraction(x)) for x in row] for row in value])


def ends(entry):
    return Fraction(entry["lower"]), Fraction(entry["upper"])


def spread_over(graph, value):
    values = value if isinstance(value, list) else [value] * len(graph["nodes"])
    return [Fraction(v) for v in values]


def component(graph, start):
    found = [start]
    for i in found:
        for pair in graph["edges"]:
            found += [j for j in pair if i in pair and j not in found]
    return sorted(found)


def links(graph):
    weights = graph.get("weights", [1] * len(graph["edges"]))
    return [(i, j, Fraction(w)) for (i, j), w in zip(graph["edges"], weights, strict=True)]


def threshold(graph, gamma):
    """Largest N/k over all cuts of all components; None where there is no cut."""
    gamma, worst = spread_over(graph, gamma), []
    for part in {tuple(component(graph, i)) for i in range(len(graph["nodes"]))}:
        for s in range(1, len(part)):
            for inside in combinations(part, s):
                k = sum(w for i, j, w in links(graph) if (i in inside) != (j in inside))
                share = Fraction(s, len(part))
                load = sum(gamma[i] * ((1 - share) if i in inside else share) for i in part)
                worst.append(load / k)
    return max(worst, default=None)


def gain_threshold(entry):
    if "product" in entry["inputs"]["graph"]:
        return True
    lower, upper = ends(entry)
    worst = threshold(entry["inputs"]["graph"], entry["inputs"]["gamma"])
    return lower <= worst <= upper


def gain(entry):
    worst = threshold(entry["inputs"]["graph"], entry["inputs"]["gamma"])
    kept = worst is None or Fraction(entry["inputs"]["beta"]) >= worst
    return kept == (entry["verdict"] == "PROVED")


def laplacian(graph):
    n = len(graph["nodes"])
    matrix = np.zeros((n, n))
    for i, j, w in links(graph):
        matrix[[i, j], [j, i]] -= float(w)
        matrix[[i, j], [i, j]] += float(w)
    return matrix


def algebraic_connectivity(entry):
    lower, upper = map(float, ends(entry))
    value = np.linalg.eigvalsh(laplacian(entry["inputs"]["graph"]))[1]
    return lower - SLACK <= value <= upper + SLACK


def radius(inputs, h):
    m, k, c = (rows(inputs[name]) for name in "MKC")
    inverse, eye = np.linalg.inv(m + h * c), np.eye(len(m))
    step = np.block([[eye, h * eye], [-h * inverse @ k, inverse @ (m - h * h * k)]])
    return max(abs(np.linalg.eigvals(step)))


def step(entry):
    value = radius(entry["inputs"], float(Fraction(entry["inputs"]["h"])))
    return value < 1 + SLACK if entry["verdict"] == "PROVED" else value > 1 - SLACK


def step_limit(entry):
    lower, upper = map(float, ends(entry))
    return radius(entry["inputs"], lower) < 1 + 1e-6 and radius(entry["inputs"], upper) > 1 - 1e-6


TRUTHS = {
    "gain_threshold": gain_threshold,
    "gain": gain,
    "algebraic_connectivity": algebraic_connectivity,
    "step": step,
    "step_limit": step_limit,
}


def is_true(entry):
    """Whether the statement is true of the data that the checker prints, where that is known."""
    known = TRUTHS.get(entry["name"])
    return known is None or bool(known(entry))
