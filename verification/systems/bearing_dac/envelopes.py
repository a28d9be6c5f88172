"""Bounds on a run of bearing consensus: how far sensors are apart, and what that does to positions.

Entry by entry, one implicit step takes the disagreement x to x+ with

    x+ = x + M dr - h beta g,   g in the subdifferential of TV at x+,

dr being what the signals have moved, |dr_i| <= h gamma. With r = min over cuts of (beta k - 2 gamma
p)/sqrt(p), k links and p = s (n - s)/n for s nodes inside, |x+| <= max(0, |x| - h r) where r >= 0;
whatever r is, |x+| <= |x + M dr| <= |x| + |M dr|. Both hold step by step, with the gamma, the links
and the sensors of that step.

A sensor whose averages of P and q are off by dP and dq computes a position no farther from the
least-squares one, p*, than (|dq| + |dP| |p*|)/(lambda - |dP|), lambda being the smallest eigenvalue
of the average of P.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sensortrack.consensus import chatter_bound
from sensortrack.kernels.links import links_of
from sensortrack.networks import Network

from .cut_profiles import Profile, profile_of

Floats = NDArray[np.float64]
ROUNDING = 1e-9
"""Relative room for rounding in the bounds."""
NOISE_FLOOR = 1e-12
"""Room for rounding in the run, relative to the largest signal."""


def envelopes(run: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Proved bounds on a run, beside what the run reached.

    Parameters
    ----------
    run : mapping
        Content of ``run.json``.

    Returns
    -------
    list of dict
        Entries of ``bounds``: the disagreement on P, on q in m, and the position error in m; the
        disagreement of explicit steps, if they ran beside.
        Empty where the signs are not taken entry by entry in implicit steps.
    """
    parameters, record = run["parameters"], run["consensus"]
    if (parameters["method"], parameters["sign"]) != ("implicit", "componentwise"):
        return []
    apart = np.array(record["disagreement"], dtype=float)
    floor = NOISE_FLOOR * _size(record)
    ideal = _disagreement(run)
    bound = ideal + floor
    made = []
    for block, unit, columns in _blocks(record["entries"]):
        level, high = apart[:, columns].max(axis=1), bound[:, columns].max(axis=1)
        found = _entry(run, f"disagreement on {block}", unit, high, level, STEPS)
        made.append(found | {"remark": _remark(run, ideal, columns)})
    return [*made, *_position(run, bound), *_chatter(run)]


def _remark(run: Mapping[str, Any], bound: Floats, columns: slice) -> str:
    """When agreement is proved, when the paper has it, and what the gain would have to be."""
    record = run["consensus"]
    zero = (bound[:, columns] == 0).all(axis=1)
    when = f"{run['time'][int(np.argmax(zero))]:.4g} s" if zero.any() else "no time of this run"
    said = f"agreement proved at {when}"
    if len(record["graphs"]) > 1 or len(record["present"]) > 1:
        return said
    profile = _profiles(run)[0]
    start = max(record["disagreement"][0][columns])
    gamma = np.array(record["moved"], dtype=float)[:, columns].max() / float(run["parameters"]["h"])
    said = f"{said}, printed for {start / profile.gap:.4g} s"
    if gamma == 0:
        return said
    share = max(record["beta"][columns]) / (profile.threshold * gamma)
    return f"{said}; the gain is {share:.3g} times the least for the largest move"


CHATTERS = (
    "whatever explicit steps start from, they end within max(h sqrt(Q), h Q/(2 r)) and stay there, "
    "Q bounding the square of what one step moves"
)
STEPS = (
    "step by step, from the links, the sensors and the largest move of a signal of that step: the "
    "disagreement falls by h times the least of (beta k - 2 gamma p)/sqrt(p) over the cuts"
)
SOLVED = (
    "error of the solution p* of the averages plus (|dq| + |dP| |p*|)/(lambda - |dP|), the "
    "disagreement being a bound of dP and dq"
)


def _blocks(entries: str) -> tuple[tuple[str, str, slice], ...]:
    first = 2 if entries == "reduced" else 4
    return ("P", "1", slice(0, first)), ("q", "m", slice(first, None))


def _size(record: Mapping[str, Any]) -> Floats:
    """Largest value of each signal's average or move, at least 1 for P."""
    average, moved = (np.array(record[key], dtype=float) for key in ("average", "disagreement"))
    found: Floats = np.maximum(np.abs(average).max(axis=0), moved.max(axis=0))
    return np.asarray(np.maximum(found, 1.0))


def _disagreement(run: Mapping[str, Any]) -> Floats:
    """Bound on the norm of each entry's disagreement, samples by entries."""
    record, h = run["consensus"], float(run["parameters"]["h"])
    beta = np.array(record["beta"], dtype=float)
    moved, spread, apart = (
        np.array(record[key], dtype=float) for key in ("moved", "spread", "disagreement")
    )
    restarts = {*record["restarts"]}
    profiles = _profiles(run)
    now = apart[0]
    found = [now]
    for k in range(1, len(apart)):
        if k in restarts:
            now = apart[k]
        else:
            rate = profiles[k].rate(beta, moved[k] / h)
            falling = np.maximum(now - h * rate, 0.0)
            now = np.where(rate >= 0, falling, now + spread[k]) * (1 + ROUNDING)
        found.append(now)
    return np.array(found)


