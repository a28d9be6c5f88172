"""``sensortrack certify``: decide whether a condition holds for the user's data."""

from __future__ import annotations

import argparse

from verification.answers import Condition

from . import answering

STATUS = {"PROVED": 0, "REFUTED": 1}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the command's arguments."""
    answering.add_arguments(parser, "condition")


def run(options: argparse.Namespace) -> int:
    """Decide; 0 PROVED, 1 REFUTED, 3 neither, or no certificate though one was asked for."""
    system, condition = answering.find(options.what, Condition)
    found, written = answering.answer(options, system, condition)
    return STATUS.get(found.verdict, answering.NO_ANSWER) if written else answering.NO_ANSWER
