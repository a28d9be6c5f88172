"""What a hostile certificate may cost: seconds, not hours."""

from fractions import Fraction

import pytest

from .documents import document, judged
from .samples import PAIR, RING, TREE, cuts


def path_graph(n):
    return {"nodes": [str(i) for i in range(n)], "edges": [[i, i + 1] for i in range(n - 1)]}


def long_denominators(count):
    """Numbers of some three thousand digits with hardly a common factor."""
    return [str(2**k - 1) for k in range(10001, 10001 + 2 * count, 2)]


def costly():
    """Certificates that would take hours, or all memory, without a bound."""
    threshold = "bearing_dac.gain"
    tall = {"product": [path_graph(10)] * 60}
    pieces = {"nodes": [str(i) for i in range(40000)], "edges": []}
    pairs = {
        "nodes": [str(i) for i in range(20000)],
        "edges": [[i, i + 1] for i in range(0, 20000, 2)],
    }
    weights = {**path_graph(120), "weights": [f"1/{p}" for p in long_denominators(119)]}
    gain = {"gamma": "1", "beta": "1"}
    order = {"kind": "enumeration", "order": list(range(5000))}
    collide = [k * (2**61 - 1) for k in range(20000)]
    cut = {"kind": "cut", "nodes": [0]}
    matrix = {"kind": "vector", "x": [1] * 30000}
    hub = {"nodes": [str(i) for i in range(9000)], "edges": [[0, i] for i in range(1, 9000)]}
    dense = [{"kind": "sparse_ldl", "order": list(range(9000)), "bits": 4000}, matrix]
    yield "many pieces", threshold, gain | {"graph": pieces}, [cuts(*[TREE] * 40000)], True
    yield "many pairs", threshold, gain | {"graph": pairs}, [cuts(*[TREE] * 10000)], True
    yield "a long path", threshold, gain | {"graph": path_graph(20000)}, [cuts(TREE)], False
    yield "weights", threshold, gain | {"graph": weights}, [cuts(TREE)], False
    yield "a long order", threshold, gain | {"graph": path_graph(5000)}, [cuts(order)], False
    yield "a large product", threshold, gain | {"graph": tall}, [cuts(TREE)], False
    yield (
        "collisions",
        threshold,
        gain | {"graph": RING},
        [{"kind": "cut", "nodes": collide}],
        False,
    )
    yield (
        "a vector for a large matrix",
        "bearing_dac.algebraic_connectivity",
        {"graph": path_graph(30000)},
        [matrix],
        False,
    )
    yield "fill", "bearing_dac.algebraic_connectivity", {"graph": hub}, dense, False
    yield (
        "a product's matrix",
        "bearing_dac.algebraic_connectivity",
        {"graph": tall},
        [matrix],
        False,
    )
    primes = [p for p in range(10007, 150000, 2) if all(p % q for q in range(3, 388, 2))][:9000]
    spread = [[f"1/{primes[(7 * i + 7 * j) % 9000]}" for j in range(250)] for i in range(250)]
    plain = [["1" if i == j else "0" for j in range(250)] for i in range(250)]
    yield (
        "a common denominator",
        "variational.step",
        {"M": spread, "K": plain, "C": plain, "h": "1"},
        [],
        False,
    )
    yield "a cut of a product", threshold, gain | {"graph": tall}, [cut], False


COSTLY = {what: rest for what, *rest in costly()}


@pytest.mark.parametrize("what", COSTLY)
def test_costs_are_bounded(what, known, tmp_path):
    """Each takes a second or a few; where a bound is missing this test does not come to an end."""
    name, inputs, witness, valid = COSTLY[what]
    ends = {"lower": "0", "upper": "1"} if "connectivity" in name else {}
    made = document(known[name], inputs, witness, name=name, **ends)
    entry, status = judged(made, tmp_path / "it.json", known)
    assert entry["valid"] == valid, entry["reason"]
    assert status == (0 if valid else 1)


def test_long_exact_data_are_no_harm(known, tmp_path):
    """A few thousand digits are read, and the bound is exact to the last one."""
    gamma = Fraction(10**3000 + 1, 10**3000)
    made = document(
        known["bearing_dac.gain_threshold"],
        {"graph": PAIR, "gamma": str(gamma)},
        [cuts(TREE), {"kind": "cut", "nodes": [1]}],
        name="bearing_dac.gain_threshold",
        lower=str(gamma),
        upper=str(gamma),
    )
    assert judged(made, tmp_path / "it.json", known)[1] == 0
    hair = str(gamma + Fraction(1, 10**3900))
    assert judged(made | {"lower": hair}, tmp_path / "it.json", known)[1] == 1
    assert judged(made | {"upper": hair}, tmp_path / "it.json", known)[1] == 0