def _profiles(run: Mapping[str, Any]) -> list[Profile]:
    """Profile of the links of each sample's period, each set of links once."""
    record, links = run["consensus"], np.array(run["links"], dtype=int).reshape(-1, 2)
    changes = dict(record["present"])
    known: dict[tuple[int, int], Profile] = {}
    present, since, found = [], 0, []
    for k, graph in enumerate(record["graph"]):
        if k in changes:
            present, since = changes[k], k
        if (graph, since) not in known:
            known[graph, since] = profile_of(present, links[record["graphs"][graph]])
        found.append(known[graph, since])
    return found


def _chatter(run: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Bounds on the explicit steps beside, where the links and sensors stay."""
    record, h = run["consensus"], float(run["parameters"]["h"])
    levels = [entry for entry in run["levels"] if entry["of"] == "explicit"]
    if not levels or len(record["graphs"]) > 1 or len(record["present"]) > 1:
        return []
    profile = _profiles(run)[0]
    beta, moved = (np.array(record[key], dtype=float) for key in ("beta", "moved"))
    gamma = moved.max(axis=0) / h
    rates = profile.rate(beta, gamma)
    edges = np.array(run["links"], dtype=int).reshape(-1, 2)
    links = links_of(Network([str(i) for i in range(profile.n)], edges))
    ends = [
        chatter_bound(links, np.array([b]), h, float(g), max(float(r), 0.0))[0]
        for b, g, r in zip(beta, gamma, rates, strict=True)
    ]
    made = []
    for entry, (block, unit, columns) in zip(levels, _blocks(record["entries"]), strict=True):
        level = np.array(entry["value"], dtype=float)
        bound = np.full(len(level), max(float(level[0]), *ends[columns])) * (1 + ROUNDING)
        if np.isfinite(bound).all():
            found = _entry(run, f"disagreement on {block}", unit, bound, level, CHATTERS)
            name = f"chattering of explicit steps, {block}"
            made.append(found | {"of": "explicit", "name": name})
    return made


def _position(run: Mapping[str, Any], bound: Floats) -> list[dict[str, Any]]:
    """Bound on the position error of the sensor that is shown; none where the mean is biased."""
    record = run["consensus"]
    if record["biased"]:
        return []
    truth = np.array(run["target"]["position"], dtype=float)
    own = next(e for e in run["estimates"] if e["name"] == run["system"])
    error = np.linalg.norm(np.array(own["position"], dtype=float) - truth, axis=1)
    star, smallest = _solved(record)
    off = np.linalg.norm(star + np.array(record["origin"]) - truth[:, :2], axis=1)
    d_p, d_q = _spectral(bound, record["entries"])
    far, room = np.linalg.norm(star, axis=1), smallest - d_p
    reach = np.full(len(off), np.nan)
    np.divide(d_q + d_p * far, room, out=reach, where=room > 0)
    high = (off + reach) * (1 + ROUNDING) + NOISE_FLOOR * far
    if not (np.isfinite(high) & np.isfinite(error)).any():
        return []
    return [_entry(run, "position error", "m", high, error, SOLVED)]


def _solved(record: Mapping[str, Any]) -> tuple[Floats, Floats]:
    """p* about the origin from the averages, and the smallest eigenvalue of that of P."""
    average = np.array(record["average"], dtype=float)
    first, mixed, q = average[:, 0], average[:, 1], average[:, -2:]
    last = 1 - first if record["entries"] == "reduced" else average[:, 3]
    smallest = (first + last) / 2 - np.hypot((first - last) / 2, mixed)
    det = first * last - mixed**2
    known = np.where(det > 0, det, np.nan)
    x = (last * q[:, 0] - mixed * q[:, 1]) / known
    y = (first * q[:, 1] - mixed * q[:, 0]) / known
    return np.stack([x, y], axis=1), smallest


def _spectral(bound: Floats, entries: str) -> tuple[Floats, Floats]:
    """Norms of the errors of P and of q, from bounds on their entries."""
    if entries == "reduced":  # an error of trace 0: its norm is that of its first row
        return np.hypot(*bound[:, :2].T), np.hypot(*bound[:, 2:].T)
    return np.linalg.norm(bound[:, :4], axis=1), np.hypot(*bound[:, 4:].T)


def _entry(
    run: Mapping[str, Any], quantity: str, unit: str, bound: Floats, size: Floats, words: str
) -> dict[str, Any]:
    """One bound; where either side is not known it says nothing."""
    both = np.isfinite(bound) & np.isfinite(size)
    slack = (bound - size)[both]
    since = max((row["from"] for row in run.get("summary", ())), default=0.0)
    counted = both & (np.array(run["time"]) >= min(float(since), run["time"][-1]))
    share = size[counted] / np.maximum(bound[counted], np.finfo(float).tiny)
    return {
        "name": f"worst case, {quantity.removeprefix('disagreement on ')}",
        "of": run["system"],
        "quantity": quantity,
        "unit": unit,
        "time": list(run["time"]),
        "value": [x if np.isfinite(x) else None for x in bound.tolist()],
        "statement": words,
        "source": "bearing_dac.theorem_1_time",
        "holds": bool((slack >= 0).all()),
        "smallest_slack": float(slack.min()) if slack.size else 0.0,
        "reached": float(share.max()) if share.size else 0.0,
    }
