"""Exact runs of the inclusion: they solve it, obey its laws and take the times that are proved."""

from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.data import load_network
from sensortrack.networks import Network, read_network
from tests.strategies import connected_networks, networks, rationals
from verification.exact.cuts.extreme import slowest, threshold
from verification.exact.runs.filippov import LongRunError, filippov_run
from verification.exact.runs.prox import centred, implicit_step

FEW = settings(max_examples=30)
GAINS = rationals(Fraction(1, 5), 3, 5)


def numbers(draw, n, most=3, denominator=4):
    return [draw(rationals(-most, most, denominator)) for _ in range(n)]


def square(x):
    return sum(v * v for v in x)


def apart(x, y):
    return square(a - b for a, b in zip(x, y, strict=True))


def variation(network, x):
    pairs = zip(network.edges.tolist(), network.exact_weights(), strict=True)
    return sum(w * abs(x[i] - x[j]) for (i, j), w in pairs)


@st.composite
def runs(draw, drawn, pushed=False):
    """Network, gain, phases and the run."""
    network, beta, phases = draw(drawn), draw(GAINS), None
    if pushed:
        lengths = [draw(rationals(Fraction(1, 5), 2, 5)) for _ in range(draw(st.integers(1, 3)))]
        phases = [(length, numbers(draw, network.n)) for length in lengths]
    x0 = numbers(draw, network.n, 3, 3)
    return network, beta, x0, phases, filippov_run(network, beta, x0, phases)


def assert_solves(network, beta, run):
    """Each piece moves with a selection of the signs at both of its ends."""
    for piece, (x, y) in zip(run.pieces, pairwise(run.points), strict=True):
        moved = [a + piece.duration * u for a, u in zip(x, piece.disturbance, strict=True)]
        moved = centred(network, moved)
        links = piece.network
        edges = zip(links.edges.tolist(), links.exact_weights(), piece.signs, strict=True)
        for (i, j), w, sign in edges:
            assert abs(sign) <= 1
            assert all(sign * (z[i] - z[j]) == abs(z[i] - z[j]) for z in (x, y))
            moved[i] -= piece.duration * beta * w * sign
            moved[j] += piece.duration * beta * w * sign
        assert tuple(moved) == y


@given(runs(networks(1, 7, weighted=True)))
@FEW
def test_without_disturbance_a_run_solves_the_inclusion_and_ends_in_agreement(case):
    network, beta, x0, _, run = case
    assert_solves(network, beta, run)
    assert run.points[0] == tuple(centred(network, x0))
    assert not any(run.points[-1])
    assert run.agreement == run.times[-1]
    for point in run.points:
        assert not any(sum(point[i] for i in nodes) for nodes in network.components())


@given(runs(networks(1, 6, weighted=True), pushed=True))
@FEW
def test_under_disturbances_a_run_solves_the_inclusion(case):
    network, beta, _, phases, run = case
    assert_solves(network, beta, run)
    assert run.times[-1] == sum(length for length, _ in phases)
    ends = [sum((length for length, _ in phases[:k]), Fraction(0)) for k in range(len(phases) + 1)]
    assert {*ends} <= {*run.times}


@given(runs(connected_networks(2, 7, weighted=True)))
@FEW
def test_speed_falls_at_every_event_and_total_variation_by_its_square(case):
    network, beta, _, _, run = case
    speeds = []
    for piece, (x, y) in zip(run.pieces, pairwise(run.points), strict=True):
        speeds.append(apart(x, y) / piece.duration**2)
        fall = beta * (variation(network, x) - variation(network, y))
        assert fall == piece.duration * speeds[-1]
    assert all(before > after for before, after in pairwise([*speeds, 0]))


@given(runs(connected_networks(2, 6, weighted=True), pushed=True), st.data())
@FEW
def test_runs_under_one_disturbance_never_part(case, data):
    network, beta, _, phases, run = case
    other = filippov_run(network, beta, numbers(data.draw, network.n), phases)
    times = sorted({*run.times, *other.times})
    gaps = [apart(run.at(time), other.at(time)) for time in times]
    assert all(before >= after for before, after in pairwise(gaps))


