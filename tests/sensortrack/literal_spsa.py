"""Algorithm 1 as printed, sensor by sensor, from the tables of a scenario and raw measurements.

Nothing of the package is used: who hears whom, sources, blocks as matrices A, weights, signs and
positions are found here once more, with whole vectors of all targets, zeros outside of the block.
"""

import math

import numpy as np


def literal_run(data, names, paths, angles, distances, seed, variant):
    """Estimates by samples, sensors, targets and axes; NaN where a sensor follows no target.

    Parameters
    ----------
    data : dict
        A scenario's tables.
    names : list of str
        Of the targets.
    paths : array (samples, targets, 2)
    angles, distances : array (samples, sensors, targets)
        NaN where nothing is measured.
    seed : int
    variant : dict
        alpha, beta_m, n_max, m_max, reading.
    """
    places = [sensor["position_m"][:2] for sensor in data["sensor"]]
    samples, m = len(paths), len(names)
    found = np.full((samples, len(places), m, 2), np.nan)
    sigma = math.radians(data["noise"].get("bearing_deg", 0.0))
    relative = data["noise"].get("range_relative", 0.0)
    reach = data["estimator"].get("reach_m", 0.0) or math.inf
    square = math.exp(sigma**2) * (1 + relative**2) - 1 or 1.0
    largest = [[max(math.dist(p, q) for p in paths[:, i]) for i in range(m)] for q in places]
    for j in range(len(places)):
        order = sorted(range(len(places)), key=lambda q: (math.dist(places[q], places[j]), q != j))
        heard = order[: variant["n_max"] + 1]
        source, h = {}, {}
        for i in range(m):
            best = min(heard, key=lambda q: largest[q][i])
            if largest[best][i] <= reach:
                seeing = [largest[q][i] for q in range(len(places)) if largest[q][i] <= reach]
                variances = [square * far**2 for far in seeing]
                mean = len(variances) / sum(1 / v for v in variances)
                source[i] = best
                h[i] = mean / (len(variances) * square * largest[best][i] ** 2)
        turns = list(source)
        first = j % len(turns)
        turns = turns[first:] + turns[:first]
        blocks = [turns[a : a + variant["m_max"]] for a in range(0, len(turns), variant["m_max"])]
        theta = np.full(2 * m, np.nan)
        for i in turns:
            z = angles[0, source[i], i], distances[0, source[i], i]
            theta[2 * i : 2 * i + 2] = position_of(places[source[i]], z, sigma)
        found[0, j] = theta.reshape(m, 2)
        t, cycle = 0, 0
        while t + 1 < samples:
            cycle += 1
            delta = np.zeros(2 * m)
            for position, i in enumerate(turns):
                delta[2 * i : 2 * i + 2] = signs(seed, cycle, j, len(turns))[2 * position :][:2]
            for block in blocks:
                t += 2
                known = [
                    i
                    for i in block
                    if t < samples
                    and np.isfinite(angles[t, source[i], i])
                    and (variant["reading"] == "one" or np.isfinite(angles[t - 1, source[i], i]))
                ]
                a = np.diag(np.repeat([float(i in known) for i in range(m)], 2))
                found[t - 1 : t + 1, j] = theta.reshape(m, 2)
                if t >= samples:
                    break
                early = t if variant["reading"] == "one" else t - 1
                estimate, beta = np.nan_to_num(theta), variant["beta_m"]
                costs = []
                for when, sign in ((early, -1.0), (t, 1.0)):
                    x = a @ (estimate + sign * beta * delta)
                    y = 0.0
                    for i in known:
                        s = places[source[i]]
                        z = angles[when, source[i], i], distances[when, source[i], i]
                        r = position_of(s, z, sigma)
                        y += h[i] / 2 * ((x[2 * i] - r[0]) ** 2 + (x[2 * i + 1] - r[1]) ** 2)
                    costs.append(y)
                theta = theta - variant["alpha"] * (a @ delta) * (costs[1] - costs[0]) / (2 * beta)
                found[t, j] = theta.reshape(m, 2)
    return found


def position_of(sensor, z, sigma):
    """(13), its polar part times the factor that takes the bias away."""
    polar = math.exp(sigma**2 / 2) * z[1]
    return sensor[0] + polar * math.sin(z[0]), sensor[1] + polar * math.cos(z[0])


def signs(seed, cycle, sensor, targets):
    """Delta of a cycle: bits of the words of NumPy's Philox, which counts up before it draws."""
    counter = (cycle << 64) + (sensor << 128) - 1
    words = np.random.Philox(counter=counter, key=seed).random_raw(1 + 2 * targets // 64)
    return [1.0 if int(words[b // 64]) >> b % 64 & 1 else -1.0 for b in range(2 * targets)]
