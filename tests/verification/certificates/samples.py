"""Small valid certificates, at least one of every case of every statement."""

import functools
import importlib
from fractions import Fraction

from theory.systems.bearing_dac import lemma_statements
from theory.systems.variational.statements.late import MOST_DELAY
from verification.certificates.make import certificate, statements
from verification.systems.variational.delays import delay_step_limit
from verification.systems.variational.design import gains_for_decay

from .own_samples import own_samples
from .stability_samples import stability_samples

PAIR = {"nodes": ["a", "b"], "edges": [[0, 1]]}
PATH = {"nodes": ["a", "b", "c"], "edges": [[0, 1], [1, 2]], "weights": ["1", "1/2"]}
RING = {"nodes": ["a", "b", "c", "d"], "edges": [[0, 1], [1, 2], [2, 3], [0, 3]]}
APART = {"nodes": ["a", "b", "c"], "edges": [[0, 1]]}
LADDER = {"product": [PAIR, PATH]}
TREE, CUT = {"kind": "tree"}, {"kind": "cut", "nodes": [0]}
ONE = [["1"]]
GAINS = {
    "M": [["2", "1/2"], ["1/2", "1"]],
    "K": [["1", "0"], ["0", "3"]],
    "C": [["1", "-1/3"], ["-1/3", "1"]],
}
SCALARS = {"M": ONE, "K": ONE, "C": ONE}
LDL = {"kind": "sparse_ldl", "order": [2, 0, 3, 1], "bits": 12}
RING_GAP = LDL | {"kind": "gap", "least": "199/100"}
FLIP = {"kind": "vector", "x": [1]}


def cuts(*parts):
    return {"kind": "cuts", "parts": list(parts)}


def enumeration(*order):
    return {"kind": "enumeration", "order": list(order)}


def ring_routing():
    """To each node opposite half a unit on either way round, to neighbours the short way."""
    flows = []
    for a in range(4):
        out = [(a, (a + 1) % 4, 3), ((a + 1) % 4, (a + 2) % 4, 1)]
        back = [(a, (a - 1) % 4, 3), ((a - 1) % 4, (a - 2) % 4, 1)]
        flow = []
        for i, j, amount in out + back:
            edge = RING["edges"].index([min(i, j), max(i, j)])
            flow.append([edge, amount if i < j else -amount])
        flows.append(flow)
    return {"kind": "routing", "unit": 2, "flows": flows}


def ring_cells():
    """The ring in two halves, each half in two; flows as even as they can be, for the bound 3."""
    return {
        "kind": "cells",
        "scale": 8,
        "levels": [
            [1, [0, 1, 1, 0], [2**20] * 4, [[0, -2, 0, 0], [0, 2, 0, 0]]],
            [1, [0, 0, 1, 1], [2**20] * 2, [[0, 0, -1, -1], [0, 0, 1, 1]]],
        ],
    }


def derivation(squares=(), relations=()):
    return {
        "kind": "derivation",
        "squares": [list(entry) for entry in squares],
        "relations": [list(entry) for entry in relations],
    }


def identities(forms):
    return [{"kind": "derivation", **form.to_data()} for form in forms]


def run(*pieces):
    keys = ("duration", "disturbance", "signs")
    return {
        "kind": "trajectory",
        "pieces": [dict(zip(keys, piece, strict=True)) for piece in pieces],
    }


PUSHED = {
    "graph": PAIR,
    "gamma": "4",
    "beta": "39/10",
    "lambda_2": "1999/1000",
    "x0": ["0", "0"],
    "x1": ["1/2", "-1/2"],
    "t": "5",
}
SLOWED = {
    "graph": PAIR,
    "gamma": "0",
    "beta": "1",
    "lambda_2": "1999/1000",
    "x0": ["4", "-4"],
    "x1": ["1", "-1"],
    "t": "3",
}
ENERGY = (
    ("-1/4*T(u + v)", "1", "1"),
    ("-1/4", "1'", "u + v"),
    ("-1/4*T(x + y)*K", "0", "1"),
    ("-1/4", "0'", "K*(x + y)"),
)
TIME = "(j + j**2) + 2*(1+j)*(d*(1 + j) + 2*g*s) + (d*(1 + j) + 2*g*s)**2 + s"
GOLDEN = {"lower": Fraction("3.236067977499789"), "upper": Fraction("3.2360679774997897")}

