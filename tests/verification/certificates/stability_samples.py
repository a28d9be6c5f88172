"""Samples of every case of the statements on mean-square stability, and what they say of data."""

from fractions import Fraction

import numpy as np

from verification.systems.cyclic_spsa.stability import decide_step, step_limit

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
    return made | {f"cyclic_spsa.step {k}": decide_step(v).certificate for k, v in steps.items()}


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
