"""Neighbours, sources and blocks against every choice there is."""

import itertools
from fractions import Fraction

from hypothesis import given, settings
from hypothesis import strategies as st

from verification.systems.cyclic_spsa.network.assignment import (
    balanced_blocks,
    best_sources,
    nearest_sources,
    pieces,
)

VARIANCES = st.none() | st.integers(1, 12).map(lambda k: Fraction(k, 3))


@st.composite
def tables(draw):
    sensors, targets = draw(st.integers(1, 6)), draw(st.integers(1, 5))
    return [[draw(VARIANCES) for _ in range(targets)] for _ in range(sensors)]


def score(table, group):
    least = [
        min((table[q][i] for q in group if table[q][i] is not None), default=None)
        for i in range(len(table[0]))
    ]
    known = [x for x in least if x is not None]
    return len(least) - len(known), sum(known), max(known, default=0)


@given(tables(), st.integers(0, 4), st.data())
def test_no_choice_of_neighbours_is_better(table, n_max, data):
    reachable = data.draw(st.sets(st.integers(0, len(table) - 1)))
    found = best_sources(0, table, sorted(reachable), n_max)
    others = sorted(reachable - {0})
    best = min(
        score(table, (0, *group))
        for size in range(min(n_max, len(others)) + 1)
        for group in itertools.combinations(others, size)
    )
    assert found.proved
    assert found.score == best == score(table, (0, *found.neighbours))
    assert len(found.neighbours) <= n_max
    assert {*found.neighbours} == {*found.sources.values()} - {0}
    assert {*found.neighbours} <= reachable


@given(tables(), st.integers(0, 4), st.data())
def test_the_nearest_ones_are_never_better(table, n_max, data):
    distances = [Fraction(data.draw(st.integers(0, 9))) for _ in table]
    everyone = range(len(table))
    near = nearest_sources(0, table, distances, everyone, n_max)
    assert near.score == score(table, (0, *near.neighbours))
    assert best_sources(0, table, everyone, n_max).score <= near.score
    left_out = {*everyone} - {0, *near.neighbours}
    assert all(distances[q] <= distances[p] for q in near.neighbours for p in left_out)
    for i, q in near.sources.items():
        assert table[q][i] == min(
            table[p][i] for p in (0, *near.neighbours) if table[p][i] is not None
        )


def test_a_search_that_is_stopped_says_so_and_keeps_its_best():
    table = [[Fraction((7 * q + 5 * i) % 11 + 1) for i in range(6)] for q in range(9)]
    short, full = (best_sources(0, table, range(9), 3, work) for work in (3, 1_000_000))
    assert full.proved
    assert not short.proved
    assert full.score <= short.score < score(table, (0,))


WEIGHTS = st.lists(st.integers(1, 20).map(Fraction), max_size=5).map(lambda x: dict(enumerate(x)))


@settings(max_examples=60)
@given(WEIGHTS, st.integers(1, 4))
def test_no_division_into_as_many_blocks_is_lighter(weights, m_max):
    found = balanced_blocks(weights, m_max)
    count = -(-len(weights) // m_max)
    assert sorted(i for block in found.blocks for i in block) == sorted(weights)
    assert len(found.blocks) == count
    assert all(len(block) <= m_max for block in found.blocks)
    loads = [sum(weights[i] for i in block) for block in found.blocks]
    assert found.heaviest == max(loads, default=0)
    assert not loads or loads[found.critical] == found.heaviest
    every = [
        max(
            (sum(w for w, v in zip(weights.values(), places, strict=True) if u == v))
            for u in range(count)
        )
        for places in itertools.product(range(count), repeat=len(weights))
        if count and max(places.count(u) for u in range(count)) <= m_max
    ]
    assert found.proved
    assert found.heaviest == min(every, default=0)


def test_dividing_by_weight_beats_dividing_by_number():
    weights = dict(enumerate(map(Fraction, [9, 8, 1, 1])))
    found = balanced_blocks(weights, 2)
    assert found.blocks == ((0, 3), (1, 2))
    assert found.heaviest == 10


def test_a_division_that_is_stopped_is_the_greedy_one():
    weights = {i: Fraction(100 + 37 * i % 61, 3) for i in range(10)}
    short, full = (balanced_blocks(weights, 4, visits) for visits in (1, 50_000))
    assert full.proved
    assert not short.proved
    assert full.heaviest < short.heaviest


def test_pieces_begin_where_the_choice_changes():
    tables_of = {
        False: [[Fraction(1), None], [Fraction(9), Fraction(1)]],
        True: [[None, Fraction(2)], [Fraction(9), Fraction(1)]],
    }
    choices = [best_sources(0, tables_of[t >= 3], [1], 1) for t in range(6)]
    found = pieces(choices, lambda choice: dict(choice.sources))
    assert [start for start, _ in found] == [0, 3]
    assert [dict(choice.sources) for _, choice in found] == [{0: 0, 1: 1}, {0: 1, 1: 1}]
