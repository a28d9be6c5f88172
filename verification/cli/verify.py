"""``sensortrack verify``: decide every printed claim."""

from __future__ import annotations

import argparse
import json
import shlex
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from verification.verdict import Verdict

FOLDER = "build/verify"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the command's arguments."""
    parser.add_argument(
        "what", nargs="*", metavar="SYSTEM[.CLAIM]", help="only these; everything by default"
    )
    parser.add_argument(
        "--out", default=FOLDER, metavar="DIR", help="where to write; %(default)s by default"
    )
    parser.add_argument("--json", action="store_true", help="print claims.json and nothing else")
    parser.add_argument(
        "--strict", action="store_true", help="exit 1 if a claim is UNDECIDED or a check skipped"
    )
    parser.add_argument("--quick", action="store_true", help="without the sweep over real networks")
    parser.add_argument("--jobs", type=_count, default=1, metavar="N", help="processes to use")
    parser.add_argument("--plain", action="store_true", help="ASCII only, no colour")


def run(options: argparse.Namespace) -> int:
    """Decide and report; 1 if `--strict` and something was left open, else 0."""
    from verification.report import build
    from verification.verify import select, tasks_of, verify

    selection, folder = select(options.what), Path(options.out)
    with _progress(len(tasks_of(selection, options.quick))) as tick:
        outcome = verify(
            selection,
            folder,
            quick=options.quick,
            jobs=options.jobs,
            command=_command(options),
            tick=tick,
        )
    build(folder)
    if options.json:
        print(json.dumps(outcome.claims))
    else:
        _show(options, folder)
    for line in outcome.skipped:
        print(f"sensortrack: skipped: {line}", file=sys.stderr)
    undecided = any(claim["verdict"] == Verdict.UNDECIDED for claim in outcome.claims)
    return int(options.strict and (undecided or bool(outcome.skipped)))


def _count(text: str) -> int:
    number = int(text) if text.isascii() and text.isdigit() else 0
    if not 1 <= number <= 256:
        raise argparse.ArgumentTypeError(f"{text[:20]!r}; a whole number from 1 to 256 is needed")
    return number


def _command(options: argparse.Namespace) -> str:
    """The command again, without what only concerns this terminal."""
    words = ["sensortrack", "verify", *options.what]
    if options.out != FOLDER:
        words += ["--out", options.out]
    return shlex.join(words + (["--quick"] if options.quick else []))


@contextmanager
def _progress(total: int) -> Iterator[Callable[[tuple[str, str]], None]]:
    """Show on stderr what was done last, if somebody looks."""
    if not sys.stderr.isatty():
        yield lambda _task: None
        return
    from rich.console import Console
    from rich.progress import Progress

    with Progress(console=Console(stderr=True), transient=True) as bar:
        row = bar.add_task("verify", total=total)
        yield lambda task: bar.update(row, advance=1, description=task[1])


def _show(options: argparse.Namespace, folder: Path) -> None:
    """The table, where the report is, and how to check everything again."""
    from verification.report.terminal import show

    show(folder, plain=options.plain)
    print(f"\nreport  {folder / 'report.html'}")
    print(f"check   sensortrack check {folder / 'certificates'}/*.json")
