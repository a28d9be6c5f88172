"""``sensortrack quantities``: what `bound`, `certify` and `design` can be asked."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from typing import Any

from verification.answers import Condition, Design, Input, Quantity
from verification.systems import SYSTEMS

from . import listing

add_arguments = listing.add_system


def run(options: argparse.Namespace) -> int:
    """List command, name, whether a certificate can be written, inputs and summary."""
    entries = [
        entry
        for system in listing.chosen(options.system)
        if system.name in SYSTEMS
        for entry in _entries(system.name)
    ]
    columns = ["{command}", "{name}", "{writes}", "{takes}", "{summary}"]
    listing.show(entries, columns, options.json)
    return 0


def _entries(system: str) -> Iterator[dict[str, Any]]:
    module = SYSTEMS[system].quantities
    questions: tuple[Quantity | Condition, ...] = (*module.QUANTITIES, *module.CONDITIONS)
    for question in questions:
        certified = isinstance(question, Condition) or question.certified
        command = "bound" if isinstance(question, Quantity) else "certify"
        yield _entry(command, f"{system}.{question.name}", certified, question)
    designs = SYSTEMS[system].design
    for design in designs.DESIGNS if designs else ():
        yield _entry("design", system, True, design)


def _entry(
    command: str, name: str, certified: bool, question: Quantity | Condition | Design
) -> dict[str, Any]:
    return {
        "command": command,
        "name": name,
        "writes": "certificate" if certified else None,
        "takes": ", ".join(map(_name, question.inputs)),
        "inputs": [_described(entry) for entry in question.inputs],
        "summary": question.summary,
    }


def _name(entry: Input) -> str:
    if entry.optional:
        return f"({entry.name})"
    return entry.name if entry.default is None else f"{entry.name} [{entry.default}]"


def _described(entry: Input) -> dict[str, Any]:
    return {
        "name": entry.name,
        "kind": entry.kind,
        "meaning": entry.meaning,
        "unit": entry.unit,
        "default": entry.default,
        "optional": entry.optional,
    }
