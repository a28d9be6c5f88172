"""Certificates of statements made up for a test, so that each lemma of the checker is met alone."""

import json
import subprocess
import sys
from pathlib import Path
from unittest import mock

from verification.certificates import check
from verification.certificates.make import CertificateError, Prover

CHECKER = Path(check.__file__)


def statement(show, inputs=None, symbols=None, given=(), ends=None):
    """An entry of statements.json with one case, called PROVED."""
    case = {"verdict": "PROVED", "words": "as shown", "show": list(show), "ends": ends or {}}
    return {
        "cases": {"PROVED": case},
        "inputs": inputs or {},
        "symbols": symbols or {},
        "given": list(given),
        "relies_on": [],
    }


def document(entry, inputs, witness, case="PROVED", name="test.it", **ends):
    """A certificate of an entry of statements.json."""
    system, short = name.split(".")
    return {
        "format": check.FORMAT,
        "system": system,
        "name": short,
        "digest": check.digest_of(entry),
        "case": case,
        "verdict": entry["cases"][case]["verdict"],
        "inputs": inputs,
        "relies_on": entry["relies_on"],
        "witness": witness,
        "about": {},
        **ends,
    }


def checked(show, witness=(), inputs=None, kinds=None, prover=check.Proof, **more):
    """Check a statement with these predicates; raise Reject where the witness does not prove it."""
    entry = statement(show, kinds, **more)
    made = document(entry, inputs or {}, list(witness))
    return check.check_document(made, {"test.it": entry}, prover)


REFUSALS = (
    check.Reject, ArithmeticError, AttributeError, LookupError, MemoryError, RecursionError,
    SyntaxError, TypeError, ValueError,
)  # fmt: skip
"""What hostile data may provoke: `check_file` makes INVALID of it."""


def accepts(show, witness=(), inputs=None, kinds=None, **more):
    """Whether the checker believes it."""
    try:
        checked(show, witness, inputs, kinds, **more)
    except REFUSALS:
        return False
    return True


def proved_by_search(show, witness=(), inputs=None, kinds=None, **more):
    """The witness with the definiteness items found, as make.py finds them."""
    provers = []

    def prover(*arguments):
        provers.append(Prover(*arguments))
        return provers[-1]

    checked(show, witness, inputs, kinds, prover=prover, **more)
    return provers[0].made


def run_checker(*arguments, cwd=None):
    """The checker as a program, away from the installed package."""
    return subprocess.run(
        [sys.executable, "-I", "-S", CHECKER, *map(str, arguments)],
        capture_output=True,
        text=True,
        check=False,
        cwd=cwd,
    )


def judged(made, path, known):
    """Entry and exit status of one document, read from a file."""
    path.write_text(made if isinstance(made, str) else json.dumps(made), encoding="utf-8")
    return check.check_file(str(path), known)


def judged_in_memory(made, known):
    """As `judged` says, without the way through a file: forgeries are many."""
    read = json.loads(json.dumps(made))
    with mock.patch.object(check, "read_json", return_value=read):
        return check.check_file("in memory", known)


def provable(show, inputs, kinds=None, witness=()):
    """The witness that is found, or None; the checker itself runs within the search."""
    try:
        return proved_by_search(show, witness, inputs, kinds)
    except (check.Reject, CertificateError):
        return None


def text(rows):
    return [[str(x) for x in row] for row in rows]


def congruence(*rows):
    return {"kind": "congruence", "rows": [list(row) for row in rows]}


def vector(*x):
    return {"kind": "vector", "x": list(x)}
