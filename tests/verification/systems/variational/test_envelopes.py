"""The bounds drawn beside a run are on the right side of every run."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from verification.systems.variational.envelopes import envelopes

RNG = np.random.default_rng


def gain(rng, n):
    half = rng.normal(size=(n, n))
    return half @ half.T + np.eye(n)


def simulated(seed, n=2, steps=80, h=0.1, scheme="printed", noise=(0.1, 0.2), gains=None):
    """(24) from its printed lines, beside a target that turns."""
    rng = RNG(seed)
    m, k, c = gains or (gain(rng, n), gain(rng, n), gain(rng, n))
    time = h * np.arange(steps)
    phases = rng.uniform(0, 6, n)
    b = np.stack([3 * np.sin(0.7 * time + p) for p in phases], axis=1)
    v = np.stack([2.1 * np.cos(0.7 * time + p) for p in phases], axis=1)
    chi, nu = (s * rng.uniform(-1, 1, (steps, n)) for s in noise)
    seen_b, seen_v = b - chi, v - nu
    bh, w = b[0] + rng.normal(size=n), rng.normal(size=n)
    places, rates = [bh], [seen_v[0] + w]
    damped, kept = (m + h * c, m) if scheme == "printed" else (m + h * c / 2, m - h * c / 2)
    for j in range(1, steps):
        bh = bh + h * rates[-1]
        w = np.linalg.solve(damped, kept @ w - h * k @ (bh - seen_b[j]))
        places.append(bh)
        rates.append(seen_v[j] + w)
    names = {"variational": (places, rates), "raw": (seen_b, seen_v)}
    return {
        "parameters": {"M": m.tolist(), "K": k.tolist(), "C": c.tolist(), "h": h, "scheme": scheme},
        "time": time.tolist(),
        "target": {"position": b.tolist(), "velocity": v.tolist()},
        "estimates": [
            {"name": name, "position": np.array(p).tolist(), "velocity": np.array(q).tolist()}
            for name, (p, q) in names.items()
        ],
    }


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 10**6), st.integers(1, 3), st.sampled_from(["printed", "leapfrog"]))
def test_no_run_crosses_its_bounds(seed, n, scheme):
    position, velocity = envelopes(simulated(seed, n, scheme=scheme))
    for bound in (position, velocity):
        assert bound["holds"]
        assert bound["smallest_slack"] >= 0
        assert 0 < bound["reached"] <= 1


def test_without_noise_and_motion_the_bound_is_the_free_motion_itself():
    run = simulated(3, noise=(0, 0), steps=60)
    still = np.zeros((60, 2))
    truth = np.array(run["target"]["position"])
    rates = np.array(run["target"]["velocity"])
    h = run["parameters"]["h"]
    run["target"] = {"position": still.tolist(), "velocity": still.tolist()}
    for entry in run["estimates"]:
        entry["velocity"] = (np.array(entry["velocity"]) - rates).tolist()
        entry["position"] = (np.array(entry["position"]) - truth).tolist()
    first = np.array(run["estimates"][0]["position"])[0]
    w = np.array(run["estimates"][0]["velocity"])[0]
    m, k, c = (np.array(run["parameters"][g]) for g in "MKC")
    e, places, speeds = first, [first], [w]
    for _ in range(59):
        e = e + h * w
        w = np.linalg.solve(m + h * c, m @ w - h * k @ e)
        places.append(e)
        speeds.append(w)
    run["estimates"][0] |= {
        "position": np.array(places).tolist(),
        "velocity": np.array(speeds).tolist(),
    }
    for bound in envelopes(run):
        assert bound["holds"]
        assert bound["reached"] == pytest.approx(1, abs=2e-9)


def test_a_run_with_other_gains_than_it_says_crosses_its_bound():
    run = simulated(5, n=1, noise=(0, 0), gains=(np.eye(1), np.eye(1), 0.1 * np.eye(1)))
    run["parameters"]["C"] = [[5.0]]
    run["parameters"]["K"] = [[9.0]]
    assert not all(bound["holds"] for bound in envelopes(run))


def test_bounds_end_where_nobody_sees_the_target():
    run = simulated(7)
    for kind in ("position", "velocity"):
        run["estimates"][1][kind][30] = [None, None]
    assert {len(bound["time"]) for bound in envelopes(run)} == {30}


def test_late_data_and_missing_measurements_have_no_bound():
    run = simulated(7)
    late = run | {"parameters": run["parameters"] | {"delay": 2}}
    assert envelopes(late) == []
    assert envelopes(run | {"estimates": run["estimates"][:1]}) == []
    run["estimates"][1]["position"][1] = [None, None]
    assert envelopes(run) == []