# statement, inputs, witness without definiteness, case and ends
EXPLICIT = [
    ("bearing_dac.gain_threshold", {"graph": PAIR, "gamma": "1"}, [cuts(TREE), CUT],
     {"lower": "1", "upper": "1"}),
    ("bearing_dac.gain_threshold", {"graph": PATH, "gamma": ["1", "0", "2/3"]},
     [cuts(TREE), {"kind": "cut", "nodes": [2]}], {"lower": "14/9", "upper": "14/9"}),
    ("bearing_dac.gain_threshold", {"graph": RING, "gamma": "3"},
     [cuts(enumeration(0, 1, 2, 3)), {"kind": "cut", "nodes": [1, 2]}],
     {"lower": "3", "upper": "3"}),
    ("bearing_dac.gain_threshold", {"graph": RING, "gamma": "3"},
     [cuts(ring_routing()), {"kind": "cut", "nodes": [1, 2]}], {"lower": "3", "upper": "3"}),
    ("bearing_dac.gain_threshold", {"graph": RING, "gamma": "3"},
     [cuts(ring_cells()), {"kind": "cut", "nodes": [1, 2]}], {"lower": "3", "upper": "3"}),
    ("bearing_dac.gain_threshold", {"graph": RING, "gamma": "3"},
     [cuts(RING_GAP), {"kind": "cut", "nodes": [1, 2]}], {"lower": "3", "upper": "3"}),
    ("bearing_dac.gain_threshold", {"graph": APART, "gamma": "1"}, [cuts(TREE, TREE), CUT],
     {"lower": "1", "upper": "1"}),
    ("bearing_dac.gain_threshold", {"graph": LADDER, "gamma": "1"},
     [cuts({"kind": "product", "parts": [TREE, TREE]}),
      {"kind": "cut", "factor": 1, "nodes": [2]}], {"lower": "8/3", "upper": "8/3"}),
    ("bearing_dac.margin_rate_squared", {"graph": RING},
     [cuts(enumeration(3, 1, 0, 2)), {"kind": "cut", "nodes": [0, 1]}],
     {"lower": "4", "upper": "4"}),
    ("bearing_dac.algebraic_connectivity", {"graph": RING},
     [LDL, {"kind": "vector", "x": [1, 1, -1, -1]}], {"lower": "199/100", "upper": "2"}),
    ("bearing_dac.algebraic_connectivity", {"graph": LADDER},
     [{"kind": "product", "parts": [LDL | {"order": [1, 0]}, LDL | {"order": [0, 2, 1]}]},
      {"kind": "vector", "factor": 1, "x": [-2, -1, 3]}], {"lower": "3/5", "upper": "9/14"}),
    ("bearing_dac.algebraic_connectivity", {"graph": APART},
     [{"kind": "vector", "x": [1, 1, -2]}],
     {"case": "PROVED 0", "lower": "0", "upper": "0"}),
    ("bearing_dac.settling_time",
     {"graph": RING, "gamma": ["1", "1/2", "0", "1"], "beta": "3", "x0": ["1", "2", "-3", "4"]},
     [cuts(enumeration(0, 1, 2, 3)), {"kind": "cut", "nodes": [0, 3]}],
     {"lower": "1", "upper": "3"}),
    ("bearing_dac.settling_time", {"graph": PAIR, "gamma": "1", "beta": "1", "x0": ["1", "0"]},
     [CUT], {"case": "INFINITE", "lower": "inf", "upper": "inf"}),
    ("bearing_dac.disagreement_time", {"graph": PATH, "beta": "1", "x0": ["13", "10", "7"]},
     [run(("2", ["0"] * 3, ["1", "1"]), ("4", ["0"] * 3, ["1/4", "1"]))],
     {"lower": "6", "upper": "6"}),
    ("bearing_dac.disagreement_time", {"graph": APART, "beta": "1", "x0": ["3", "1", "7"]},
     [run(("1", ["0"] * 3, ["1"]))], {"lower": "1", "upper": "1"}),
    ("bearing_dac.implicit_steps", {"graph": PAIR, "gamma": "1", "beta": "2", "h": "2/7",
     "x0": ["3", "1"], "least": "7/2"}, [cuts(TREE), CUT], {"lower": "4", "upper": "4"}),
    ("bearing_dac.implicit_steps", {"graph": PAIR, "gamma": "1", "beta": "1", "h": "2/7",
     "x0": ["3", "1"], "least": "0"}, [CUT], {"case": "INFINITE", "lower": "inf", "upper": "inf"}),
    ("bearing_dac.gain", {"graph": PATH, "gamma": "1/2", "beta": "4/3"}, [cuts(TREE)], {}),
    ("bearing_dac.gain", {"graph": PATH, "gamma": "1/2", "beta": "1"},
     [{"kind": "cut", "nodes": [2]}], {"case": "REFUTED"}),
    *((f"bearing_dac.{name}_threshold", inputs, witness, ends)
      for name in ("switching", "node_loss")
      for inputs, witness, ends in (
          ({"graph": APART, "gamma": "1"}, [cuts(TREE, TREE), CUT], {"lower": "1", "upper": "1"}),
          ({"graph": APART, "gamma": ["0", "0", "1"]}, [{"kind": "vector", "x": [1, 1, -2]}],
           {"case": "INFINITE", "lower": "inf", "upper": "inf"}))),
    ("bearing_dac.entry_gains",
     {"graph": PATH, "gamma_P": "1/2", "gamma_q": ["1", "0", "2/3"],
      "lower_P": "4/3", "upper_P": "4/3", "lower_q": "14/9", "upper_q": "14/9"},
     [cuts(TREE), {"kind": "cut", "nodes": [2]}] * 2, {}),
    ("bearing_dac.theorem_1_gain", PUSHED, [run(("5", ["4", "-4"], ["1"])), CUT],
     {"case": "REFUTED"}),
    ("bearing_dac.theorem_1_time", SLOWED, [run(("3", ["0", "0"], ["1"])), cuts(TREE)],
     {"case": "REFUTED"}),
    ("bearing_dac.theorem_1_gain_repair", {},
     [derivation([("2*g", "S", "P")], [("-2*g*T(S)", "0", "S")])], {}),
    ("bearing_dac.theorem_1_time_repair", {},
     [derivation(), derivation([(TIME, "1", "1")])], {}),
    ("bearing_dac.lemma_1_quadratic_form", {}, identities(lemma_statements.BALANCED), {}),
    ("bearing_dac.lemma_1_symmetric", {}, identities(lemma_statements.TRIANGLE),
     {"case": "REFUTED"}),
    ("bearing_dac.lemma_1_symmetric_repair", {}, identities(lemma_statements.EIGENVALUES), {}),
    ("bearing_dac.lemma_2_moore_penrose", {}, identities(lemma_statements.MOORE_PENROSE), {}),
    ("bearing_dac.lemma_2_generalized", {"graph": PAIR, "G": [["1", "0"], ["0", "0"]]}, [],
     {"case": "REFUTED"}),
    ("bearing_dac.lemma_2_generalized_repair", {}, identities(lemma_statements.GENERALIZED), {}),
    ("variational.step_limit", SCALARS, [FLIP], GOLDEN),
    ("variational.step_limit", GAINS, [{"kind": "vector", "x": [-1, 3]}],
     {"lower": "3/2", "upper": "5"}),
    ("variational.leapfrog_step_limit", SCALARS, [FLIP], {"lower": "19/10", "upper": "2"}),
    ("variational.step", {**GAINS, "h": "1"}, [], {}),
    ("variational.step", {**SCALARS, "h": "4"}, [FLIP], {"case": "REFUTED"}),
    ("variational.discrete_stability", {**SCALARS, "h": "7/2"}, [FLIP], {"case": "REFUTED"}),
    ("variational.discrete_stability_repair", {},
     [derivation([("h", "1", "C")]), derivation([("2", "1", "M"), ("h", "1", "C")]),
      derivation([("h**2", "1", "K")]), derivation([("1", "1", "Q")], [("-1", "0", "1")])], {}),
    ("variational.prop_4_1", {}, [derivation(), derivation()], {}),
    ("variational.discrete_energy", {},
     [derivation(), derivation([], [("-1", "0'", "x")]), derivation([("h", "x", "K")]),
      derivation([("1/2", "1", "M")]), derivation([("h", "1", "K")])], {"case": "REFUTED"}),
    ("variational.discrete_energy_repair", {},
     [derivation([], ENERGY), derivation([("1/4*h", "u + v", "C")], ENERGY), derivation()], {}),
]  # fmt: skip


