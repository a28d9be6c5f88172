"""``sensortrack check``: re-validate certificates, as the checker's file does by itself."""

from __future__ import annotations

import argparse

from sensortrack.errors import InputError
from verification.certificates import check

from . import listing


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the checker's arguments."""
    parser.add_argument("files", nargs="+", metavar="FILE", help="certificate or counterexample")
    listing.add_json(parser)
    parser.add_argument(
        "--statements", metavar="FILE", help="other statements than those of this version"
    )


def run(options: argparse.Namespace) -> int:
    """Check; 0 all valid, 1 one is not, 2 one cannot be read."""
    arguments = ["--json"] if options.json else []
    if options.statements is not None:
        arguments += ["--statements", options.statements]
        try:
            check.read_json(options.statements)
        except (OSError, ValueError, RecursionError) as error:
            found = f"{options.statements}: {error}"
            raise InputError("--statements", found, "a readable statements.json") from None
    files = [f"./{name}" if name.startswith("-") else name for name in options.files]
    return int(check.main([*arguments, *files]))
