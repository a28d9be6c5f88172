"""``sensortrack simulate``: one run, its tracks and errors, beside the bounds that are proved."""

from __future__ import annotations

import argparse
import json
import os
import shlex
import sys
from importlib import import_module
from importlib.metadata import version
from pathlib import Path
from typing import Any

from sensortrack.errors import InputError
from verification.files import write_text

RUN = "run.json"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the command's arguments."""
    parser.add_argument("scenario", metavar="SCENARIO.toml", help="a file, or a shipped scenario")
    parser.add_argument(
        "--out", metavar="DIR", help="where to write; build/simulate/NAME by default"
    )
    parser.add_argument("--seed", type=int, metavar="N", help="instead of the scenario's own")
    parser.add_argument("--json", action="store_true", help="print the summary as JSON only")
    parser.epilog = "shipped scenarios: 'sensortrack simulate ?' names them"


def run(options: argparse.Namespace) -> int:
    """Run, write the folder, print the summary; 0.

    Raises
    ------
    InputError
        The seed is negative, or the scenario or the folder cannot be used.
    """
    from sensortrack.simulation import read_scenario, simulate
    from verification.report import build

    if options.seed is not None and options.seed < 0:
        raise InputError("--seed", f"{options.seed}", "a number of 0 or more is needed")
    scenario = read_scenario(options.scenario)
    folder = Path(options.out or f"build/simulate/{scenario.name}")
    prepare(folder)
    found = simulate(scenario, options.seed)
    data = found.to_data() | {"command": _command(options), "version": version("sensortrack")}
    beside = import_module(f"verification.systems.{data['system']}.envelopes")
    data["bounds"] = beside.envelopes(data)
    if hasattr(beside, "expectations"):
        data["expected"] = beside.expectations(data)
    write_text(folder / RUN, json.dumps(data) + "\n")
    write_text(folder / "tracks.csv", found.tracks_csv())
    write_text(folder / "errors.csv", found.errors_csv())
    _figures(data, folder)
    page, _ = build(folder)
    if options.json:
        print(json.dumps(_short(data)))
    else:
        print("\n".join(lines_of(data)))
        print(f"\nreport  {page}")
    return 0


def prepare(folder: Path) -> None:
    """Make the folder ready; one that holds anything but an earlier run is refused.

    Raises
    ------
    InputError
        With the name ``--out``.
    """
    try:
        if folder.exists() and not folder.is_dir():
            raise InputError("--out", f"{folder} is a file", "the name of a folder is needed")
        if folder.is_dir() and any(folder.iterdir()) and not (folder / RUN).is_file():
            found = f"{folder} holds files that no run wrote"
            raise InputError("--out", found, "a new or empty folder is needed")
        (folder / "figures").mkdir(parents=True, exist_ok=True)
    except OSError as error:
        found = f"{folder}: {error.strerror or error}"
        raise InputError("--out", found, "a folder that can be written to is needed") from None
    if not os.access(folder, os.W_OK):
        raise InputError("--out", f"{folder} cannot be written to", "another is needed")


def _short(data: dict[str, Any]) -> dict[str, Any]:
    """The summary as JSON data: numbers, no curves."""
    found = {key: data[key] for key in ("name", "seed", "summary", "events", "notes")}
    if "expected" in data:
        keys = ("of", "rms", "frozen", "settled", "alpha", "limit")
        found["expected"] = [{key: entry[key] for key in keys} for entry in data["expected"]]
    return found


def _figures(data: dict[str, Any], folder: Path) -> None:
    """Figures as files; without matplotlib the page has them all the same."""
    try:
        from sensortrack.plots import save_run
    except ModuleNotFoundError:
        print("sensortrack: no figure files: matplotlib is not installed", file=sys.stderr)
        return
    save_run(data, folder / "figures")


def lines_of(data: dict[str, Any]) -> list[str]:
    """The summary in plain text."""
    from verification.report import several_tables

    lines = [f"{data['title']}, seed {data['seed']}", ""]
    lines += several_tables.text_lines(data) if "targets" in data else _errors(data)
    lines += [""] if data["bounds"] else []
    names = max([16, *(len(bound["name"]) for bound in data["bounds"])])
    for bound in data["bounds"]:
        held = "held" if bound["holds"] else "CROSSED"
        reached = f"reached {100 * bound['reached']:.3g} %"
        lines.append(f"  bound, {bound['name']:<{names}}  {held}, {reached}")
        lines += [f"         {bound['remark']}"] if "remark" in bound else []
    lines += [""] if data["events"] or data["notes"] else []
    lines += [f"  {event['time']:g} s: {event['text']}" for event in data["events"]]
    lines += [f"  note: {note}" for note in data["notes"]]
    return lines


def _errors(data: dict[str, Any]) -> list[str]:
    """One line an estimate."""
    labels = {entry["name"]: entry["label"] for entry in data["estimates"]}
    since = f"rms from {data['summary'][0]['from']:g} s"
    width = max(22, *(len(labels[row["estimate"]]) for row in data["summary"]))
    lines = [f"{since:<{width + 2}}  position, m  velocity, m/s"]
    for row in data["summary"]:
        numbers = f"{_number(row['position_rms']):>11}  {_number(row['velocity_rms']):>13}"
        lines.append(f"  {labels[row['estimate']]:<{width}}  {numbers}")
    return lines


def _number(value: float | None) -> str:
    return "–" if value is None else f"{value:.5g}"


def _command(options: argparse.Namespace) -> str:
    parts = ["sensortrack", "simulate", options.scenario]
    parts += ["--seed", str(options.seed)] if options.seed is not None else []
    return shlex.join(parts)