@given(runs(connected_networks(2, 6, weighted=True)), rationals(Fraction(1, 7), 7, 7))
@FEW
def test_time_scales_with_the_start_and_against_the_gain(case, factor):
    network, beta, x0, _, run = case
    longer = filippov_run(network, beta, [factor * v for v in x0])
    quicker = filippov_run(network, factor * beta, x0)
    assert longer.agreement == factor * run.agreement
    assert quicker.agreement * factor == run.agreement


@given(runs(connected_networks(2, 6, weighted=True)), st.sampled_from([1, 4, 16]))
@FEW
def test_implicit_steps_come_to_the_run_as_they_get_shorter(case, steps):
    """The error of n steps of h is at most n h |v| / sqrt(n), v being the first velocity."""
    network, beta, _, _, run = case
    if not run.pieces:
        return
    time = run.agreement / 2
    x = run.points[0]
    for _ in range(steps):
        x = implicit_step(network, x, beta * time / steps)
    speed = apart(*run.points[:2]) / run.pieces[0].duration ** 2
    assert apart(x, run.at(time)) <= time**2 * speed / steps


@pytest.mark.parametrize("family", ["path:7", "cycle:6", "complete:5", "star:4"])
def test_one_implicit_step_is_the_run_on_paths_cycles_and_complete_graphs(family):
    network, rng = read_network(family), np.random.default_rng(3)
    for _ in range(4):
        x0 = [Fraction(int(v), 10) for v in rng.integers(-30, 30, network.n)]
        run = filippov_run(network, Fraction(1), x0)
        for share in (Fraction(1, 5), Fraction(2, 3), Fraction(1)):
            time = share * run.agreement
            assert run.at(time) == implicit_step(network, run.points[0], time)


def test_one_implicit_step_is_not_the_run_on_a_star_of_five():
    network = read_network("star:5")
    run = filippov_run(network, Fraction(1), [Fraction(v) for v in (0, 1, 2, 2, 2)])
    late = Fraction(3, 10)
    far = (late,) * 3
    mean = Fraction(7, 5)
    assert run.at(late) == (1 - mean, Fraction(9, 10) - mean, *far)
    assert implicit_step(network, run.points[0], late) == (*[Fraction(-9, 20)] * 2, *far)


@st.composite
def above_threshold(draw):
    """A connected network with bounds, a gain above the threshold, its slowest cut and r^2."""
    network = draw(connected_networks(2, 6, weighted=True))
    gamma = [draw(rationals(0, 2, 3)) * draw(st.integers(0, 1)) for _ in range(network.n)]
    beta = threshold(network, gamma).value + draw(GAINS)
    start = [Fraction(1), *[Fraction(0)] * (network.n - 1)]
    found = slowest(network, gamma, beta, start)
    return network, gamma, beta, found.cut, square(centred(network, start)) / found.value


@given(above_threshold(), st.data())
@FEW
def test_the_error_falls_at_least_at_the_proved_rate_under_any_disturbance(case, data):
    network, gamma, beta, _, rate_squared = case
    phases = [
        (Fraction(1, 3), [data.draw(st.fractions(-g, g, max_denominator=4)) for g in gamma])
        for _ in range(3)
    ]
    run = filippov_run(network, beta, numbers(data.draw, network.n), phases)
    for piece, (x, y) in zip(run.pieces, pairwise(run.points), strict=True):
        before, after, share = square(x), square(y), piece.duration**2 * rate_squared
        if before <= share:
            assert after == 0
        else:  # sqrt(after) <= sqrt(before) - sqrt(share)
            slack = before + share - after
            assert slack >= 0
            assert slack**2 >= 4 * before * share


