"""Claims about the cycle and its steps, on a second road: enumerations and simulated steps."""

import itertools
import math

import numpy as np
import pytest

from verification.certificates import check
from verification.certificates.make import CertificateError, statements
from verification.systems.cyclic_spsa.claims import DECISIONS
from verification.systems.cyclic_spsa.claims.common import replayed
from verification.systems.cyclic_spsa.printed.schedule_figures import (
    age_of_the_base,
    blocks_over_time,
    lag_of_steps,
)


def rows(name):
    return [list(row) for row in DECISIONS[f"cyclic_spsa.{name}"]().replay[1:]]


def test_the_table_of_indices_is_what_the_printed_formulas_give():
    table = [[int(x) for x in row] for row in rows("section_3_active_index")]
    assert [row[0] for row in table] == [1, 2, 3, 4]
    for t, pair, printed, repaired in table:
        assert printed == t % 4 // 2
        assert repaired == pair == math.ceil(t / 2)


def test_the_table_of_lags_agrees_with_a_simulated_cycle():
    """Each block remembers when it was updated; at the end its age is read off."""
    for k, u, printed, lag in ([int(x) for x in row] for row in rows("section_3_shift")):
        ages = {}
        for t in range(1, 2 * k + 1):
            if t % 2 == 0:
                ages[t // 2] = t
        assert lag == 2 * k - ages[u]
        assert printed == u * (2 * k - 2)
        assert (printed == lag) == (k == 1 or u == 1)


def test_the_table_of_instants_has_every_printed_clash():
    table = [[int(x) for x in row] for row in rows("algorithm_1_clock")]
    printed = [row[2] for row in table]
    assert printed == [4, 6, 6, 8, 8, 10]
    assert [row[3] for row in table] == [2, 4, 6, 8, 10, 12]


@pytest.mark.parametrize("change", [{"k": 1}, {"S": 3}, {"T": 2}, {"u": 1}, {"v": 3}])
def test_a_clash_needs_each_of_its_numbers(change):
    good = {"k": 2, "T": 1, "S": 2, "u": 2, "v": 1}
    assert replayed("algorithm_1_clock", good)
    with pytest.raises(CertificateError):
        replayed("algorithm_1_clock", good | change)


def test_one_block_has_no_false_lag():
    with pytest.raises(CertificateError):
        replayed("section_3_shift", {"k": 1, "T": 1, "u": 1, "l": 0})


def test_what_an_inactive_coordinate_adds_is_the_mean_square_of_four_outcomes():
    h, beta, r, d = 1.0, 0.03, 300.0, 15.0
    extra = [
        h * ((r + i * d) ** 2 - (r + j * d) ** 2) / (4 * beta)
        for i, j in itertools.product((1, -1), repeat=2)
    ]
    decision = DECISIONS["cyclic_spsa.algorithm_1_inactive_observed"]()
    assert np.mean(extra) == pytest.approx(0)
    document = decision.certificates["cyclic_spsa.algorithm_1_inactive_observed"]
    square = float(document["inputs"]["n"])
    assert square == pytest.approx(np.mean(np.square(extra)), rel=1e-12)
    assert square == pytest.approx((h * r * d / beta) ** 2 / 2, rel=1e-12)
    assert "106066 km" in decision.reason


def test_one_measurement_for_both_costs_adds_nothing():
    """The same draws in both costs: what inactive targets contribute cancels."""
    rng = np.random.default_rng(3)
    q, x, delta, beta = rng.normal(300, 15, 4), rng.normal(size=4), np.array([1, -1, 1, 1]), 0.03
    active = np.array([1, 1, 0, 0])
    observed, alone = (
        [
            np.sum(mask * (active * (x + side * beta * delta) - q) ** 2) / (4 * beta)
            for side in (1, -1)
        ]
        for mask in (np.ones(4), active)
    )
    assert observed[0] - observed[1] == pytest.approx(alone[0] - alone[1], rel=1e-6)


def test_a_hessian_across_targets_spoils_even_that():
    """AH = AHA is needed: with terms across, inactive measurements do not cancel."""
    rng = np.random.default_rng(6)
    half = rng.normal(size=(4, 4))
    h, a = half @ half.T, np.diag([1.0, 1, 0, 0])
    block = a @ h @ a + (np.eye(4) - a) @ h @ (np.eye(4) - a)
    x, y, q = (rng.normal(size=4) for _ in range(3))
    for matrix, equal in ((block, True), (h, False)):
        whole = [(a @ p - q) @ matrix @ (a @ p - q) for p in (x, y)]
        alone = [(p - q) @ a @ matrix @ a @ (p - q) for p in (x, y)]
        assert math.isclose(whole[0] - whole[1], alone[0] - alone[1]) is equal


def test_the_cost_of_active_targets_does_not_see_the_others():
    rng = np.random.default_rng(4)
    half = rng.normal(size=(4, 4))
    a, h, x, q = np.diag([1.0, 1, 0, 0]), half @ half.T, rng.normal(size=4), rng.normal(size=4)
    cost = a @ h @ a
    seen = [(y - q) @ cost @ (y - q) for y in (x, a @ x, x + np.array([0, 0, 9, -9]))]
    assert seen == pytest.approx([seen[0]] * 3)
    assert not math.isclose((a @ x - q) @ h @ (a @ x - q), (x - q) @ h @ (x - q))


def test_a_neighbours_measurement_belongs_to_the_neighbours_place():
    own, other, target = np.array([0.0, 0]), np.array([60.0, 80]), np.array([100.0, -20])
    offset = target - other
    psi, rho = math.atan2(*offset), math.hypot(*offset)
    step = rho * np.array([math.sin(psi), math.cos(psi)])
    assert other + step == pytest.approx(target)
    assert np.linalg.norm(own + step - target) == pytest.approx(100)


def test_a_link_that_carries_both_ways_does_not_refute_the_set_of_neighbours():
    both = {"C": [[0, 1], [1, 0]], "a": [[1], [0]], "b": [[0], [1]]}
    with pytest.raises(CertificateError):
        replayed("section_3_neighbours", both)


def test_steps_three_four_and_six_are_in_this_order():
    files = DECISIONS["cyclic_spsa.algorithm_1_first_cost"]().certificates
    early = files["cyclic_spsa.algorithm_1_first_cost"]
    for change in ({"known": 3}, {"needed": 7}):
        with pytest.raises(check.Reject):
            check.check_document(early | {"inputs": early["inputs"] | change}, statements())


@pytest.mark.parametrize("k, marked", [(1, 0), (2, 4), (3, 6)])
def test_the_figure_marks_each_pair_that_is_split(k, marked):
    figure = blocks_over_time(k, 2)
    assert len(figure.dots[0].x) == marked
    assert max(figure.curves[0].y) == k


@pytest.mark.parametrize("k", [1, 2, 4])
def test_the_figure_of_ages_is_above_the_last_update_where_the_base_is_stale(k):
    last, printed = age_of_the_base(k, 5).curves
    stale = [age > last.y[0] for age in printed.y]
    assert any(stale) == (k > 1)
    assert all(stale[2 * k :]) == (k > 1)


def test_the_figure_of_lags_ends_where_theory_has_them():
    kept, falling = lag_of_steps(0.1, 80).curves
    assert kept.y[-1] == pytest.approx(10, rel=1e-3)
    assert falling.y[-1] == pytest.approx(81 / 2)  # after n updates it is (n + 1)/2
