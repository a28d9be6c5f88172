"""Samples of every case of the statements on mean-square stability, and what they say of data."""

from fractions import Fraction

import numpy as np

from verification.systems.cyclic_spsa.errors.stationary import stationary_mse
from verification.systems.cyclic_spsa.stability.steps import decide_step, step_limit

ZERO, ONE, BETA = ((Fraction(0),),), Fraction(1), Fraction(2, 5)
COUPLED = ((ONE, Fraction(9, 10)), (Fraction(9, 10), ONE))
UNEVEN = ((ONE, Fraction(1, 2)), (Fraction(1, 2), Fraction(2)))


def block(**changes):
    """Values as the command line makes them."""
    plain = {"h": None, "H": None, "Xi": ZERO, "eta": (Fraction(0),), "beta": BETA}
    return plain | {"reading": "two", "k": ONE} | changes


def stability_samples():
    """Certificates by name."""
    noisy = {"Xi": ((Fraction(1, 10),),), "eta": (Fraction(1, 10), Fraction(1, 5))}
    full, diagonal = block(H=UNEVEN, **noisy), block(h=(ONE, Fraction(2)), **noisy)
    line = block(H=COUPLED)
    limits = {"full": full, "diagonal": diagonal, "line": line}
    steps = {
        "decays": full | {"alpha": Fraction(1, 4)},
        "grows": full | {"alpha": ONE},
        "kept": diagonal | {"alpha": ONE},
        "line": line | {"alpha": ONE},
    }
    made = {f"cyclic_spsa.step_limit {k}": step_limit(v).certificate for k, v in limits.items()}
    errors = steps | {"one instant": steps["decays"] | {"reading": "one", "k": ONE * 2}}
    made |= {f"cyclic_spsa.step {k}": decide_step(v).certificate for k, v in steps.items()}
    return made | {
        f"cyclic_spsa.stationary_mse {k}": stationary_mse(v | {"law": "gaussian"}).certificate
        for k, v in errors.items()
    }


def _rows(value):
    return np.array([[float(Fraction(x)) for x in row] for row in value])


def second_moment_radius(inputs, alpha):
    """Spectral radius of E M (x) M, M = I - alpha Delta (Delta - nu)'H, over all signs Delta."""
    hessian = np.diag(_rows(inputs["h"])[:, 0]) + _rows(inputs["H"])
    size, eta = len(hessian), _rows(inputs["eta"])
    two, beta = float(Fraction(inputs["reading"])) - 1, float(Fraction(inputs["beta"]))
    noise = two * (2 * _rows(inputs["Xi"]) + eta @ eta.T) / (4 * beta**2)
    total = np.zeros((size**2, size**2))
    for number in range(2**size):
        delta = np.array([[1.0 - 2 * (number >> i & 1)] for i in range(size)])
        step = np.eye(size) - alpha * delta @ delta.T @ hessian
        kick = np.kron(delta, delta) @ noise.reshape(1, -1) @ np.kron(hessian, hessian)
        total += (np.kron(step, step) + alpha**2 * kick) / 2**size
    return max(abs(np.linalg.eigvals(total)))


def stable_step(entry):
    value = second_moment_radius(entry["inputs"], float(Fraction(entry["inputs"]["alpha"])))
    return value < 1 + 1e-6 if entry["verdict"] == "PROVED" else value > 1 - 1e-6


def stable_steps(entry):
    lower, upper = (float(Fraction(entry[end])) for end in ("lower", "upper"))
    below = second_moment_radius(entry["inputs"], lower) if lower > 0 else 0.0
    return below < 1 + 1e-6 and second_moment_radius(entry["inputs"], upper) > 1 - 1e-6


def mean_square(entry):
    """Whether the mean square is between the ends, from the D^2 equations of all entries."""
    inputs = entry["inputs"]
    alpha, k, two = (float(Fraction(inputs[name])) for name in ("alpha", "k", "reading"))
    if entry["lower"] == "inf":
        return second_moment_radius(inputs, alpha) > 1 - 1e-6
    if second_moment_radius(inputs, alpha) > 1 - 1e-9:
        return False
    hessian, eta, xi = (_rows(inputs[name]) for name in ("H", "eta", "Xi"))
    hessian, beta = hessian + np.diag(_rows(inputs["h"])[:, 0]), float(Fraction(inputs["beta"]))
    size, move = len(hessian), 2 * k * eta
    noise = (two - 1) * (2 * xi + eta @ eta.T) / (4 * beta**2)

    def kick(q):
        return np.trace(q + q @ noise) * np.eye(size) + 2 * (q - np.diag(np.diag(q)))

    columns = []
    for basis in np.eye(size**2).reshape(-1, size, size):
        pull = hessian @ basis + basis @ hessian
        columns.append((pull - alpha * kick(hessian @ basis @ hessian)).ravel())
    drift = kick(move @ move.T) - move @ move.T
    right = drift / alpha + alpha * kick(hessian @ xi @ hessian) / two
    found = np.linalg.solve(np.array(columns).T, right.ravel()).reshape(size, size)
    mean = move - (two - 1) / 2 * eta - np.linalg.solve(hessian, move) / alpha
    value = np.trace(found) + (mean.T @ mean)[0, 0]
    slack = 1e-9 * (1 + abs(value))
    return float(Fraction(entry["lower"])) <= value + slack and value - slack <= float(
        Fraction(entry["upper"])
    )