@given(above_threshold(), rationals(Fraction(1, 7), 4, 7))
@FEW
def test_the_settling_time_is_attained_on_the_ray_of_the_slowest_cut(case, length):
    network, gamma, beta, cut, rate_squared = case
    x0 = [length * (i in cut) for i in range(network.n)]
    u = [g if i in cut else -g for i, g in enumerate(gamma)]
    long_enough = 2 * length * network.n / min(rate_squared, 1)
    run = filippov_run(network, beta, x0, [(long_enough, u)])
    assert run.agreement**2 * rate_squared == square(run.points[0])
    assert not any(run.points[-1])


def test_neighbours_that_move_together_may_part_again():
    """The first and the fourth node meet at 1 and part at 7/5, when the others' pull has grown."""
    edges = np.array([[0, 1], [0, 2], [0, 3], [1, 2], [3, 4]])
    network = Network(list("abcde"), edges)
    run = filippov_run(network, Fraction(1), [Fraction(v) for v in (1, 4, 6, 0, 4)])
    assert_solves(network, Fraction(1), run)
    gaps = [run.at(time)[0] - run.at(time)[3] for time in (1, Fraction(6, 5), Fraction(7, 5), 2)]
    assert gaps[:3] == [0, 0, 0]
    assert gaps[3] > 0
    assert abs(run.pieces[1].signs[2]) < 1 == run.pieces[2].signs[2]
    assert run.agreement == Fraction(11, 5)


@st.composite
def switched(draw):
    """Networks on the same nodes, a gain above all their thresholds, and the smallest rate."""
    n = draw(st.integers(2, 6))
    members = [draw(connected_networks(n, n, weighted=True)) for _ in range(3)]
    gamma = [draw(rationals(0, 2, 3)) for _ in range(n)]
    beta = max(threshold(member, gamma).value for member in members) + draw(GAINS)
    start = [Fraction(1), *[Fraction(0)] * (n - 1)]
    worst = max(slowest(member, gamma, beta, start).value for member in members)
    phases = [
        (Fraction(1, 4), [draw(st.fractions(-g, g, max_denominator=3)) for g in gamma], member)
        for member in members * 2
    ]
    run = filippov_run(members[0], beta, numbers(draw, n), phases)
    return members[0], beta, run, square(centred(members[0], start)) / worst


@given(switched())
@FEW
def test_while_links_switch_the_error_falls_at_the_smallest_rate(case):
    network, beta, run, rate_squared = case
    assert_solves(network, beta, run)
    for piece, (x, y) in zip(run.pieces, pairwise(run.points), strict=True):
        before, after, share = square(x), square(y), piece.duration**2 * rate_squared
        slack = before + share - after
        assert after == 0 if before <= share else slack >= 0
        assert before <= share or slack**2 >= 4 * before * share


def test_without_links_the_error_grows_as_fast_as_it_can_and_is_recovered_after():
    """By 2 tau sqrt(floor(n^2/4)/n), and back within that over the rate."""
    path = read_network("path:4")
    silent = Network(path.names, np.empty((0, 2), dtype=np.int64))
    zero, tau, beta = [Fraction(0)] * 4, Fraction(3, 2), Fraction(3)
    halves = push(path, {0, 1}, 1)
    outage = [(tau, halves, silent), (Fraction(9), halves)]
    run = filippov_run(path, beta, zero, outage)
    assert run.points[1] == (tau, tau, -tau, -tau)
    back = next(t for t, x in zip(run.times[1:], run.points[1:], strict=True) if not any(x))
    found = slowest(path, [Fraction(1)] * 4, beta, run.points[1])
    assert (back - tau) ** 2 == found.value


def test_links_that_join_all_only_in_turn_do_not_keep_agreement():
    path = read_network("path:3")
    one, other = (Network(path.names, path.edges[k : k + 1]) for k in range(2))
    u, short = push(path, {0}, 1), Fraction(1, 10)
    phases = [(short, u, links) for links in (one, other) * 4]
    run = filippov_run(path, Fraction(100), [Fraction(0)] * 3, phases)
    late = run.points[2:]
    assert all(any(x) for x in late)
    assert_solves(path, Fraction(100), run)


def push(network, cut, gamma):
    return [Fraction(gamma) if i in cut else -Fraction(gamma) for i in range(network.n)]


