"""``sensortrack bound``: the sharp constant for the user's data."""

from __future__ import annotations

import argparse

from verification.answers import Quantity

from . import answering


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the command's arguments."""
    answering.add_arguments(parser, "quantity")


def run(options: argparse.Namespace) -> int:
    """Answer; 0 with a value, 3 without one."""
    system, quantity = answering.find(options.what, Quantity)
    found, written = answering.answer(options, system, quantity)
    answered = found.value is not None and found.verdict != "UNDECIDED" and written
    return 0 if answered else answering.NO_ANSWER
