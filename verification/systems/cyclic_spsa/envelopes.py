"""What stands beside a run of cyclic SPSA: no proved bound on one run, but what it was to do."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from .running.expected import expected, setting_of
from .running.frozen import frozen_error


def envelopes(run: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Proved bounds on a run: none, since Gaussian errors have none; see `expectations`."""
    _ = run
    return []


def expectations(run: Mapping[str, Any]) -> list[dict[str, Any]]:
    """What was to be expected of each setting of a run.

    Parameters
    ----------
    run : mapping
        Content of ``run.json``.

    Returns
    -------
    list of dict
        As `expected.expected` returns them, and ``frozen``: the root-mean-square error in m at
        which the closed forms settle if the geometry in the middle of the summarised time lasted,
        None where they grow. Empty for a run in which a sensor fails: measurements that are
        missing are in no moment.
    """
    if any(event["kind"].startswith("sensor_") for event in run["events"]):
        return []
    since, end = float(run["summary"][0]["from"]), float(run["time"][-1])
    middle = max(1, round((since + end) / 2 / float(run["parameters"]["h"])))
    made = []
    for entry in run["spsa"]["variants"]:
        setting = setting_of(run, entry)
        sample = min(middle, len(setting.paths) - 1)
        found = expected(run, entry, setting)
        made.append(found | {"frozen": frozen_error(setting, "gaussian", sample)})
    return made
