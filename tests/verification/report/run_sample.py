"""An invented run: what a simulation could have left."""

import json
import math


def run(steps=120, **changes):
    time = [k * 0.1 for k in range(steps)]
    truth = [[10 * math.cos(0.5 * t), 10 * math.sin(0.5 * t), 0.3 * t] for t in time]
    rate = [[-5 * math.sin(0.5 * t), 5 * math.cos(0.5 * t), 0.3] for t in time]
    level = [2 * math.exp(-0.7 * t) + 0.02 for t in time]

    def moved(points, size):
        return [[p[0] + s, p[1], p[2]] for p, s in zip(points, size, strict=True)]

    bound = {
        "name": "energy bound",
        "of": "variational",
        "quantity": "position error",
        "unit": "m",
        "time": time,
        "value": [1.2 * s for s in level],
        "statement": "the corrected energy never grows",
        "source": "variational.discrete_energy",
        "holds": True,
        "smallest_slack": 0.004,
        "reached": 0.8333,
    }
    return {
        "format": "sensortrack-run/1",
        "name": "toy",
        "title": "A helix seen by two sensors",
        "about": "The target climbs a helix; one sensor is lost.",
        "system": "variational",
        "digest": "cd" * 32,
        "seed": 3,
        "command": "sensortrack simulate toy.toml",
        "version": "0.1.0",
        "assumptions": ["the gains are not printed; M = K = 1, C = 2"],
        "parameters": {"M": "1", "h": 0.1},
        "time": time,
        "target": {"position": truth, "velocity": rate},
        "sensors": [
            {"name": "s1", "position": [[0, 0, 0]] * steps, "sees": [[0, 12]]},
            {"name": "s2", "position": [[5, 9, 0]] * steps, "sees": [[0, 7.5]]},
        ],
        "estimates": [
            {
                "name": "variational",
                "label": "variational estimator",
                "position": moved(truth, level),
                "velocity": moved(rate, level),
            },
            {
                "name": "raw",
                "label": "raw average",
                "position": moved(truth, [0.3] * steps),
                "velocity": moved(rate, [0.4] * steps),
            },
        ],
        "bounds": [bound],
        "events": [{"time": 7.5, "kind": "sensor_lost", "text": "s2 no longer sees the target"}],
        "summary": [
            {"estimate": "variational", "position_rms": 0.0213, "velocity_rms": 0.02, "from": 6.0},
            {"estimate": "raw", "position_rms": 0.3, "velocity_rms": 0.4, "from": 6.0},
        ],
        "notes": [],
    } | changes


def write_run(folder, data):
    folder.mkdir(exist_ok=True)
    (folder / "run.json").write_text(json.dumps(data))
    return folder
