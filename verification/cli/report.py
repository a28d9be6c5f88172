"""``sensortrack report``: the pages again, from what a run of verify left."""

from __future__ import annotations

import argparse
from pathlib import Path

from sensortrack.errors import InputError


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the command's argument."""
    parser.add_argument("folder", metavar="DIR", help="with claims.json and facts.json of a run")


def run(options: argparse.Namespace) -> int:
    """Write both pages and print where they are."""
    from verification.report import build

    folder = Path(options.folder)
    try:
        pages = build(folder)
    except (OSError, ValueError, TypeError, LookupError, AttributeError) as error:
        # the records are files that anybody may have edited
        what = " ".join(str(error).split())
        found = f"no report can be made of {folder}: {type(error).__name__}: {what}"
        raise InputError("DIR", found, "a folder that verify wrote is needed") from error
    print("\n".join(map(str, pages)))
    return 0
