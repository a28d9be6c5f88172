"""Blocks and sources as data: each sample has one block, each target one place and one source."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from sensortrack.nearest import nearest_schedules, shares
from sensortrack.schedules import Schedule, Turn

BLOCKS = [["p", "q"], ["r"], ["s", "t"]]
SOURCES = dict.fromkeys("pqrst", "a")


def test_the_turns_of_the_samples_by_enumeration():
    schedule = Schedule(BLOCKS, SOURCES)
    wanted = [
        Turn(cycle, block, second)
        for cycle in (1, 2, 3)
        for block in (1, 2, 3)
        for second in (False, True)
    ]
    assert [schedule.turn(t) for t in range(1, 19)] == wanted
    assert schedule.period == 6
    for cycle, u in itertools.product((1, 2, 5), (1, 2, 3)):
        t = 2 * 3 * (cycle - 1) + 2 * u
        assert schedule.turn(t - 1) == Turn(cycle, u, False)
        assert schedule.turn(t) == Turn(cycle, u, True)


def test_targets_come_in_the_order_of_their_turns():
    assert Schedule([["q"], ["p"]], {"p": "a", "q": "b"}).targets == ("q", "p")


@pytest.mark.parametrize(
    "blocks,sources,name",
    [
        ([], {}, "blocks"),
        ([["p"], []], {"p": "a"}, "blocks"),
        ([["p"], ["p"]], {"p": "a"}, "blocks"),
        ([["p", "p"]], {"p": "a"}, "blocks"),
        ([["p"]], {"p": "a", "q": "a"}, "blocks"),
        ([["p", "q"]], {"p": "a"}, "sources"),
        ("pq", {"p": "a", "q": "a"}, "blocks"),
        (["pq"], {"p": "a", "q": "a"}, "blocks"),
        (None, {}, "blocks"),
        ([5], {}, "blocks"),
        ([["p"]], ["a"], "sources"),
    ],
)
def test_blocks_that_are_no_partition_into_whole_targets_are_refused(blocks, sources, name):
    with pytest.raises(InputError) as error:
        Schedule(blocks, sources)
    assert error.value.name == name


def test_samples_count_from_one():
    with pytest.raises(InputError, match="t: 0"):
        Schedule(BLOCKS, SOURCES).turn(0)


@settings(max_examples=30)
@given(
    seed=st.integers(0, 2**32 - 1),
    n=st.integers(1, 6),
    m=st.integers(1, 9),
    n_max=st.integers(0, 7),
    m_max=st.integers(1, 10),
)
def test_nearest_schedules_keep_the_limits(seed, n, m, n_max, m_max):
    """Against a search over all sensors that may be heard."""
    rng = np.random.default_rng(seed)
    sensors = {f"s{i}": rng.normal(size=2) for i in range(n)}
    targets = {f"t{i}": rng.normal(size=(3, 2)) for i in range(m)}
    made = nearest_schedules(sensors, targets, n_max, m_max)
    assert list(made) == list(sensors)
    for name, schedule in made.items():
        assert sorted(schedule.targets) == sorted(targets)
        assert len(schedule.blocks) == -(-m // m_max)
        assert max(map(len, schedule.blocks)) <= m_max
        apart = {q: np.linalg.norm(place - sensors[name]) for q, place in sensors.items()}
        heard = sorted(apart, key=apart.__getitem__)[: 1 + n_max]
        for target, source in schedule.sources.items():
            away = {q: np.linalg.norm(targets[target] - sensors[q], axis=1).max() for q in heard}
            assert away[source] == min(away.values())


def test_sensors_start_on_other_targets():
    sensors = {name: (k, 0) for k, name in enumerate("abc")}
    targets = {name: (k, 5) for k, name in enumerate("pqr")}
    first = [s.blocks[0] for s in nearest_schedules(sensors, targets, 0, 1).values()]
    assert first == [("p",), ("q",), ("r",)]


def test_what_is_out_of_reach_is_taken_from_a_neighbour_or_left_out():
    sensors = {"a": (0, 0), "b": (10, 0)}
    targets = {"p": (0, 1), "q": (10, 1), "r": (5, 0)}
    alone = nearest_schedules(sensors, targets, 0, 9, reach=6)
    assert alone["a"].sources == {"p": "a", "r": "a"}
    assert alone["b"].sources == {"q": "b", "r": "b"}
    both = nearest_schedules(sensors, targets, 1, 9, reach=6)
    assert both["a"].sources == {"p": "a", "q": "b", "r": "a"}


@pytest.mark.parametrize(
    "changes,name",
    [
        ({"m_max": 0}, "m_max"),
        ({"m_max": 1.5}, "m_max"),
        ({"m_max": 1.0}, "m_max"),
        ({"n_max": "1"}, "n_max"),
        ({"reach": "far"}, "reach"),
        ({"sensors": {"a": [(0, 0), (1, 1)]}}, "sensors"),
        ({"targets": {"p": "north"}}, "targets"),
        ({"targets": {"p": [(1, 2), (3,)]}}, "targets"),
        ({"n_max": -1}, "n_max"),
        ({"reach": 0}, "reach"),
        ({"reach": np.nan}, "reach"),
        ({"reach": 3}, "targets"),
        ({"targets": {"p": (0, 1)}, "reach": 3}, "sensors"),
        ({"targets": {}}, "targets"),
        ({"sensors": {}}, "targets"),
        ({"sensors": {"a": (0, 0, 0)}}, "sensors"),
        ({"targets": {"p": (0, np.nan)}}, "targets"),
        ({"targets": {"p": np.zeros((0, 2))}}, "targets"),
    ],
)
def test_bad_inputs_are_refused_by_name(changes, name):
    given = {"sensors": {"a": (0, 0), "b": (9, 0)}, "targets": {"p": (0, 1), "q": (5, 9)}}
    with pytest.raises(InputError) as error:
        nearest_schedules(**{"n_max": 0, "m_max": 1} | given | changes)
    assert error.value.name == name


def test_shares_of_all_sensors_add_up_to_one():
    variances = {"p": {"a": 1.0, "b": 4.0, "c": 2.0}, "q": {"a": 3.0, "b": 3.0, "c": 3.0}}
    total = {
        target: sum(shares(variances, {target: sensor})[target] for sensor in "abc")
        for target in variances
    }
    assert total == pytest.approx({"p": 1.0, "q": 1.0})
    found = shares(variances, {"p": "a", "q": "b"})
    assert found == pytest.approx({"p": 1 / 1.75, "q": 1 / 3})


@pytest.mark.parametrize(
    "variances",
    [
        {},
        {"p": {"b": 1.0}},
        {"p": {"a": 0.0}},
        {"p": {"a": 1.0, "b": np.inf}},
        {"p": {"a": None}},
    ],
)
def test_shares_need_a_variance_of_each_source(variances):
    with pytest.raises(InputError, match="variances"):
        shares(variances, {"p": "a"})


@pytest.mark.parametrize("size", [1e-320, 1e-160, 1.0, 1e307])
def test_shares_do_not_depend_on_the_unit_of_variance(size):
    found = shares({"p": {"a": size, "b": size, "c": 2 * size}}, {"p": "c"})
    assert found["p"] == pytest.approx(0.2, rel=1e-3)


@pytest.mark.parametrize("t", [0, 1.0, np.nan, "1", None, True])
def test_a_sample_is_a_whole_number(t):
    with pytest.raises(InputError, match="t: "):
        Schedule([["p"]], {"p": "a"}).turn(t)
