"""Positions from bearings by consensus: exact where it is said, a status where there is none."""

import numpy as np
import pytest

from sensortrack.errors import InputError
from sensortrack.estimators.bearing_dac import NO_INFORMATION, BearingDac
from sensortrack.generated import bearing_dac as node
from sensortrack.network_families import family_network
from sensortrack.networks import Network
from sensortrack.sensors import Bearing, bearings_to

NAMES = list("abcde")
FORK = Network(NAMES, np.array([[0, 1], [1, 2], [2, 3], [1, 4]]))
RING = Network(NAMES, family_network("cycle:5").edges)
PLACES = np.array([[60.0, 10], [-20, 70], [-70, -30], [10, -80], [80, -40]])
POSITIONS = dict(zip(NAMES, PLACES, strict=True))
H = 0.01


def target(t):
    return np.array([20 * np.cos(0.6 * t), 15 * np.sin(1.1 * t)])


def see(t, without=()):
    pairs = zip(NAMES, bearings_to(target(t), PLACES), strict=True)
    return [Bearing(name, float(angle)) for name, angle in pairs if name not in without]


def estimator(network=FORK, **changes):
    given = {"beta_P": 30.0, "beta_q": 1500.0, "h": H}
    return BearingDac(network, POSITIONS, **(given | changes))


def run(e, count, see=see, state=None):
    state = e.init(see(0.0)) if state is None else state
    first = round(state.time / H)
    for k in range(first + 1, first + count + 1):
        state = e.step(k * H, state, see(k * H))
    return state


@pytest.mark.parametrize("sign", ["componentwise", "isotropic"])
@pytest.mark.parametrize("entries", ["reduced", "printed"])
@pytest.mark.parametrize("network", [FORK, RING])
def test_implicit_steps_find_the_target_to_rounding(network, sign, entries):
    state = run(estimator(network, sign=sign, entries=entries), 20)
    assert state.known.all()
    assert state.positions == pytest.approx(np.tile(target(20 * H), (5, 1)), abs=1e-11)
    assert state.status.exact


def test_explicit_steps_of_the_same_length_chatter():
    e = estimator(method="explicit")
    state = run(e, 200)
    spread = np.ptp(state.x, axis=0)
    assert (spread > H * 30.0).any()
    off = np.linalg.norm(state.positions - target(2.0), axis=1)
    assert not (state.known.all() and off.max() < 1.0)


def test_before_there_is_information_there_is_a_status_and_no_number():
    state = estimator().init(see(0.0))
    assert not state.known.any()
    assert np.isnan(state.positions).all()
    assert NO_INFORMATION in state.notes


def test_parallel_bearings_give_no_position_however_long_they_are_seen():
    e = estimator()

    def straight(_):
        return [Bearing(name, 0.7 + np.pi * (k % 2)) for k, name in enumerate(NAMES)]

    state = run(e, 10, straight)
    assert not state.known.any()
    assert np.isnan(state.positions).all()
    assert state.notes == (NO_INFORMATION,)


def test_a_sensor_under_the_target_has_no_bearing_and_is_reported():
    angles = bearings_to(PLACES[2], PLACES)
    assert np.isnan(angles[2])
    assert np.isfinite(np.delete(angles, 2)).all()
    e = estimator()
    state = run(e, 5)
    seen = [Bearing(n, float(a)) for n, a in zip(NAMES, angles, strict=True)]
    after = e.step(6 * H, state, seen)
    assert not after.fresh[2]
    assert "no bearing from c: its last bearing is used" in after.notes
    assert np.isfinite(after.x).all()


def test_who_withdraws_leaves_the_others_exact():
    e = estimator(entries="printed", missing="withdraw")
    state = run(e, 20)
    state = run(e, 20, lambda t: see(t, without="bd"), state)
    assert state.fresh.tolist() == [True, False, True, False, True]
    assert state.positions == pytest.approx(np.tile(target(40 * H), (5, 1)), abs=1e-10)
    assert "no bearing from b: it counts no longer" in state.notes


def test_who_sees_nothing_at_first_joins_with_its_first_bearing():
    e = estimator(RING)
    start = e.init(see(0.0, without="c"))
    assert start.present.tolist() == [True, True, False, True, True]
    state = run(e, 20, lambda t: see(t, without="c"), start)
    assert state.positions[state.present] == pytest.approx(np.tile(target(0.2), (4, 1)), abs=1e-11)
    state = run(e, 20, see, state)
    assert state.present.all()
    assert state.positions == pytest.approx(np.tile(target(0.4), (5, 1)), abs=1e-11)


