"""The cycle as data: enumerated, and against identities for every number of blocks."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.theory.substitution import substituted
from theory.systems.cyclic_spsa import cycle_identities, schedule, step_identities

WHOLE = st.integers(1, 7)


def test_every_block_has_its_turn_once_in_every_cycle():
    for k in range(1, 6):
        found = list(schedule.pairs(k, 4))
        assert sorted((p.cycle, p.block) for p in found) == [(p.cycle, p.block) for p in found]
        assert [t for p in found for t in (p.t - 1, p.t)] == list(range(1, 8 * k + 1))
        assert all(schedule.active(k, t) == p.block for p in found for t in (p.t - 1, p.t))
        assert all(schedule.lag(k, p.block) == 2 * k * p.cycle - p.t for p in found)


@given(WHOLE, st.integers(1, 4))
def test_the_printed_index_splits_every_pair_of_two_blocks_or_more(k, cycles):
    assert len(schedule.split_pairs(k, cycles)) == (0 if k == 1 else k * cycles)


@given(WHOLE, st.integers(1, 5))
def test_the_printed_clock_clashes_unless_there_is_one_block(k, cycles):
    found = schedule.clashes(k, cycles)
    instants = [schedule.printed_clock(p) for p in schedule.pairs(k, cycles)]
    assert (len({*instants}) < len(instants)) == bool(found)
    assert bool(found) == (k > 1 and cycles > 1)


@given(WHOLE, st.integers(1, 5))
def test_the_printed_base_is_stale_unless_there_is_one_block(k, cycles):
    found = schedule.stale(k, cycles)
    assert (k == 1 and not found) or all(
        p in found for p in schedule.pairs(k, cycles) if p.cycle > 2
    )


@pytest.mark.parametrize("k", [1, 2, 5])
def test_a_run_through_the_printed_steps_finds_three_gaps_in_every_pair(k):
    found = schedule.unassigned(schedule.PRINTED, k, 3)
    gaps = {(m.step, m.name, m.t - m.of) for m in found}
    assert gaps == {("3.4", "z", 0), ("3.7", "y+", 0), ("3.8", "y+", 0), ("3.9", "theta_hat", 1)}
    assert len(found) == 4 * 3 * k


@pytest.mark.parametrize("program", [schedule.REPAIRED, schedule.ONE_INSTANT])
@pytest.mark.parametrize("k", [1, 2, 5])
def test_the_repaired_steps_read_what_was_assigned(program, k):
    assert schedule.unassigned(program, k, 4) == ()


@pytest.mark.parametrize("step", range(1, 9))
def test_a_step_left_out_of_the_repaired_ones_is_missed(step):
    program = [s for i, s in enumerate(schedule.REPAIRED) if i != step]
    assert schedule.unassigned(program, 2, 3)


@pytest.mark.parametrize("k, cycles, name", [(0, 1, "k is 0"), (2, 0, "cycles is 0")])
def test_cycles_without_blocks_are_refused(k, cycles, name):
    with pytest.raises(ValueError, match=name):
        schedule.unassigned(schedule.PRINTED, k, cycles)


def check(entries, numbers):
    for entry in entries:
        for form in entry.relations:
            assert substituted(form, {}, numbers).is_zero_matrix, (entry.name, form)
        value = substituted(entry.goal, {}, numbers)[0]
        assert value >= 0 if entry.squares else value == 0, entry.name


@settings(max_examples=20, deadline=None)
@given(WHOLE, st.integers(0, 6), st.integers(0, 6), st.sampled_from([0, 1]), st.integers(1, 5))
def test_the_identities_hold_for_whole_numbers(cycle, v, w, second, later):
    """What the letters stand for, and the divisions done by Python."""
    u, k = v + 1, v + 1 + w
    t = 2 * k * (cycle - 1) + 2 * u
    known = {"k": k, "T": cycle, "u": u, "v": v, "w": w}
    moment = t - 1 + second
    check(cycle_identities.index(), known | {"t": moment, "o": second, "p": 1 - second})
    assert (moment - 1) % (2 * k) == 2 * v + second
    check(cycle_identities.lags(), known | {"t": t, "e": 2 * k * cycle})
    check(cycle_identities.base(), known | {"t": t, "l": t - 2 * k})
    check(cycle_identities.parity(), {"t": t, "a": t // 2, "y": t // 2 - 1} | {"x": (t - 1) / 2})
    longer = known | {"k": k + 1, "t": 2 * (k + 1) * (cycle - 1) + 2 * u}
    check(cycle_identities.printed_index(), longer)
    other = {"S": cycle + later, "a": later - 1, "b": 1, "z": 0, "c": u + 1, "d": 0}
    other |= {"s": 2 * k * (cycle + later - 1) + 2, "q": t + 2, "t": t}
    check(cycle_identities.clock(), known | other)
    many = {"k": k + 1, "c": k - 1, "T": cycle + 1, "d": cycle - 1, "u": u, "v": v}
    check(cycle_identities.printed_base(), many | {"l": 2 * (k + 1) * cycle + 2 * u})


@settings(max_examples=20, deadline=None)
@given(st.integers(1, 40), st.integers(1, 9))
def test_the_least_number_of_blocks_is_the_quotient_rounded_up(targets, most):
    full = (targets - 1) // most
    rest = targets - full * most
    known = {"N": targets, "c": full, "m": most, "l": rest, "f": most - rest}
    check(step_identities.blocks_enough(), known)
    assert full + 1 == -(-targets // most)
    assert full * most < targets  # one block fewer does not hold them


def test_errors_fall_behind_when_steps_decrease():
    """A target that moves by 1 between updates, steps 1/T: the error grows beyond any bound."""
    error, worst = 0.0, []
    for update in range(1, 20_001):
        error -= error / update + 1
        worst.append(-error)
    assert worst[-1] > 9_000
    assert worst == sorted(worst)


@pytest.mark.parametrize("alpha", [0.5, 0.1, 0.01])
def test_a_constant_step_lags_by_drift_over_step(alpha):
    error = 0.0
    for _ in range(int(40 / alpha)):
        error -= alpha * error + 1
    assert error == pytest.approx(-1 / alpha)


def test_the_schedule_of_the_estimators_is_the_unambiguous_one():
    """Written twice, in packages that do not know each other."""
    from sensortrack.schedules import Schedule, Turn

    for k in (1, 2, 5):
        blocks = [[f"target {u}"] for u in range(k)]
        made = Schedule(blocks, {block[0]: "sensor" for block in blocks})
        assert made.period == 2 * k
        for pair in schedule.pairs(k, 3):
            for t in (pair.t - 1, pair.t):
                assert made.turn(t) == Turn(pair.cycle, schedule.active(k, t), t == pair.t)
