"""Step limits of whole networks: by blocks, by the runtime's schedule, and what is refused."""

import json
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings

from sensortrack.errors import InputError
from sensortrack.nearest import nearest_schedules, shares
from sensortrack.schedules import Schedule
from verification.certificates import check
from verification.certificates.make import CertificateError, statements
from verification.inputs import read_inputs
from verification.systems.cyclic_spsa.block_inputs import BLOCK, block_of
from verification.systems.cyclic_spsa.network import limits
from verification.systems.cyclic_spsa.network.inputs import network_of
from verification.systems.cyclic_spsa.network.limits import LIMITED, network_step_limit
from verification.systems.cyclic_spsa.network.plans import block_of_plan, plans_of
from verification.systems.cyclic_spsa.network.times import AHEAD, network_schedule
from verification.systems.cyclic_spsa.stability.witnesses import diagonal_limit

from .networks import PLAIN, networks


def ask(**given):
    return network_step_limit(read_inputs(LIMITED, given).values)


def exact(answer):
    return Fraction(answer.exact["value"])


def all_blocks(**given):
    network = network_of(read_inputs(LIMITED, given).values)
    return [
        block_of_plan(network, plan, place)
        for plan in plans_of(network)
        for place in range(len(plan.blocks.blocks))
    ]


@settings(max_examples=30, deadline=None)
@given(networks())
def test_the_limit_is_the_smallest_of_all_blocks(data):
    found = ask(**data)
    assert exact(found) == min(map(diagonal_limit, all_blocks(**data)))
    assert check.check_document(found.certificate, statements())["upper"] is not None
    alone = found.more["critical"]().data["params"]
    block = block_of(read_inputs(BLOCK, json.loads(json.dumps(alone))).values)
    assert diagonal_limit(block) == exact(found)


@settings(max_examples=30, deadline=None)
@given(networks())
def test_the_best_choice_hears_no_worse_than_the_nearest(data):
    """Every sensor's sum of variances, which is what is chosen for."""
    both = [
        plans_of(network_of(read_inputs(LIMITED, data | {"assignment": word}).values))
        for word in ("nearest", "best")
    ]
    for near, best in zip(*both, strict=True):
        assert best.sources.score <= near.sources.score
        assert best.proved


@settings(max_examples=20, deadline=None)
@given(networks())
def test_schedules_are_those_of_the_runtime(data):
    plans = plans_of(network_of(read_inputs(LIMITED, data).values))
    names = [{str(i): place for i, place in enumerate(data[key])} for key in ("sensors", "targets")]
    runtime = nearest_schedules(*names, data["n_max"], data["m_max"])
    sensors = np.array(data["sensors"], float)
    variances = {
        target: {str(q): float(x) for q, x in enumerate(((sensors - place) ** 2).sum(axis=1))}
        for target, place in names[1].items()
    }
    for plan in plans:
        own = plan.schedule()
        schedule = Schedule(own["blocks"], own["sources"])
        assert len(schedule.blocks) == own["k"]
        weights = shares(variances, own["sources"])
        if data["K"] == "harmonic":
            assert weights == pytest.approx(
                {str(i): float(h) for i, h in plan.hessian.items()}, rel=1e-9
            )
        if data["assignment"] == "nearest":
            assert [*map(list, runtime[str(plan.own)].blocks)] == own["blocks"]
            assert {t: variances[t][q] for t, q in own["sources"].items()} == {
                t: variances[t][q] for t, q in runtime[str(plan.own)].sources.items()
            }


def test_one_sensor_and_one_target_in_closed_form():
    """h = 1, tr Xi = 25 (0.01^2 + 0.05^2): alpha (2 + tr Xi/2 + 1/4) < 2 with beta = eta = 1."""
    found = ask(
        sensors=[[0, 0]], targets=[[3, 4]], sigma_bearing_rad="0.01", sigma_range_rel="0.05",
        n_max=0, m_max=1, beta=1, eta_m=1,
    )  # fmt: skip
    assert exact(found) == 2 / (2 + Fraction(25 * 26, 10000) / 2 + Fraction(1, 4))


def test_covariances_have_their_axes_along_and_across_the_line_of_sight():
    (block,) = all_blocks(
        sensors=[[0, 0]], targets=[[3, 4]], sigma_bearing_rad="0.01", sigma_range_rel="0.05",
        n_max=0, m_max=1, beta=1,
    )  # fmt: skip
    noise = np.array([[float(x) for x in row] for row in block.noise])
    along, across = np.array([0.6, 0.8]), np.array([-0.8, 0.6])
    assert noise @ along == pytest.approx(0.25**2 * along)
    assert noise @ across == pytest.approx(0.05**2 * across)


def test_drift_lowers_the_limit_whatever_its_direction():
    still, along = exact(ask(**PLAIN)), exact(ask(**PLAIN, eta_m=5))
    across = exact(ask(**PLAIN, velocities=[[3, 4]]))
    assert across == along < still


def test_few_blocks_at_a_time_have_the_larger_limit():
    limits = [exact(ask(**PLAIN | {"m_max": m, "assignment": "best"})) for m in (1, 2, 3)]
    assert limits == sorted(limits, reverse=True)
    assert limits[0] > limits[2]


def test_far_sensors_are_left_out():
    plain = PLAIN | {"reach": 170, "talk": 310}
    data = ask(**plain).more["sensors"]().data
    assert all(entry["sources"] for entry in data)
    assert [entry["neighbours"] for entry in data] == [[1], [0], [0], [1]]
    assert exact(ask(**plain)) != exact(ask(**PLAIN))


