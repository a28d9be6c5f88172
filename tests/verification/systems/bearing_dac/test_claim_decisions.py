"""Every sentence of the poster comes out as it has to, and not by accident."""

import copy
import math
import re
from fractions import Fraction

import numpy as np
import pytest

from tests.meta.repository import ROOT
from theory.systems.bearing_dac import SYSTEM
from theory.systems.bearing_dac.claim_statements import PROOFS, UNIVERSAL
from verification.adversary.universal_graphs import FORMS, compared, order, table
from verification.certificates import check
from verification.certificates.make import statements
from verification.systems.bearing_dac.claims import DECISIONS
from verification.systems.bearing_dac.claims.numerics import neediest
from verification.systems.bearing_dac.genuine_bearings import late_position, singular_later
from verification.verdict import Verdict

CORRECTED = {
    "prop_1_clockwise", "assumption_1_count", "assumption_2_exists", "lemma_1_symmetric",
    "lemma_2_generalized", "algorithm_1_start_needed", "theorem_1_gain", "theorem_1_time",
    "theorem_1_stays_classical", "theorem_1_estimates_printed", "theorem_2_time",
    "algorithm_1_line_12", "algorithm_1_line_12_later", "section_5_discrete_explicit",
}  # fmt: skip
DECIDED = {name.split(".")[1]: decide() for name, decide in DECISIONS.items()}
HAND_MADE = {
    stem: document
    for decision in DECIDED.values()
    for stem, document in decision.certificates.items()
    if document["name"] not in PROOFS and document["inputs"]
}
GRAPHS = compared(6)


def test_verdicts():
    assert {claim.id for claim in SYSTEM.claims} == {*DECISIONS}
    for name, decision in DECIDED.items():
        wanted = Verdict.CORRECTED if name in CORRECTED else Verdict.PROVED
        assert decision.verdict is wanted, name
        assert bool(decision.repair) == bool(decision.repair_formula) == (name in CORRECTED), name


@pytest.mark.parametrize("name", sorted(PROOFS))
def test_every_hypothesis_of_a_universal_statement_is_needed_by_its_proof(name):
    """Without any one of them, renumbered, the checker refuses."""
    (document,) = {
        str(document): document
        for decision in DECIDED.values()
        for document in decision.certificates.values()
        if document["name"] == name
    }.values()
    known = statements()
    full = known[f"bearing_dac.{name}"]
    for k in range(len(full["given"])):
        weaker = copy.deepcopy(full)
        weaker["given"][k] = "0*(" + weaker["given"][k] + ")"
        forged = document | {"digest": check.digest_of(weaker)}
        with pytest.raises(check.Reject):
            check.check_document(forged, known | {f"bearing_dac.{name}": weaker})


def test_universal_statements_name_only_symbols_that_occur():
    for entry in UNIVERSAL:
        text = " ".join([*entry.statement.given, *next(iter(entry.statement.cases.values())).show])
        letters = {letter for letter in entry.statement.symbols if letter in text}
        assert letters == {*entry.statement.symbols}, entry.name


@pytest.mark.parametrize("stem", sorted(HAND_MADE))
def test_every_predicate_of_a_counterexample_can_fail(stem):
    """With any one input changed to an unlike one, the certificate is refused."""
    document, refused = HAND_MADE[stem], 0
    for name, value in document["inputs"].items():
        for other in ("-7/3", "0", "1000"):
            if isinstance(value, (str, int)) and str(value) != other:
                inputs = document["inputs"] | {name: other}
                try:
                    check.check_document(document | {"inputs": inputs}, statements())
                except check.Reject:
                    refused += 1
    assert refused or not any(isinstance(v, (str, int)) for v in document["inputs"].values())


def simulated(entries, beta, t, steps=30_000):
    """Sign consensus of three linked sensors by many explicit steps: another road, approximate.

    A column for each entry; what the first sensor has at the end.
    """
    x, h = np.array(entries, dtype=float).T, t / steps
    for _ in range(steps):
        x = x - h * beta * np.sign(x[:, None] - x[None, :]).sum(axis=1)
    return x[0]


def information(angle):
    h = np.array([-math.sin(angle), math.cos(angle)])
    return np.outer(h, h)


def test_the_late_position_is_what_bearings_and_a_simulation_give():
    found = late_position()
    assert found.printed < float(found.t) < found.sharp
    angle, k = math.asin(float(found.bearing[1])), float(found.distance)
    infos = [information(a) for a in (angle, -angle, -angle)]
    offsets = [info @ [k, 0.0] for info in infos]
    start = math.sqrt(sum(np.sum(info**2) for info in infos) + sum(map(np.dot, offsets, offsets)))
    assert found.printed == pytest.approx(start / 3)
    entries = [[info[place] for info in infos] for place in ((0, 0), (0, 1), (1, 1))]
    entries += [[offset[i] for offset in offsets] for i in (0, 1)]
    ends = simulated(entries, float(found.beta), float(found.t))
    p11, p12, p22, q1, q2 = ends
    position = np.linalg.solve([[p11, p12], [p12, p22]], [q1, q2])
    assert position == pytest.approx(found.position, abs=0.3)
    assert np.hypot(*(position - [k, 0])) > 1.5


def test_the_determinant_returns_to_zero_and_falls_below():
    found = singular_later()
    assert found.determinant(Fraction(0)) == found.determinant(found.t) == 0
    assert found.determinant(found.t / 2) > 0 > found.determinant(found.t * Fraction(21, 20))
    assert found.determinant(found.agreement) > 0
    angles = [math.atan2(float(s), float(c)) for c, s in (found.one, found.others, found.others)]
    infos, t = [information(a) for a in angles], float(found.t) / 2
    entries = [[info[place] for info in infos] for place in ((0, 0), (0, 1))]
    ends = simulated(entries, float(found.beta), t)
    assert ends == pytest.approx([float(x) for x in found.entries(found.t / 2)], abs=1e-3)


