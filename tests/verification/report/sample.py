"""Invented records: what a run could have left."""

import json

VERDICTS = ("PROVED", "CORRECTED", "REFUTED", "SUPPORTED", "UNDECIDED")

FIGURE = {
    "title": "Gain against disturbance",
    "finding": "The printed line falls below the sharp one",
    "caption": "Below the sharp line agreement fails",
    "x": {"label": "disturbance", "unit": "", "low": 0.0, "high": 6.0, "ticks": [3.414]},
    "y": {"label": "gain", "unit": "c/s", "low": 0.1, "high": 10.0, "log": True},
    "curves": [
        {"role": "sharp", "x": [0.5, 6.0], "y": [0.5, 6.0], "label": "sharp"},
        {"role": "printed", "x": [0.0, 6.0], "y": [1.0, 5.2], "label": "printed"},
    ],
    "areas": [{"role": "false", "x": [3.4, 6.0], "low": [3.4, 5.2], "high": [3.4, 6.0]}],
    "dots": [{"role": "refuting", "x": [4.0], "y": [3.9], "label": "fails here"}],
}


def claim(k, **changes):
    return {
        "id": f"toy.claim_{k}",
        "system": "toy",
        "source": f"Author, Theorem {k}",
        "title": f"The error of toy {k} never grows",
        "statement": "Along every solution the error does not grow",
        "formula": r"\beta\ge1+\gamma\frac{\sqrt n}{\lambda_2}",
        "printed": "3.8284",
        "sharp": "4",
        "printed_value": 3.8284,
        "sharp_value": 4.0,
        "sense": "threshold",
        "verdict": VERDICTS[k % 5],
        "margin": -0.0429,
        "margin_text": "4.3 % too small",
        "reason": "One run is replayed in rationals",
        "repair": "The gain must reach 4" if k % 5 == 1 else "",
        "repair_formula": r"\beta\ge\frac{2\gamma}{\lambda_2}" if k % 5 == 1 else "",
        "assumptions": ["A1: the graph is connected"],
        "relies_on": ["Courant-Fischer"],
        "certificates": [f"certificates/toy.claim_{k}.json"],
        "replay": [["t", "x"], ["0", "1/2"], ["1", "1/3"]],
        "figure": FIGURE if k == 1 else None,
        "seconds": 0.25,
        "digest": "0" * 64,
    } | changes


NETWORK = {
    "graph": "sndlib_toy",
    "nodes": 4,
    "edges": 3,
    "lambda_2": 0.5857864,
    "threshold": "2",
    "threshold_value": 2.0,
    "printed_value": 4.414,
    "ratio": 2.207,
    "cut": ["Berlin", "Bonn"],
    "cut_edges": 1,
    "cut_links": [["Bonn", "Ulm"]],
    "certificate": "certificates/bearing_dac.gain_threshold.sndlib_toy.json",
    "bytes": 500,
    "seconds": 0.01,
    "names": ["Berlin", "Bonn", "Ulm", "Kiel"],
    "edge_list": [[0, 1], [1, 2], [2, 3]],
}

FACTS = {
    "version": "0.1.0",
    "date": "2026-01-02",
    "python": "3.11.7",
    "command": "sensortrack verify",
    "systems": {
        "toy": {
            "title": "A toy",
            "citation": "Author: On toys",
            "digest": "ab" * 32,
            "laws": [["(1)", r"\dot{x} = -x"]],
            "gaps": [["Author, Figure 2", "the error is small", "how small"]],
        }
    },
    "checked": 5,
    "seconds": 1.25,
    "skipped": [],
}


def write(folder, claims, networks=(NETWORK,), facts=FACTS):
    records = {"claims": claims, "networks": list(networks), "facts": facts}
    for name, content in records.items():
        (folder / f"{name}.json").write_text(json.dumps(content))
    (folder / "certificates").mkdir(exist_ok=True)
    for entry in claims:
        for path in entry["certificates"]:
            (folder / path).write_text("x" * 1234)
    return folder