def test_the_other_assignment_is_compared():
    for word, other in (("nearest", "best"), ("best", "nearest")):
        found = ask(**PLAIN | {"assignment": word}).more["other"]().data
        assert found == {
            "assignment": other,
            "limit": str(exact(ask(**PLAIN | {"assignment": other}))),
        }


def test_the_other_reading_is_named_with_its_limit():
    for word, other in (("one", "two"), ("two", "one")):
        found = ask(**PLAIN | {"reading": word}).more["other_reading"]().data
        assert found == {
            "reading": other,
            "limit": str(exact(ask(**PLAIN | {"reading": other}))),
        }


def test_a_large_network_has_its_limit_without_a_file():
    many = PLAIN | {
        "sensors": [[7 * k, k * k % 31] for k in range(40)],
        "targets": [[7 * k + 3, -1 - k * k % 29] for k in range(12)],
    }
    found = ask(**many)
    assert found.certificate is None
    assert "no certificate" in found.notes[1]
    assert found.more["sensors"]().lines[-1][1] == "and 28 further sensors"


def ahead(**given):
    return network_schedule(read_inputs(AHEAD, given).values)


def test_the_schedule_changes_where_another_sensor_is_nearer():
    moving = PLAIN | {"velocities": [[1, 0], [0, 0], [-1, 0]]}
    found = ahead(**moving, samples=200)
    starts = [[piece["from"] for piece in own] for own in found.more["schedule"]().data]
    assert starts == [[0, 51], [0, 1, 50], [0], [0]]
    later = moving | {"targets": [[299, 100], [200, 120], [-49, 250]]}
    assert exact(found) == exact(ask(**later))  # where it is the smallest
    assert exact(ahead(**moving, samples=1)) == exact(ask(**moving))


BAD = [
    ({"sensors": [[0, 0], [0, 0]]}, "sensors", "one place"),
    ({"targets": [[1, 1], [1, 1]]}, "targets", "one place"),
    ({"targets": [[300, 0]]}, "targets", "on sensor 1"),
    ({"reach": 10}, "targets", "no sensor sees"),
    ({"reach": 120, "targets": [[1, 1]], "talk": 5}, "sensors", "sees no target"),
    ({"reach": 0}, "reach", "above 0"),
    ({"talk": -1}, "talk", "above 0"),
    ({"m_max": 0}, "m_max", "at least 1"),
    ({"m_max": "3/2"}, "m_max", "whole"),
    ({"n_max": -1}, "n_max", "at least 0"),
    ({"sigma_bearing_rad": "0.5"}, "sigma_bearing_rad", "degrees"),
    ({"sigma_bearing_rad": "-0.1"}, "sigma_bearing_rad", "at least 0"),
    ({"sigma_range_rel": "-0.1"}, "sigma_range_rel", "at least 0"),
    ({"sigma_bearing_rad": 0, "sigma_range_rel": 0}, "sigma_bearing_rad", "no noise"),
    ({"beta": 0}, "beta", "above 0"),
    ({"reading": "three"}, "reading", "one"),
    ({"K": "mean"}, "K", "harmonic"),
    ({"assignment": "any"}, "assignment", "nearest"),
    ({"eta_m": [1, 2]}, "eta_m", "one a target"),
    ({"eta_m": -1}, "eta_m", "at least 0"),
    ({"eta_m": 1, "velocities": [[1, 0]]}, "eta_m", "beside"),
    ({"velocities": [[1, 0], [0, 1]]}, "velocities", "one a target"),
]


@pytest.mark.parametrize("given, name, what", BAD)
def test_bad_input_names_what_is_wrong(given, name, what):
    with pytest.raises(InputError) as caught:
        ask(**PLAIN | given)
    assert caught.value.name == name
    assert what in str(caught.value)


@pytest.mark.parametrize(
    "given, name, what",
    [
        ({"samples": 0}, "samples", "whole"),
        ({"samples": "3/2"}, "samples", "whole"),
        (
            {"samples": 101, "velocities": [[-1, -1]]},
            "targets",
            "at sample 100: target 0 on",
        ),
    ],
)
def test_bad_input_of_schedules(given, name, what):
    with pytest.raises(InputError) as caught:
        ahead(**PLAIN | given)
    assert caught.value.name == name
    assert what in str(caught.value)


def test_the_best_choice_has_a_limit_where_the_nearest_one_fails():
    """The nearest sensor sees nothing; the next one does."""
    given_ = {"sensors": [[-5, 0], [2, 0], [1, 1]], "targets": [[3, -3]], "reach": 4}
    found = ask(**PLAIN | given_ | {"assignment": "best"})
    assert found.verdict == "PROVED"
    assert found.more["other"]().data == {"assignment": "nearest", "limit": None}
    with pytest.raises(InputError, match=r"^sensors: sensor 0, "):
        ask(**PLAIN | given_)


def test_a_certificate_that_cannot_be_made_says_why(monkeypatch):
    before = ask(**PLAIN)

    def refused(*_, **__):
        raise CertificateError("too many digits")

    monkeypatch.setattr(limits, "certificate", refused)
    answer = ask(**PLAIN)
    assert answer.certificate is None
    assert "no certificate: too many digits" in answer.notes
    assert answer.exact == before.exact
