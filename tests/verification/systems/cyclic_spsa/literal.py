"""The algorithm itself on all outcomes of its draws: mean and covariance without any formula."""

from itertools import product

import numpy as np

LAWS = {
    "two_point": ((-1.0, 1.0), (0.5, 0.5)),
    # the first five moments of the Gaussian law, all that second moments of an update need
    "gaussian": ((-(3**0.5), 0.0, 3**0.5), (1 / 6, 2 / 3, 1 / 6)),
}


def root(matrix):
    """Symmetric square root of a positive semidefinite matrix."""
    values, vectors = np.linalg.eigh(np.array(matrix, dtype=float))
    return vectors @ np.diag(np.sqrt(np.maximum(values, 0))) @ vectors.T


def outcomes(d, noise, law, instants):
    """All (Delta, xi_before, xi) with their probabilities."""
    points, weights = LAWS[law]
    draws = [
        (np.array(x), np.prod(w))
        for x, w in zip(product(points, repeat=d), product(weights, repeat=d), strict=True)
    ]
    half = root(noise)
    found = []
    for signs in product((-1.0, 1.0), repeat=d):
        for later, p in draws:
            for before, q in draws if instants == 2 else [(later, 1.0)]:
                found.append((np.array(signs), half @ before, half @ later, p * q / 2**d))
    return [np.array(part) for part in zip(*found, strict=True)]


def updated(error, hessian, eta, beta, alpha, k, instants, draws):
    """Errors after an update, from errors after the one before it, row by row of outcomes."""
    signs, noise_before, noise_later, _ = draws
    later = 2 * k * eta
    before = later - eta if instants == 2 else later
    guess = error[None, :]  # the target was at 0 at the last update
    off_before = guess - beta * signs - before - noise_before
    off_later = guess + beta * signs - later - noise_later
    y_before = (off_before @ hessian * off_before).sum(axis=1) / 2
    y_later = (off_later @ hessian * off_later).sum(axis=1) / 2
    gradient = signs * ((y_later - y_before) / (2 * beta))[:, None]
    return guess - alpha * gradient - later


def settled(hessian, noise, eta, beta, alpha, k=1, law="gaussian", instants=2, rounds=3000):
    """Mean and mean square right after an update, by taking moments from update to update."""
    hessian, eta = np.array(hessian, dtype=float), np.array(eta, dtype=float)
    d = len(hessian)
    draws = outcomes(d, noise, law, instants)
    mean, spread = np.zeros(d), np.zeros((d, d))
    for _ in range(rounds):
        # errors with this mean and this covariance
        arms = root(spread) * d**0.5
        errors = [mean + sign * arm for arm in arms for sign in (-1, 1)]
        after = np.vstack(
            [updated(e, hessian, eta, beta, alpha, k, instants, draws) for e in errors]
        )
        weights = np.tile(draws[3], len(errors)) / len(errors)
        new_mean = weights @ after
        new_spread = (after - new_mean).T @ (weights[:, None] * (after - new_mean))
        moved = abs(new_mean - mean).max() + abs(new_spread - spread).max()
        mean, spread = new_mean, new_spread
        if moved < 1e-13 * (1 + abs(mean).max() + abs(spread).max()):
            break
    return mean, np.trace(spread) + mean @ mean
