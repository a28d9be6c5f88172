"""Views and their weighted average: signs, rescaled weights, what is refused."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sensortrack.errors import InputError
from sensortrack.sensors import View, average, checked_weights

REST = np.zeros(3)


def view(name, target, own=(1.0, 2.0, 3.0)):
    own = np.array(own)
    return View(name, own, REST, own - np.array(target), REST)


def test_both_signs_name_the_same_target():
    own, target = np.array([1.0, 2.0, 3.0]), np.array([4.0, 4.0, 4.0])
    ours = View("a", own, REST, own - target, REST)
    theirs = View.from_sensor("a", own, REST, target - own, REST)
    assert ours.target == pytest.approx([4, 4, 4, 0, 0, 0])
    assert theirs.target == pytest.approx(ours.target)


@given(st.lists(st.floats(0.1, 5), min_size=2, max_size=6), st.integers(0, 5))
def test_weights_of_those_that_see_are_rescaled(sizes, lost):
    total = sum(sizes)
    weights = {str(k): size / total for k, size in enumerate(sizes)}
    seeing = [str(k) for k in range(len(sizes)) if k != lost % len(sizes)]
    found = average([view(name, [float(name), 0, 0]) for name in seeing], weights)
    left = sum(weights[name] for name in seeing)
    assert found.position[0] == pytest.approx(
        sum(weights[name] / left * float(name) for name in seeing)
    )
    assert found.used == tuple(seeing)


def test_agreement_is_kept_whatever_the_weights():
    target = [7.0, -1.0, 2.0]
    found = average([view("a", target), view("b", target)], {"a": 0.9, "b": 0.1})
    assert found.position == pytest.approx(target)


def test_a_measurement_that_is_no_number_is_skipped_and_named():
    found = average([view("a", [1, 1, 1]), view("b", [np.nan] * 3)], {"a": 0.5, "b": 0.5})
    assert found.position == pytest.approx([1, 1, 1])
    assert (found.used, found.skipped) == (("a",), ("b",))
    nobody = average([view("b", [np.nan] * 3)], {"a": 0.5, "b": 0.5})
    assert nobody.position is None
    assert average([], {"a": 1.0}).velocity is None


@pytest.mark.parametrize(
    "weights", [{}, {"a": 0.5}, {"a": 0.6, "b": 0.6}, {"a": 1.5, "b": -0.5}, {"a": float("nan")}]
)
def test_weights_that_are_not_positive_of_sum_one_are_refused(weights):
    with pytest.raises(InputError) as error:
        checked_weights(weights)
    assert error.value.name == "weights"


def test_a_sensor_twice_or_unknown_is_refused_by_name():
    weights = {"a": 0.5, "b": 0.5}
    for views, word in (
        ([view("a", REST)] * 2, "a twice"),
        ([view("c", REST)], "unknown sensor c"),
    ):
        with pytest.raises(InputError, match=word) as error:
            average(views, weights)
        assert error.value.name == "measurement"


def test_a_vector_needs_three_numbers():
    with pytest.raises(InputError) as error:
        View.from_sensor("a", [1, 2], REST, REST, REST)
    assert error.value.name == "position"