def test_hand_over_makes_the_others_exact_at_once_and_failing_does_not():
    e = estimator(RING)
    state = run(e, 20)
    kept = np.array([0, 2, 3, 4])
    handed, failed = (run(e, 20, see, e.leave(state, "b", h)) for h in (True, False))
    assert handed.positions[kept] == pytest.approx(np.tile(target(0.4), (4, 1)), abs=1e-10)
    assert handed.x[kept] == pytest.approx(np.tile(e.average(handed), (4, 1)), abs=1e-9)
    assert np.abs(failed.x[kept] - e.average(failed)).max() > 1e-3
    assert np.isnan(handed.positions[1]).all()
    back = run(e, 20, see, e.join(handed, "b"))
    assert back.positions == pytest.approx(np.tile(target(0.6), (5, 1)), abs=1e-10)


def test_the_sum_of_the_internal_states_stays_zero_through_dropouts_and_hand_overs():
    rng = np.random.default_rng(5)
    for sign in ("componentwise", "isotropic", "linear"):
        for method in ("implicit", "explicit"):
            e = estimator(RING, sign=sign, method=method)
            state = e.init(see(0.0))
            for k in range(1, 30):
                state = e.step(k * H, state, see(k * H), active=rng.random(5) < 0.6)
                if k == 15:
                    state = e.leave(state, "d")
                scale = np.abs(state.w).sum(axis=0) + 1
                assert (np.abs(state.w.sum(axis=0)) <= 1e-12 * scale).all()


def test_isotropic_signs_keep_what_is_known_positive_and_entries_apart_do_not():
    """A target at rest: the P_x of all sensors stay in the disc in which they start."""
    rng = np.random.default_rng(11)
    broken = 0
    for _ in range(12):
        angles = [Bearing(n, a) for n, a in zip(NAMES, rng.uniform(0, np.pi, 5), strict=True)]
        for sign in ("isotropic", "componentwise"):
            e = estimator(RING, sign=sign, beta_P=1.0, beta_q=50.0, det_min=0.0)
            state, least = e.init(angles), 0.0
            for k in range(1, 25):
                state = e.step(k * H, state, angles)
                first, mixed = state.x[:, 0], state.x[:, 1]
                least = min(least, float((first * (1 - first) - mixed**2).min()))
            if sign == "isotropic":
                assert least >= -1e-7
            else:
                broken += least < -1e-4
    assert broken > 0


def test_explicit_steps_are_those_of_the_generated_source_of_one_node():
    """Each node from its own bearing and its neighbours' messages alone."""
    for sign, link in (("componentwise", node.link), ("isotropic", node.link_isotropic)):
        e = estimator(RING, method="explicit", sign=sign)
        state = e.init(see(0.0))
        contexts = [[*place, H, 30.0, 1500.0, e.det_min] for place in PLACES]
        angles = [view.angle for view in see(0.0)]
        nodes = [node.init(c, [a]) for c, a in zip(contexts, angles, strict=True)]
        neighbours = [[(i - 1) % 5, (i + 1) % 5] for i in range(5)]
        for k in range(1, 8):
            state = e.step(k * H, state, see(k * H))
            messages = [row[4:8] for row in nodes]
            pulls = [
                np.sum([link(messages[i], messages[j]) for j in neighbours[i]], axis=0)
                for i in range(5)
            ]
            angles = [view.angle for view in see(k * H)]
            nodes = [node.step(contexts[i], nodes[i], [angles[i], *pulls[i]]) for i in range(5)]
            rows = np.array(nodes)
            assert rows[:, :4] == pytest.approx(state.w, abs=1e-9)
            assert rows[:, 4:8] == pytest.approx(state.x, abs=1e-9)
            assert rows[:, 10].astype(bool).tolist() == state.known.tolist()


