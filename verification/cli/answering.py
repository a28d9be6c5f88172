"""One question, from the command line to the answer: what `bound` and `certify` share."""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections.abc import Sequence
from pathlib import Path

from sensortrack.errors import InputError
from verification.answers import Answer, Condition, Quantity
from verification.files import certificate_text, require_target, write_text
from verification.input_words import brief, nearest
from verification.inputs import read_inputs
from verification.progress import shown_on_terminal
from verification.systems import SYSTEMS

from . import given
from .document import details_of, document_of, lines_of

Question = Quantity | Condition
NO_ANSWER = 3


def add_arguments(parser: argparse.ArgumentParser, what: str) -> None:
    """Add the arguments that `bound` and `certify` take."""
    parser.add_argument("what", metavar=f"SYSTEM.{what.upper()}")
    parser.epilog = "'sensortrack quantities' lists what can be asked, and with which inputs"
    given.add_arguments(parser)
    parser.add_argument("--out", metavar="FILE", help="write the certificate to this file")
    parser.add_argument(
        "--json", action="store_true", help="print one JSON document and nothing else"
    )


def find(text: str, kind: type[Question]) -> tuple[str, Question]:
    """The system's name and the question called `text`.

    Raises
    ------
    InputError
        There is none, or it is of the other kind.
    """
    system, _, name = text.partition(".")
    if system not in SYSTEMS:
        hint = nearest(system, list(SYSTEMS)) or f"one of {', '.join(SYSTEMS)} is needed"
        raise InputError(brief(text), "no such system", hint)
    module = SYSTEMS[system].quantities
    offered: dict[type[Question], Sequence[Question]] = {
        Quantity: module.QUANTITIES,
        Condition: module.CONDITIONS,
    }
    for question in offered[kind]:
        if question.name == name:
            return system, question
    other = Condition if kind is Quantity else Quantity
    command, wrong = ("certify", "condition") if other is Condition else ("bound", "quantity")
    if any(question.name == name for question in offered[other]):
        raise InputError(text, f"a {wrong}", f"ask 'sensortrack {command} {text}'")
    right = "quantity" if kind is Quantity else "condition"
    names = [f"{system}.{question.name}" for question in offered[kind]]
    hint = nearest(text, names) or f"one of {', '.join(names)} is needed"
    cure = f"'sensortrack quantities {system}' lists what can be asked"
    raise InputError(brief(text), f"no such {right}", hint, cure)


def answer(options: argparse.Namespace, system: str, question: Question) -> tuple[Answer, bool]:
    """Answer a question and print it.

    Returns
    -------
    answer : Answer
    written : bool
        Whether everything that was asked for was written.

    Raises
    ------
    InputError
        The question or its inputs cannot be used, or ``--out`` is no place for a certificate.
    """
    name = f"{system}.{question.name}"
    out = Path(options.out) if options.out is not None else None
    if out is not None:
        if isinstance(question, Quantity) and not question.certified:
            raise InputError("--out", f"{name} writes no certificate", "leave --out away")
        require_target(out, "--out")
    values = given.given_values(options)
    network = given.given_network(options, question.inputs, name)
    reading = read_inputs(question.inputs, values, network, name)
    started = time.perf_counter()
    with shown_on_terminal():
        found = question.answer(reading.values)
    seconds = time.perf_counter() - started
    if out is not None and found.certificate is not None:
        write_text(out, certificate_text(found.certificate))
    path = str(out) if out is not None and found.certificate is not None else None
    details = details_of(found)
    document = document_of(system, question, found, reading.texts, path, seconds, details)
    if options.json:
        print(json.dumps(document))
    else:
        print("\n".join(lines_of(document, details, found.proved)))
    written = out is None or path is not None
    if not written:
        reason = "; ".join(found.notes) or "no witness was found"
        print(f"sensortrack: {name}: no certificate was written: {reason}", file=sys.stderr)
    return found, written