@functools.cache
def samples():
    """Every sample document, by a readable name."""
    made = {}
    for name, inputs, witness, options in EXPLICIT:
        made[f"{name} {len(made)}"] = certificate(*name.split("."), inputs, witness, **options)
    made |= {f"variational.delay_step_limit {d}": late(d) for d in range(MOST_DELAY + 1)}
    made["variational.design chosen"] = chosen()
    made |= stability_samples() | own_samples()
    for name in sorted({*statements()} - {key.split()[0] for key in made}):
        made |= {f"{name} decided": entry for entry in decided(name)}
    return made


def late(d):
    """Step limit with the position error d samples late."""
    gains = dict.fromkeys("MKC", ((Fraction(1),),))
    return delay_step_limit(gains | {"d": Fraction(d)}).certificate


def chosen():
    """Gains for a decay."""
    wish = {"decay": Fraction(1), "h": Fraction(1, 10), "chi": Fraction(1), "nu": Fraction(1)}
    return gains_for_decay(wish).certificate


@functools.cache
def files_of(system, claim):
    """Certificates of the decision on one claim."""
    decisions = importlib.import_module(f"verification.systems.{system}.claims").DECISIONS
    return [*decisions[claim]().certificates.values()]


def decided(name):
    """Certificates of a statement in the decision on the claim whose name it begins with.

    Those that several claims share are named after none of them and are looked for in all.
    """
    system = name.split(".", maxsplit=1)[0]
    decisions = importlib.import_module(f"verification.systems.{system}.claims").DECISIONS
    named = sorted((claim for claim in decisions if name.startswith(claim)), key=len, reverse=True)
    for claim in [*named, *decisions]:
        made = [d for d in files_of(system, claim) if f"{d['system']}.{d['name']}" == name]
        if made:
            return made
    return []
