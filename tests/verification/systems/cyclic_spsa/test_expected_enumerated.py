"""Expected squares beside an enumeration of every draw of Algorithm 1.

Squares of the error are of fourth degree in the noise, and so the expectation over Gaussian noise
is that over three nodes of Gauss and Hermite in each coordinate, exactly.
"""

import itertools
import math

import numpy as np
import pytest

from verification.systems.cyclic_spsa.running.expected_squares import Setting, expected_squares

NODES = ((-math.sqrt(3), 1 / 6), (0.0, 2 / 3), (math.sqrt(3), 1 / 6))
SENSORS = np.array([[0.0, 0.0], [100.0, 20.0]])


def setting(instants, blocks, samples, speed):
    time = speed * np.arange(samples)[:, None]
    first, second = np.array([40.0, 30.0]), np.array([-20.0, 50.0])
    return Setting(
        alpha=0.2,
        beta=6.0,
        instants=instants,
        paths=np.stack([first + time * [1.0, 0.5], second + time * [-0.3, 1.0]], axis=1),
        sensors=SENSORS,
        along=0.003,
        across=0.001,
        shares=[{"sources": [0, 1], "blocks": blocks, "weights": [0.7, 0.4]}],
        start=np.array([[[60.0, 60.0], [-30.0, 20.0]]]),
    )


def measured(given, nodes, target, t):
    """Where a source measures a target, for each node of its two coordinates."""
    apart = given.paths[t, target] - SENSORS[given.shares[0]["sources"][target]]
    along, across = math.sqrt(given.along), math.sqrt(given.across)
    turned = np.stack([along * apart, across * apart[::-1] * [-1.0, 1.0]])
    return given.paths[t, target] + nodes @ turned


def enumerated(given, block):
    """Mean squares of a block's errors, samples by targets, over all signs and nodes."""
    (share,) = given.shares
    u, size, k = share["blocks"].index(block), 2 * len(block), len(share["blocks"])
    h = np.repeat([share["weights"][i] for i in block], 2)
    every = [*itertools.product(NODES, repeat=size * given.instants)]
    nodes = np.array([[node for node, _ in row] for row in every])
    chances = np.array([math.prod(weight for _, weight in row) for row in every])
    delta = np.array([*itertools.product((-1.0, 1.0), repeat=size)])[None, :, None, :]
    theta, weights, found = given.start[0, block].reshape(1, size), np.ones(1), []
    for t in range(len(given.paths)):
        if t >= 2 * (u + 1) and (t - 2 * (u + 1)) % (2 * k) == 0:
            places = []
            for a in range(given.instants):
                own = nodes[:, a * size : (a + 1) * size]
                when = t - given.instants + 1 + a
                pairs = [
                    measured(given, own[:, 2 * b : 2 * b + 2], i, when) for b, i in enumerate(block)
                ]
                places.append(np.hstack(pairs)[None, None])
            at = theta[:, None, None, :]
            before = (h * (at - given.beta * delta - places[0]) ** 2).sum(axis=-1) / 2
            after = (h * (at + given.beta * delta - places[-1]) ** 2).sum(axis=-1) / 2
            slope = (after - before) / (2 * given.beta)
            theta = (at - given.alpha * delta * slope[..., None]).reshape(-1, size)
            weights = np.multiply.outer(weights, np.tile(chances / 2**size, 2**size)).ravel()
        squares = weights @ (theta - given.paths[t, block].ravel()) ** 2
        found.append(squares.reshape(-1, 2).sum(axis=1))
    return np.array(found)


@pytest.mark.parametrize(
    "instants,blocks,samples,speed,near",
    [
        (1, [[0], [1]], 7, 3.0, 1e-13),
        (1, [[1, 0]], 4, 3.0, 1e-13),
        (2, [[0], [1]], 5, 0.0, 1e-13),
        (2, [[1, 0]], 3, 0.0, 1e-13),
        # covariances of two instants are taken for equal, and differ a little
        (2, [[0], [1]], 5, 0.3, 2e-6),
        (2, [[1, 0]], 3, 3.0, 2e-4),
    ],
)
def test_expected_squares_are_those_of_an_enumeration(instants, blocks, samples, speed, near):
    given = setting(instants, blocks, samples, speed)
    squares, _ = expected_squares(given)
    for block in blocks:
        assert squares[:, 0, block] == pytest.approx(enumerated(given, block), rel=near)
