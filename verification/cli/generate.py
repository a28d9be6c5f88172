"""``sensortrack generate``: numeric source to drop into a project, with its self-test."""

from __future__ import annotations

import argparse
import math
import sys
from fractions import Fraction
from pathlib import Path
from typing import Any

from sensortrack.errors import InputError
from verification.exact.rationals import nearest as nearest_double
from verification.files import require_folder, write_text
from verification.input_words import brief, nearest
from verification.inputs import read_inputs

from . import given

TESTS = {"c": "make test", "python": "python selftest.py"}
TARGETS = ("python", "numpy", "c", "casadi")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the command's arguments."""
    parser.add_argument("system", metavar="SYSTEM")
    parser.add_argument("--target", required=True, choices=TARGETS, help="language of the source")
    parser.add_argument("--out", required=True, metavar="DIR", help="a new or empty folder")
    parser.add_argument(
        "--coordinates", type=int, metavar="N", help="size of vectors; that of the gains by default"
    )
    parser.epilog = "inputs given become constants of the source, the others arguments of step"
    given.add_arguments(parser)


def run(options: argparse.Namespace) -> int:
    """Write the folder; 0."""
    from theory.codegen.emit import files
    from theory.codegen.printing import source_of

    room = _room(options.system)
    folder = Path(options.out)
    require_folder(folder)
    n, constants, note = room.constants(_values(options, room), options.coordinates)
    texts = files(source_of(room.STEPPER, n, constants), options.target)
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in texts.items():
        write_text(folder / name, text)
    print(f"{options.system}, {n} coordinates, target {options.target}: {folder}")
    print(f"  constants  {', '.join(constants) or 'none'}")
    print(f"  files      {', '.join(texts)}")
    print(f"  self-test  cd {folder} && {TESTS.get(options.target, 'python selftest.py')}")
    if note:
        print(f"sensortrack: note: {note}", file=sys.stderr)
    return 0


def _room(system: str) -> Any:
    """The module that knows the system's stepper and its constants."""
    from importlib import import_module

    from theory.codegen.emit import STEPPERS

    if system not in STEPPERS:
        hint = nearest(system, STEPPERS) or f"one of {', '.join(STEPPERS)} is needed"
        raise InputError(brief(system), "no system with generated source", hint)
    return import_module(f"verification.systems.{system}.generating")


def _values(options: argparse.Namespace, room: Any) -> dict[str, Any]:
    """The inputs that were given, checked one by one."""
    values = given.given_values(options)
    question = f"generate {options.system}"
    network = given.given_network(options, room.INPUTS, question)
    known = {entry.name for entry in room.INPUTS}
    inputs = [e for e in room.INPUTS if e.name in values or not {*values} <= known]
    found = read_inputs(inputs, values, network, question).values
    for name, value in found.items():
        _in_doubles(name, value)
    return found


def _in_doubles(name: str, value: Any) -> None:
    """Refuse a number that the source, whose numbers are doubles, would hold as zero or not."""
    if isinstance(value, tuple):
        for entry in value:
            _in_doubles(name, entry)
    elif isinstance(value, Fraction):
        double = nearest_double(value)
        if math.isinf(double) or (value and not double):
            size = "large" if math.isinf(double) else "small"
            raise InputError(name, f"a number too {size} for a double", "other units are needed")
