"""The ``sensortrack`` command: chooses the sub-command and turns errors into exit statuses.

Nothing beyond the standard library is imported here, and a sub-command's module only when that
sub-command was called, so that ``--help`` answers at once.
"""

from __future__ import annotations

import argparse
import io
import os
import sys
from collections.abc import Mapping, Sequence
from importlib import import_module
from typing import NoReturn

COMMANDS: Mapping[str, str] = {
    "verify": "decide every printed claim; write certificates and report",
    "certify": "does a condition hold for my network and numbers?",
    "bound": "the sharp constant for my data, beside the printed one",
    "check": "re-validate certificates with the standard-library checker",
    "design": "choose gains or steps that carry a certificate",
    "generate": "write the estimator as source: C, Python, NumPy, CasADi",
    "simulate": "run a scenario: tracks, errors, events, figures",
    "report": "build the pages again from what a run left",
    "systems": "list the estimators",
    "claims": "list the printed claims",
    "quantities": "list what bound, certify and design can be asked",
    "data": "list the real networks that are shipped",
}
STATUSES = """\
exit status: 0 answered, proved, valid; 1 refuted, invalid; 2 misuse or bad input; 3 no answer;
70 a fault of the program; 130 interrupted; 141 nobody reads the output"""
MISUSE, FAULT, INTERRUPTED, UNREAD = 2, 70, 130, 141
PACKAGES = {"flint": "python-flint"}
EXTRA = frozenset({"sympy", "flint", "cvxpy", "clarabel", "casadi", "networkx", "rich"})


class Formatter(argparse.RawDescriptionHelpFormatter):
    """Leaves room for the longest command's name."""

    def __init__(self, prog: str) -> None:
        super().__init__(prog, max_help_position=28)


class Misuse(Exception):
    """The command line cannot be read."""


class Parser(argparse.ArgumentParser):
    """Reports misuse like every other input error."""

    def error(self, message: str) -> NoReturn:
        """Raise instead of printing the usage.

        Raises
        ------
        Misuse
        """
        text = message.removeprefix("argument ")
        raise Misuse(f"{text}; '{self.prog} --help' shows what is needed")


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command.

    Parameters
    ----------
    argv : sequence of str, optional
        Arguments after the program's name; those of the process if left out.

    Returns
    -------
    int
        The exit status: see ``sensortrack --help``.
    """
    arguments = list(sys.argv[1:] if argv is None else argv)
    _tolerate_narrow_encodings()
    try:
        status = _run(arguments)
        sys.stdout.flush()
    except BrokenPipeError:
        # What is still buffered would raise again when the interpreter closes the stream.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return UNREAD
    except KeyboardInterrupt:
        print("sensortrack: interrupted", file=sys.stderr)
        return INTERRUPTED
    except SystemExit as end:  # argparse after --help
        return int(end.code or 0)
    except Exception as error:
        if "--debug" in arguments:
            import traceback

            traceback.print_exc()
        return _report(error)
    return status


def _run(arguments: list[str]) -> int:
    chosen = next((text for text in arguments if not text.startswith("-")), None)
    if chosen is not None and chosen not in COMMANDS:
        from verification.input_words import brief, nearest

        hint = nearest(chosen, list(COMMANDS)) or "'sensortrack --help' lists them"
        raise Misuse(f"{brief(chosen)}: no such command; {hint}")
    options = _parser(chosen).parse_args(arguments)
    if options.version:
        from importlib.metadata import version

        print(f"sensortrack {version('sensortrack')}")
        return 0
    if chosen is None:
        raise Misuse(f"command: not given; one of {', '.join(COMMANDS)} is needed")
    return int(options.run(options))


def _parser(chosen: str | None) -> Parser:
    """The parser, with the arguments of the chosen command only."""
    common = Parser(add_help=False)
    common.add_argument(
        "--debug", action="store_true", default=argparse.SUPPRESS, help="show a traceback"
    )
    parser = Parser(
        prog="sensortrack",
        description="Decide printed theorems about distributed estimators, with certificates.",
        epilog=STATUSES,
        formatter_class=Formatter,
        parents=[common],
        allow_abbrev=False,
    )
    parser.add_argument("--version", action="store_true", help="print the version")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND")
    for name, summary in COMMANDS.items():
        command = commands.add_parser(
            name,
            help=summary,
            description=f"{summary[0].upper()}{summary[1:]}",
            formatter_class=Formatter,
            parents=[common],
            allow_abbrev=False,
        )
        if name == chosen:
            module = import_module(f"verification.cli.{name}")
            module.add_arguments(command)
            command.set_defaults(run=module.run)
    return parser


def _report(error: Exception) -> int:
    """Say what went wrong on stderr and return the exit status."""
    missing = _missing_package(error)
    if missing:
        print(f"sensortrack: {missing}", file=sys.stderr)
        return MISUSE
    from sensortrack.errors import SensorTrackError

    if isinstance(error, (SensorTrackError, Misuse)):
        from verification.plain_text import harmless

        lines = f"sensortrack: {error}".split("\n")
        print("\n".join(map(harmless, lines)), file=sys.stderr)
        return MISUSE
    what = " ".join(str(error).split())[:500]
    print(f"sensortrack: internal: {type(error).__name__}: {what}", file=sys.stderr)
    print("This is a fault of the program; --debug shows where it arose.", file=sys.stderr)
    return FAULT


def _missing_package(error: Exception) -> str:
    """The cure for a package that is not installed, or empty."""
    if not isinstance(error, ModuleNotFoundError) or not error.name:
        return ""
    name = error.name.partition(".")[0]
    if name not in EXTRA:
        return ""
    from sensortrack.errors import MissingExtra

    return str(MissingExtra(PACKAGES.get(name, name), "verify"))


def _tolerate_narrow_encodings() -> None:
    """Print a substitute for what the terminal's encoding lacks, instead of failing."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")


if __name__ == "__main__":
    sys.exit(main())
