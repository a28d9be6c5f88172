"""Normal numbers in plain arithmetic, against SciPy's quantiles and the moments of the law."""

import numpy as np
import pytest
from scipy.special import ndtri

from sensortrack.normal_numbers import centred, normals, quantiles


def test_quantiles_are_those_of_the_normal_distribution():
    q = np.concatenate([np.linspace(-0.4999, 0.4999, 20001), [-0.425, 0.425, 0.4250001]])
    wanted = ndtri(0.5 + q)
    # 1/2 + q is rounded, by 2^-54 at most, which the slope of 2.5 in the middle makes larger
    assert (np.abs(quantiles(q) - wanted) <= 4e-15 * np.abs(wanted) + 2.0**-52).all()


def test_quantiles_of_the_far_tails():
    beyond = 2.0 ** -np.arange(2, 54)
    wanted = ndtri(beyond)
    assert quantiles(beyond - 0.5) == pytest.approx(wanted, rel=4e-15)
    assert (quantiles(0.5 - beyond) == -quantiles(beyond - 0.5)).all()
    assert wanted.min() < -8.2


def test_words_lie_symmetrically_about_a_half_and_reach_neither_end():
    ends = np.array([0, 2**64 - 1, 2**63 - 1, 2**63], dtype=np.uint64)
    q = centred(ends)
    assert q.tolist() == [-0.5 + 2.0**-53, 0.5 - 2.0**-53, -(2.0**-53), 2.0**-53]
    words = np.random.default_rng(1).integers(0, 2**64, 1000, dtype=np.uint64)
    assert (normals(~words) == -normals(words)).all()


def test_moments_of_many_numbers():
    """Within five standard deviations of those of the law: 0, 1, 0, 3, and E x^8 = 105."""
    words = np.random.Philox(key=9).random_raw(400_000)
    x = normals(words)
    root = np.sqrt(len(x))
    for power, moment, variance in ((1, 0, 1), (2, 1, 2), (3, 0, 15), (4, 3, 96)):
        assert abs((x**power).mean() - moment) < 5 * np.sqrt(variance) / root