def test_printed_statements_fail_on_small_complete_graphs_to_the_digit():
    zero = Fraction(0)
    pair, triangle, four = (read_network(f"complete:{n}") for n in (2, 3, 4))
    phase = [(Fraction(5), push(pair, {0}, 4))]
    driven = filippov_run(pair, Fraction(39, 10), [zero] * 2, phase)
    assert driven.points[-1] == (Fraction(1, 2), Fraction(-1, 2))
    phase = [(Fraction(5), push(triangle, {0}, 12))]
    driven = filippov_run(triangle, Fraction(159, 20), [zero] * 3, phase)
    assert driven.points[-1] == (Fraction(1, 2), Fraction(-1, 4), Fraction(-1, 4))
    start = [Fraction(3, 4), *[Fraction(-1, 4)] * 3]
    late = filippov_run(four, Fraction(3, 2), start, [(Fraction(1), push(four, {0}, 1))])
    assert late.agreement == Fraction(1, 4)
    assert late.at(Fraction(7, 32)) == (Fraction(3, 32), *[Fraction(-1, 32)] * 3)


def test_a_gain_a_little_too_small_loses_agreement_slowly():
    path, cycle = read_network("path:5"), read_network("cycle:4")
    sharp = {path: Fraction(12, 5), cycle: Fraction(1)}
    ends = []
    for network in (path, cycle):
        phase = [(Fraction(1), push(network, {0, 1}, 1))]
        beta = sharp[network] - Fraction(1, 100)
        ends.append(filippov_run(network, beta, [Fraction(0)] * network.n, phase).points[-1])
        kept = filippov_run(network, sharp[network], [Fraction(0)] * network.n, phase)
        assert not any(kept.points[-1])
    assert ends[0] == (*[Fraction(1, 200)] * 2, *[Fraction(-1, 300)] * 3)
    assert ends[1] == (*[Fraction(1, 100)] * 2, *[Fraction(-1, 100)] * 2)


@pytest.mark.parametrize("weighted", [False, True])
def test_a_real_network_of_fifty_nodes_is_followed_to_its_end(weighted):
    network, rng = load_network("sndlib_germany50"), np.random.default_rng(8)
    if weighted:
        weights = tuple(Fraction(int(v), 10) for v in rng.integers(1, 30, network.m))
        network = Network(network.names, network.edges, weights)
    x0 = [Fraction(int(v), 100) for v in rng.integers(-999, 999, network.n)]
    run = filippov_run(network, Fraction(2, 3), x0)
    assert_solves(network, Fraction(2, 3), run)
    assert not any(run.points[-1])
    assert len(run.pieces) >= network.n - 1


def test_runs_too_long_to_follow_are_refused():
    network = read_network("path:9")
    x0 = [Fraction(i * i) for i in range(9)]
    pieces = len(filippov_run(network, Fraction(1), x0).pieces)
    assert pieces > 1
    with pytest.raises(LongRunError, match="more events"):
        filippov_run(network, Fraction(1), x0, longest=12)
    fine = [Fraction(1, 3**k) for k in range(8000, 8009)]
    with pytest.raises(LongRunError, match="binary digits"):
        filippov_run(network, Fraction(1), fine)


def test_only_times_within_the_run_are_known():
    run = filippov_run(read_network("path:2"), Fraction(1), [Fraction(1), Fraction(0)])
    assert run.at(Fraction(1, 4)) == (Fraction(1, 4), Fraction(-1, 4))
    for time in (Fraction(-1), Fraction(3)):
        with pytest.raises(ValueError, match="is known"):
            run.at(time)
    still = filippov_run(read_network("path:2"), Fraction(1), [Fraction(1)] * 2)
    assert (still.agreement, still.pieces, still.at(Fraction(0))) == (0, (), (0, 0))
    open_end = filippov_run(
        read_network("path:2"), Fraction(1), [Fraction(9), Fraction(0)], [(Fraction(1), [0, 0])]
    )
    assert open_end.agreement is None
