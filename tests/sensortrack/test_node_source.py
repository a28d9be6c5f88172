"""The generated source of one node has an answer for every number that can come."""

import math

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.generated import bearing_dac as node
from sensortrack.kernels.steppers import stepper

ANY = st.floats(allow_nan=True, allow_infinity=True)
SMALL = st.floats(0, 0.2499, exclude_min=False)


def numbers(count):
    return st.lists(ANY, min_size=count, max_size=count)


@settings(max_examples=150)
@given(numbers(5), SMALL, numbers(11), numbers(5))
def test_a_position_is_a_number_whatever_comes(context, det_min, state, measured):
    for found in (
        node.step([*context, det_min], state, measured),
        stepper("bearing_dac").compiled("step", [*context, det_min], state, measured),
    ):
        *place, status = list(found)[8:]
        assert status in (0.0, 1.0)
        assert all(map(math.isfinite, place))
        assert status == 1.0 or list(place) == [0.0, 0.0]


@settings(max_examples=150)
@given(numbers(4), numbers(4))
def test_a_link_pulls_by_one_at_most_whatever_comes(own, other):
    for name in ("link", "link_isotropic"):
        for found in (
            getattr(node, name)(own, other),
            stepper("bearing_dac").compiled(name, own, other),
        ):
            assert all(abs(x) <= 1 + 1e-15 for x in found)
            back = getattr(node, name)(other, own)
            assert list(back) == [-x for x in found]


@settings(max_examples=100)
@given(st.floats(1e-300, 1e300), st.floats(0, 2 * math.pi))
def test_a_direction_is_that_of_the_difference_at_every_size(size, angle):
    sine, cosine = size * math.sin(angle), size * math.cos(angle)
    found = node.link_isotropic([cosine, sine, 0, 0], [0.0] * 4)[:2]
    assert np.hypot(*found) == 1.0 or abs(np.hypot(*found) - 1) < 1e-15
    length = math.hypot(cosine, sine)
    assert np.allclose(found, [cosine / length, sine / length], atol=1e-15)


@settings(max_examples=100)
@given(st.floats(0.02, 0.98), st.floats(-1, 1), numbers(2))
def test_a_position_solves_its_equations_if_it_is_known(first, share, right):
    """At most as singular as the limit allows, with numbers of any size."""
    mixed = share * math.sqrt(first * (1 - first))
    context = [0.0] * 5 + [1e-3]
    *place, known = node.position(context, [first, mixed, *right])
    if known:
        back = np.array([[first, mixed], [mixed, 1 - first]]) @ place
        assert np.allclose(back, right, rtol=1e-10, atol=1e-10 * max(map(abs, right)))
    else:
        small = all(abs(x) < 1e26 for x in right)
        assert first * (1 - first) - mixed**2 < 1.1e-3 or not small
