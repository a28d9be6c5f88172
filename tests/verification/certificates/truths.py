"""What some statements say, computed by another road: a forgery that is believed has to be true."""

import math
from fractions import Fraction
from itertools import combinations

import numpy as np

from sensortrack.networks import Network
from verification.exact.runs.filippov import filippov_run

from .own_samples import assumptions, network, unlike_costs
from .stability_samples import mean_square, stable_step, stable_steps

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


def cuts_of(graph, part, gamma):
    """(nodes, k, N) of every cut of a component."""
    for s in range(1, len(part)):
        for inside in combinations(part, s):
            k = sum(w for i, j, w in links(graph) if (i in inside) != (j in inside))
            share = Fraction(s, len(part))
            yield inside, k, sum(gamma[i] * ((1 - share) if i in inside else share) for i in part)


def threshold(graph, gamma):
    """Largest N/k over all cuts of all components; None where there is no cut."""
    gamma, worst = spread_over(graph, gamma), []
    for part in {tuple(component(graph, i)) for i in range(len(graph["nodes"]))}:
        worst += [load / k for _, k, load in cuts_of(graph, part, gamma)]
    return max(worst, default=None)


def gain_threshold(entry):
    if "product" in entry["inputs"]["graph"]:
        return True
    lower, upper = ends(entry)
    worst = threshold(entry["inputs"]["graph"], entry["inputs"]["gamma"])
    return lower <= worst <= upper


def family(entry):
    """Threshold of the networks that are a graph's components, or one that is not connected."""
    if entry["lower"] != "inf":
        return gain_threshold(entry)
    graph, gamma = entry["inputs"]["graph"], entry["inputs"]["gamma"]
    apart = len(component(graph, 0)) < len(graph["nodes"])
    return apart and any(spread_over(graph, gamma))


def entry_gains(entry):
    for name in "Pq":
        ends = (Fraction(entry["inputs"][f"{end}_{name}"]) for end in ("lower", "upper"))
        worst = threshold(entry["inputs"]["graph"], entry["inputs"][f"gamma_{name}"])
        if not next(ends) <= worst <= next(ends):
            return False
    return True


def gain(entry):
    worst = threshold(entry["inputs"]["graph"], entry["inputs"]["gamma"])
    kept = worst is None or Fraction(entry["inputs"]["beta"]) >= worst
    return kept == (entry["verdict"] == "PROVED")


def disagreement_time(entry):
    """The statement's data, run again."""
    graph = entry["inputs"]["graph"]
    weights = tuple(w for *_, w in links(graph))
    network = Network(graph["nodes"], np.array(graph["edges"]).reshape(-1, 2), weights)
    x0 = spread_over(graph, entry["inputs"]["x0"])
    time = filippov_run(network, Fraction(entry["inputs"]["beta"]), x0).times[-1]
    return ends(entry) == (time, time)


def implicit_steps(entry):
    """All cuts of all components, from the definitions."""
    graph, inputs = entry["inputs"]["graph"], entry["inputs"]
    gamma, x0 = (spread_over(graph, inputs[name]) for name in ("gamma", "x0"))
    beta, h, squares = Fraction(inputs["beta"]), Fraction(inputs["h"]), [0.0]
    for part in {tuple(component(graph, i)) for i in range(len(graph["nodes"]))}:
        mean = sum(x0[i] for i in part) / len(part)
        size = sum((x0[i] - mean) ** 2 for i in part)
        for inside, k, load in cuts_of(graph, part, gamma):
            rate = beta * k - load
            p = Fraction(len(inside) * (len(part) - len(inside)), len(part))
            if rate <= 0:
                return entry["upper"] == "inf"
            squares.append(size * p / rate**2)
    steps = 0 if not max(squares) else math.isqrt(math.ceil(max(squares) / h**2) - 1) + 1
    return entry["upper"] != "inf" and steps <= Fraction(entry["upper"]) < steps + 1


def laplacian(graph):
    if "product" in graph:
        whole = np.zeros((1, 1))
        for factor in map(laplacian, graph["product"]):
            whole = np.kron(whole, np.eye(len(factor))) + np.kron(np.eye(len(whole)), factor)
        return whole
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
    "switching_threshold": family,
    "node_loss_threshold": family,
    "entry_gains": entry_gains,
    "disagreement_time": disagreement_time,
    "implicit_steps": implicit_steps,
    "algebraic_connectivity": algebraic_connectivity,
    "step": step,
    "step_limit": step_limit,
    "cyclic_spsa.assumptions": assumptions,
    "cyclic_spsa.assumptions_of_two": unlike_costs,
    "cyclic_spsa.network_step_limit": network,
    "cyclic_spsa.stationary_mse": mean_square,
    "cyclic_spsa.step": stable_step,
    "cyclic_spsa.step_limit": stable_steps,
}


def is_true(entry):
    """Whether the statement is true of the data that the checker prints, where that is known."""
    known = TRUTHS.get(f"{entry['system']}.{entry['name']}", TRUTHS.get(entry["name"]))
    return known is None or bool(known(entry))