def test_who_is_no_neighbour_changes_no_bit_of_an_explicit_step():
    e = estimator(FORK, method="explicit")
    state = run(e, 3)
    plain = e.step(5 * H, e.step(4 * H, state, see(4 * H)), see(5 * H))
    changed = [Bearing(v.sensor, v.angle + 0.3 * (v.sensor == "d")) for v in see(4 * H)]
    other = e.step(5 * H, e.step(4 * H, state, changed), see(5 * H))
    far, near = NAMES.index("a"), NAMES.index("c")
    assert other.x[far].tobytes() == plain.x[far].tobytes()
    assert other.x[near].tobytes() != plain.x[near].tobytes()


def test_the_origin_changes_the_way_but_not_where_it_leads():
    plain = run(estimator(), 20)
    moved = run(estimator(origin=(300.0, -200.0), beta_q=20000.0), 20)
    assert plain.positions == pytest.approx(moved.positions, abs=1e-9)


@pytest.mark.parametrize("method,sign", [("explicit", "componentwise"), ("explicit", "isotropic")])
def test_twice_the_unit_of_length_halves_the_numbers_bit_by_bit(method, sign):
    """A power of two, so that nothing is rounded; P has no unit, q that of length."""
    one = estimator(RING, method=method, sign=sign)
    places = {name: place / 2 for name, place in POSITIONS.items()}
    other = BearingDac(RING, places, 30.0, 750.0, H, method=method, sign=sign)
    a, b = (run(e, 12) for e in (one, other))
    assert (b.x * [1, 1, 2, 2]).tobytes() == a.x.tobytes()
    assert np.array_equal(b.positions * 2, a.positions, equal_nan=True)


def test_the_reduced_state_is_the_first_row_of_the_printed_one():
    """Signs are odd and every P has the trace 1, so the two agree at every step."""
    reduced, printed = (run(estimator(entries=e), 3) for e in ("reduced", "printed"))
    assert printed.x[:, [0, 1, 4, 5]] == pytest.approx(reduced.x, abs=1e-9)
    assert printed.x[:, 3] == pytest.approx(1 - printed.x[:, 0], abs=1e-9)


@pytest.mark.parametrize(
    "changes,name",
    [
        ({"beta_P": 0.0}, "beta_P"),
        ({"beta_q": float("nan")}, "beta_q"),
        ({"h": -1.0}, "h"),
        ({"method": "magic"}, "method"),
        ({"sign": "square"}, "sign"),
        ({"entries": "three"}, "entries"),
        ({"missing": "guess"}, "missing"),
        ({"missing": "withdraw"}, "missing"),
        ({"det_min": 0.25}, "det_min"),
        ({"det_min": float("nan")}, "det_min"),
        ({"origin": (1.0, 2.0, 3.0)}, "origin"),
        ({"origin": (float("inf"), 0.0)}, "origin"),
        ({"positions": {"a": (0, 0)}}, "positions"),
        ({"positions": {**POSITIONS, "z": (0, 0)}}, "positions"),
        ({"positions": {**POSITIONS, "a": (0, float("nan"))}}, "positions"),
        ({"positions": {**POSITIONS, "a": (0, 1, 2)}}, "positions"),
    ],
)
def test_bad_parameters_are_refused_by_name(changes, name):
    given = {"network": FORK, "positions": POSITIONS, "beta_P": 1.0, "beta_q": 1.0, "h": H}
    with pytest.raises(InputError) as error:
        BearingDac(**(given | changes))
    assert error.value.name == name


def test_measurements_that_cannot_be_are_refused():
    e = estimator()
    state = run(e, 2)
    for bearings in ([Bearing("z", 0.0)], [Bearing("a", 0.0), Bearing("a", 1.0)]):
        with pytest.raises(InputError) as error:
            e.step(3 * H, state, bearings)
        assert error.value.name == "measurement"
    for t in (2 * H, H, 5 * H, float("nan")):
        with pytest.raises(InputError) as error:
            e.step(t, state, see(3 * H))
        assert error.value.name == "t"
    with pytest.raises(InputError) as error:
        e.step(3 * H, state, see(3 * H), active=[True])
    assert error.value.name == "active"
    with pytest.raises(InputError) as error:
        e.init([Bearing("a", float("nan"))])
    assert error.value.name == "measurement"
    for call in (
        lambda: e.leave(state, "z"),
        lambda: e.join(state, "a"),
        lambda: e.leave(e.leave(state, "a"), "a"),
        lambda: e.leave(e.leave(state, "b", False), "a"),
    ):
        with pytest.raises(InputError) as error:
            call()
        assert error.value.name == "sensor"
