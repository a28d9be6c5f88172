"""``sensortrack design``: gains and steps that carry a certificate."""

from __future__ import annotations

import argparse
import json
import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

from sensortrack.errors import InputError
from verification.answers import Design, Designed
from verification.exact.rationals import nearest as nearest_double
from verification.files import certificate_text, require_folder, write_text
from verification.input_words import brief, nearest
from verification.inputs import read_inputs
from verification.plain_text import harmless
from verification.systems import SYSTEMS

from . import given
from .answering import NO_ANSWER

STATUS = {"PROVED": 0, "REFUTED": 1}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the command's arguments."""
    parser.add_argument("system", metavar="SYSTEM")
    parser.add_argument("--out", metavar="DIR", help="a new or empty folder for what was chosen")
    parser.add_argument(
        "--json", action="store_true", help="print one JSON document and nothing else"
    )
    parser.epilog = "without inputs, 'sensortrack design SYSTEM' says what can be chosen from what"
    given.add_arguments(parser)


def run(options: argparse.Namespace) -> int:
    """Choose; 0 with a certificate, 3 without."""
    designs = _designs(options.system)
    folder = Path(options.out) if options.out is not None else None
    if folder is not None:
        require_folder(folder)
    values = given.given_values(options)
    design = _matching(designs, {*values} | ({"graph"} if options.graph else set()))
    question = f"design {options.system}, {design.name},"
    network = given.given_network(options, design.inputs, question)
    found = design.answer(read_inputs(design.inputs, values, network, question).values)
    path = _written(folder, found) if folder is not None else None
    document = {
        "system": options.system,
        "design": design.name,
        "gains": {name: _plain(value) for name, value in found.gains.items()} or None,
        "objective": found.objective,
        "bound": dict(found.bound) or None,
        "verdict": str(found.verdict),
        "certificate": path,
        "notes": list(found.notes),
    }
    if found.edges:
        document["edges"] = [list(edge) for edge in found.edges]
    print(json.dumps(document) if options.json else "\n".join(_lines(document)))
    return STATUS.get(found.verdict, NO_ANSWER)


def _designs(system: str) -> Sequence[Design]:
    if system not in SYSTEMS:
        hint = nearest(system, list(SYSTEMS)) or f"one of {', '.join(SYSTEMS)} is needed"
        raise InputError(brief(system), "no such system", hint)
    module = SYSTEMS[system].design
    if module is None:
        able = [name for name, room in SYSTEMS.items() if room.design is not None]
        raise InputError(system, "nothing to choose", f"one of {', '.join(able)} is needed")
    designs: Sequence[Design] = module.DESIGNS
    return designs


def _matching(designs: Sequence[Design], names: set[str]) -> Design:
    """The one design that takes these inputs and lacks none."""
    for design in designs:
        required = {
            entry.name for entry in design.inputs if entry.default is None and not entry.optional
        }
        if required <= names <= {entry.name for entry in design.inputs}:
            return design
    known = {entry.name for design in designs for entry in design.inputs}
    cure = "\n".join(
        f"from {', '.join(entry.name for entry in design.inputs)}: {design.summary}"
        for design in designs
    )
    for name in sorted(names - known):
        hint = nearest(name, sorted(known)) or "an input of the list below is needed"
        raise InputError(brief(name), "no such input", hint, cure)
    what = ", ".join(sorted(names)) or "nothing"
    raise InputError("input", f"{what} given", "all inputs of one of the choices below", cure)


def _plain(value: Any) -> Any:
    """A rational as a JSON number where that is the same decimal, else as text; rows likewise."""
    if isinstance(value, str):
        return value
    if isinstance(value, tuple):
        return [_plain(entry) for entry in value]
    if value == int(value):
        return int(value)
    number = nearest_double(value)
    return number if math.isfinite(number) and Fraction(repr(number)) == value else str(value)


def _written(folder: Path, found: Designed) -> str | None:
    """Write gains and certificate; the certificate's path."""
    if found.certificate is None:
        return None
    folder.mkdir(parents=True, exist_ok=True)
    gains = {name: _plain(value) for name, value in found.gains.items()}
    write_text(folder / "gains.json", json.dumps(gains, indent=1) + "\n")
    if found.network is not None:
        from sensortrack.network_writing import graphml_text

        write_text(folder / "graph.graphml", graphml_text(found.network))
    path = folder / "certificate.json"
    write_text(path, certificate_text(found.certificate))
    return str(path)


def _lines(document: Mapping[str, Any]) -> list[str]:
    """The choice for a reader, a line each."""
    lines = [f"{document['system']}: {document['design']}", f"  {document['objective']}", ""]
    edges = [f"{brief(a)} – {brief(b)}" for a, b in document.get("edges", ())]
    lines += [f"  {'edge to add':<12} {edge}" for edge in edges]
    lines += [f"  {name:<12} {json.dumps(x)}" for name, x in (document["gains"] or {}).items()]
    lines += [f"  {name:<12} {x:.10g} (certified)" for name, x in (document["bound"] or {}).items()]
    lines.append(f"  verdict      {document['verdict']}")
    if document["certificate"]:
        lines.append(f"  certificate  {document['certificate']}")
        lines.append(f"  check        sensortrack check {document['certificate']}")
    lines += [f"  note         {note}" for note in document["notes"]]
    return [harmless(line) for line in lines]