def test_the_gain_of_the_simulation_exceeds_what_any_network_of_five_needs():
    worst = 0
    for entry in compared(5):
        if entry.network.n == 5 and entry.connectivity >= 0.4:
            worst = max(worst, 100 * entry.threshold)
    network, cut = neediest()
    assert worst == 240 == 200 * cut.p / cut.k
    assert network.n == 5
    assert 560.01 < 1 + 100 * math.sqrt(5) / 0.4 < 560.02
    left_out = [
        e.network.label
        for e in compared(5)
        if e.network.n == 5 and order(e.network, Fraction(2, 5)) < 0
    ]
    assert len(left_out) == 1  # the path


def test_forms_fail_where_they_are_said_to_fail():
    failing = {
        form: [entry.network.label for entry in GRAPHS if entry.signs[form] < 0] for form in FORMS
    }
    assert failing == {"root": [], "twice": [], "printed": ["01", "01 02 12"]}
    equal = {form: [e for e in GRAPHS if e.signs[form] == 0] for form in FORMS}
    assert [entry.network.label for entry in equal["root"]] == ["01"]
    assert all(e in equal["twice"] for e in GRAPHS if e.complete)
    late = [entry for entry in GRAPHS if entry.time < 0]
    assert late == [entry for entry in GRAPHS if entry.complete]
    for entry in GRAPHS:
        for form in FORMS:
            ratio = entry.ratio(form)
            assert (ratio > 1 + 1e-9) - (ratio < 1 - 1e-9) == entry.signs[form]


def test_the_table_counts_every_graph_once():
    rows = [dict(zip(table(6)[0][:2], row[:2], strict=True)) for row in table(6)[1:]]
    assert [int(row["graphs"]) for row in rows] == [1, 2, 6, 21, 112]


@pytest.mark.parametrize("label, square", [("complete:4", 16), ("cycle:4", 4), ("path:3", 1)])
def test_lambda_2_is_compared_exactly(label, square):
    from sensortrack.networks import read_network

    network, hair = read_network(label), Fraction(1, 10**15)
    value = Fraction(math.isqrt(square))
    assert [order(network, value + shift) for shift in (-hair, 0, hair)] == [1, 0, -1]


def test_the_table_of_the_page_is_the_one_that_is_computed():
    page = (ROOT / "docs" / "systems" / "bearing_dac_theory.md").read_text()
    shown = [line for line in page.splitlines() if re.match(r"\| \d \|", line)]
    assert shown == ["| " + " | ".join(row[:-1]) + " |" for row in table()[1:]]


@pytest.mark.parametrize("n", range(5, 12))
def test_complete_graphs_are_late_below_the_stated_disturbance_only(n):
    """Cuts of s nodes have s(n - s) links, p = s(n - s)/n, and lambda_2 = n."""
    limit = n * (math.sqrt(n / (n - 1)) - 1) / (math.sqrt(n) - 2)

    def rate(gamma):
        beta = 1 + gamma * math.sqrt(n) / n
        cuts = ((s * (n - s), s * (n - s) / n) for s in range(1, n))
        return min((beta * k - 2 * gamma * p) / math.sqrt(p) for k, p in cuts)

    assert rate(limit) == pytest.approx(n)
    assert rate(0.99 * limit) < n < rate(1.01 * limit)


DASH = np.array([[0.5, 0.0], [-0.5, 0.0], [-0.5, 0.05]])
"""Three sensors; the target rests at (0, -1), then runs north at 10 m/s to (0, 1)."""
TRIANGLE = np.array([[-1.0, -1, 0], [1, 0, -1], [0, 1, 1]])


def offsets_of_a_dash(gain, step=5e-4, rest=0.05, speed=10.0):
    """Largest error of a position after the first agreement, by implicit steps; largest rate."""
    x = before = passing(-1.0)
    agreed, worst, rate = False, 0.0, 0.0
    for k in range(1, round((rest + 0.25) / step)):
        north = float(np.clip(-1 + speed * (k * step - rest), -1, 1))
        now = passing(north)
        rate = max(rate, float(np.abs(now - before).max()) / step)
        x, flow = x + now - before, np.zeros((3, 5))
        for _ in range(40):
            flow = np.clip(flow + TRIANGLE.T @ (x - TRIANGLE @ flow) / 3, -step * gain, step * gain)
        x, before = x - TRIANGLE @ flow, now
        agreed |= bool(np.abs(x - now.mean(axis=0)).max() < 1e-12)
        for p11, p12, p22, *q in x if agreed else ():
            place = np.linalg.solve([[p11, p12], [p12, p22]], q)
            worst = max(worst, float(np.hypot(place[0], place[1] - north)))
    return worst, rate


def passing(north):
    """Three entries of P and two of q of each sensor, the target at (0, north)."""
    angle = np.arctan2(north - DASH[:, 1], -DASH[:, 0])
    h = np.stack([-np.sin(angle), np.cos(angle)])
    return np.stack([h[0] ** 2, h[0] * h[1], h[1] ** 2, *((h * DASH.T).sum(axis=0) * h)], axis=1)


def test_the_printed_gain_loses_a_moving_target_on_the_triangle():
    """In floating point: gamma = 20 bounds the rates, and the threshold is 40/3."""
    printed = 1 + 20 * math.sqrt(3) / 3
    worst, rate = offsets_of_a_dash(printed)
    assert rate < 20
    assert printed < 40 / 3
    assert worst > 0.1
    assert offsets_of_a_dash(40 / 3)[0] < 1e-9
