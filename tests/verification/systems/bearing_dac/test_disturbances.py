"""The bound on the rates of what bearing sensors average, beside rates of a moving target."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from tests.strategies import rationals
from verification.inputs import read_inputs
from verification.systems.bearing_dac.quantities import QUANTITIES

(QUESTION,) = [entry for entry in QUANTITIES if entry.name == "disturbance_bound"]
GIVEN = {"v_max": 10, "rho_min": "1/2", "positions": [[0, 0], [3, 4]]}


def ask(**change):
    reading = read_inputs(QUESTION.inputs, GIVEN | change, None, "disturbance_bound")
    return QUESTION.answer(reading.values)


def averaged(place, target):
    """Entries of P and q, from the bearing alone."""
    angle = math.atan2(target[1] - place[1], target[0] - place[0])
    h = np.array([-math.sin(angle), math.cos(angle)])
    return np.concatenate([np.outer(h, h).ravel(), (h @ place) * h])


def fastest(place, speed, distance, angles=720):
    """Largest rate of an entry of P or q, by differences, as the target crosses all bearings."""
    worst, step = 0.0, 1e-6
    for theta in np.linspace(0, 2 * np.pi, angles, endpoint=False):
        along = np.array([math.cos(theta), math.sin(theta)])
        across = speed * np.array([-along[1], along[0]])
        target = place + distance * along
        change = averaged(place, target + step * across) - averaged(place, target - step * across)
        worst = max(worst, float(np.abs(change).max()) / (2 * step))
    return worst


@settings(max_examples=12)
@given(
    st.lists(st.tuples(rationals(-5, 5), rationals(-5, 5)), min_size=1, max_size=2, unique=True),
    rationals(Fraction(1, 2), 4),
    rationals(Fraction(1, 2), 4),
)
def test_no_entry_is_faster_than_the_bound_and_one_is_as_fast(places, speed, distance):
    positions = [[str(x) for x in place] for place in places]
    bound = ask(v_max=str(speed), rho_min=str(distance), positions=positions).value
    found = max(
        fastest(np.array([float(x) for x in place]), float(speed), float(distance), 90)
        for place in places
    )
    assert found <= bound * (1 + 1e-6)
    assert found >= bound * math.cos(2 * math.pi / 90)


def test_rational_and_irrational_distances_are_exact():
    assert ask().exact == {"kind": "rational", "value": "100"}
    root = ask(positions=[[1, 1]])
    assert root.exact["polynomial"] == [-800, 0, 1]
    assert root.value == math.sqrt(800)
    assert ask(v_max=0).value == 0.0


def test_near_the_origin_entries_of_p_decide():
    near = ask(positions=[["1/2", 0], [0, "-3/5"]])
    assert near.value == 20.0
    assert "P decide" in near.notes[0]
    assert "(3, 4)" in ask().notes[0]


@pytest.mark.parametrize(
    "change, name, found",
    [
        ({"v_max": -1}, "v_max", "-1"),
        ({"v_max": "NaN"}, "v_max", "NaN"),
        ({"rho_min": 0}, "rho_min", "0"),
        ({"rho_min": "-1/2"}, "rho_min", "-1/2"),
        ({"positions": [[0, 0], [1, 1], [0, 0]]}, "positions", "points 1 and 3"),
        ({"positions": [[0, 0], [1, 1, 1]]}, "positions", "point 2"),
        ({"positions": [[0, "nan"]]}, "positions", "point 1"),
        ({"positions": []}, "positions", r"\[\]"),
        ({"positions": 3}, "positions", "3"),
    ],
)
def test_what_cannot_be_is_refused_by_name(change, name, found):
    with pytest.raises(InputError, match=found) as caught:
        ask(**change)
    assert caught.value.name == name
