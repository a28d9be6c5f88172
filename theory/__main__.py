"""Write or compare what is generated from theory, and show the systems.

``python -m theory generate [--check]``, ``python -m theory list``, ``python -m theory show NAME``.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from difflib import unified_diff
from itertools import islice
from pathlib import Path

from .notation import render
from .system import System
from .systems import STATEMENTS, SYSTEMS

CHECKOUT = Path(__file__).resolve().parents[1]
TARGET = "verification/certificates/statements.json"
SOURCES = "sensortrack/generated"
SHOWN = 30
"""Lines of a difference that are shown."""


def statements_text() -> str:
    """Text of ``statements.json``: every statement by ``SYSTEM.NAME``, sorted."""
    entries = {f"{given.system}.{given.name}": given.to_data() for given in STATEMENTS}
    if len(entries) != len(STATEMENTS):
        raise ValueError("statements: two have the same name; one name each is needed")
    return json.dumps(entries, indent=1, sort_keys=True, ensure_ascii=True) + "\n"


def generated_files() -> dict[str, str]:
    """Every generated file, by its path below the root of a checkout."""
    from .codegen.emit import STEPPERS, committed, stepper_of
    from .codegen.printing import source_of

    made = {TARGET: statements_text()}
    for name in STEPPERS:
        texts = committed(source_of(stepper_of(name)))
        made |= {f"{SOURCES}/{file}": text for file, text in texts.items()}
    return made


def generate(root: Path, check: bool) -> int:
    """Write the generated files below ``root``, or compare them.

    Returns
    -------
    int
        0 if they are up to date afterwards, 1 if a comparison found a difference.
    """
    return max(_one(root, name, text, check) for name, text in generated_files().items())


def _one(root: Path, name: str, text: str, check: bool) -> int:
    path = root / name
    current = path.read_text(encoding="utf-8") if path.exists() else None
    if current == text:
        print(f"{name}: up to date")
        return 0
    if check:
        print(f"{name}: differs from theory; run 'make generate'")
        old, new = (current or "").splitlines(), text.splitlines()
        changes = unified_diff(old, new, "committed", "generated", lineterm="", n=1)
        shown = islice(changes, SHOWN)
        print("\n".join(line[:120] for line in shown))
        return 1
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")
    print(f"{name}: written")
    return 0


def show(system: System) -> str:
    """One system in plain text: laws, guards, claims, symbols, digest."""
    lines = [system.title, system.citation, f"digest {system.digest}", ""]
    lines += [f"{law.equation}: {law.left} = {law.right}" for law in system.laws] + [""]
    lines += [f"needs {g.condition}; otherwise {g.meaning}" for g in system.guards] + [""]
    lines += [f"{claim.id} ({claim.source}): {claim.title}" for claim in system.claims] + [""]
    return "\n".join(lines) + "\n" + render([system])


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command and return its exit status."""
    about = (__doc__ or "").partition("\n")[0]
    parser = argparse.ArgumentParser(prog="python -m theory", description=about)
    commands = parser.add_subparsers(dest="command", required=True)
    writer = commands.add_parser("generate", help="write what is generated from theory")
    writer.add_argument("--check", action="store_true", help="compare only; exit 1 if it differs")
    writer.add_argument("--root", type=Path, default=CHECKOUT, help="another checkout")
    commands.add_parser("list", help="name the systems")
    names = [system.name for system in SYSTEMS]
    commands.add_parser("show", help="print one system").add_argument("system", choices=names)
    options = parser.parse_args(argv)
    if options.command == "generate":
        return generate(options.root, options.check)
    if options.command == "list":
        print("\n".join(f"{system.name}: {system.title}" for system in SYSTEMS))
        return 0
    print(show(SYSTEMS[names.index(options.system)]), end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
