"""Samples of every case of the statements on a user's own costs and networks, and their truths."""

from fractions import Fraction

import numpy as np

from verification.systems.cyclic_spsa.assumptions.sharp import (
    assumption_constants,
    decide_assumptions,
)
from verification.systems.cyclic_spsa.network.limits import network_step_limit

ONE = Fraction(1)
NAMES = ("mu", "M", "c2", "c3", "c4", "delta")
SLACK = 1e-9


def cost(**changes):
    """Values as the command line makes them."""
    plain = dict.fromkeys(("h", "H", "costs", "low", "high", "c3"))
    return plain | {"Xi": ((ONE,),), "eta": (ONE,), "law": "gaussian"} | changes


def own_samples():
    """Certificates by name."""
    plain, good = cost(h=(ONE,)), dict.fromkeys(NAMES, ONE) | {"c3": ONE * 6, "c4": ONE * 6}
    proved = assumption_constants(cost(h=(ONE, ONE * 2), law="two_point"))
    between = assumption_constants(cost(low=ONE, high=ONE * 2, eta=(ONE * 0,)))
    made = {"proved": proved, "of all": between}
    unlike = cost(costs=(((ONE,),), ((ONE * 2,),))) | good | {"M": ONE * 2, "c2": ONE * 4}
    made["unlike"] = decide_assumptions(unlike)
    wrong = {"mu": 2, "M": "1/2", "c2": "1/2", "c3": 2, "c4": 2, "delta": "1/2"}
    made |= {
        name: decide_assumptions(plain | good | {name: Fraction(value)})
        for name, value in wrong.items()
    }
    network = {
        "sensors": ((Fraction(0),) * 2, (ONE, Fraction(0))),
        "targets": ((ONE, ONE),),
        "sigma_bearing_rad": Fraction(1, 5),
        "sigma_range_rel": Fraction(1, 10),
        "n_max": Fraction(0),
        "m_max": ONE,
        "beta": ONE,
        "reading": "two",
        "K": "harmonic",
        "assignment": "best",
    } | dict.fromkeys(("velocities", "reach", "talk", "eta_m"))
    made["network"] = network_step_limit(network)
    return {
        f"cyclic_spsa.{entry.certificate['name']} {name}": entry.certificate
        for name, entry in made.items()
    }


def _rows(value):
    return np.array([[float(Fraction(x)) for x in row] for row in value])


def assumptions(entry):
    """Whether the constants hold, from eigenvalues: the change is -y'Hp + q, in y and 1."""
    inputs = entry["inputs"]
    h, xi, eta = (_rows(inputs[name]) for name in ("H", "Xi", "eta"))
    kappa, *constants = (float(Fraction(inputs[name])) for name in ("kappa", *NAMES))
    mu, top, c2, c3, c4, delta = constants
    if np.linalg.eigvalsh(xi)[0] < -SLACK:
        return True  # no noise has this covariance
    pull = (eta.T @ h @ eta).item()
    spread = 2 * np.trace(h @ xi @ h @ xi) + kappa * (np.diag(h @ xi) ** 2).sum()
    form = h @ (2 * xi + eta @ eta.T) @ h
    slope = h @ (xi @ h @ eta + eta * pull / 2)
    level = (pull**2 + 4 * (eta.T @ h @ xi @ h @ eta).item() + 2 * spread) / 4
    whole = np.block([[c3 * np.eye(len(h)) - form, slope], [slope.T, np.array([[c4 - level]])]])
    values = np.linalg.eigvalsh(h)
    spare = (
        values[0] - mu,
        top - values[-1],
        c2 - np.trace(h @ xi @ h),
        np.linalg.eigvalsh(whole)[0],
        delta - np.linalg.norm(eta),
    )
    return min(spare) > -SLACK if entry["verdict"] == "PROVED" else min(spare) < SLACK


def unlike_costs(entry):
    """Two unlike Hessians have no c3 and c4, however large."""
    return (
        entry["inputs"]["H"] != entry["inputs"]["G"]
        or min(float(Fraction(entry["inputs"][name])) for name in ("c3", "c4")) < 6
    )


def network(entry):
    """Whether the heaviest block has the limit that is stated."""
    inputs = entry["inputs"]
    inside, h, s, e = (_rows(inputs[name]) for name in ("G", "h", "s", "e"))
    beta, two = float(Fraction(inputs["beta"])), float(Fraction(inputs["reading"])) - 1
    loads = inside @ (h * (2 + two * (s / (2 * beta**2) + e / (4 * beta**2))))
    return bool(np.isclose(2 / loads.max(), float(Fraction(entry["upper"])), rtol=SLACK))
