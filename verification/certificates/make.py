"""Make a certificate: name the statement, add the witness, let the checker have the last word."""

from __future__ import annotations

import functools
import json
from collections.abc import Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

from sensortrack.errors import SensorTrackError

from . import check

Item = dict[str, Any]
PRODUCER = "sensortrack 0.1"


class CertificateError(SensorTrackError):
    """No witness was found, or the checker refuses it: the message names the stage."""


@functools.cache
def statements() -> dict[str, Any]:
    """The committed ``statements.json``, by ``SYSTEM.NAME``."""
    path = Path(__file__).with_name("statements.json")
    return dict(json.loads(path.read_text(encoding="utf-8")))


def plain(value: Any) -> Any:
    """JSON form of exact data: rationals and large integers as text."""
    if isinstance(value, Fraction):
        return str(value)
    if isinstance(value, int) and not isinstance(value, bool):
        return value if abs(value) < 2**53 else str(value)
    if isinstance(value, Mapping):
        return {key: plain(entry) for key, entry in value.items()}
    if isinstance(value, Sequence) and not isinstance(value, str):
        return [plain(entry) for entry in value]
    return value


class Prover(check.Proof):
    """Runs through a statement as the checker does and finds the definiteness witnesses by itself.

    All other witness items are taken, in order, from the list that it is given.
    """

    def __init__(self, env: dict[str, Any], witness: list[Item], kinds: dict[str, Any]) -> None:
        super().__init__(env, witness, kinds)  # type: ignore[no-untyped-call]
        self.made: list[Item] = []
        self.bases: list[int] = []

    def take(self, kinds: Mapping[str, str]) -> Item:
        """Return the next witness item; a definiteness witness is the one just found."""
        item = self.found if "congruence" in kinds else next(self.items, None)
        fields: Item = check.fields(item, kinds)
        self.made.append(dict(fields))
        return fields

    def definite(self, rows: list[list[Fraction]]) -> None:
        """Prove one matrix by a combination of proved ones if there is one, else by congruence."""
        from verification.exact.definite import combination, congruence

        terms = combination(rows, {k: self.proved[k] for k in self.bases})
        if terms:
            self.found: Item = {"kind": "combination", "terms": plain(terms)}
        else:
            factor = congruence(tuple(map(tuple, rows)))
            if factor is None:
                raise CertificateError(
                    f"a {len(rows)} x {len(rows)} matrix is not positive definite"
                )
            self.found = {"kind": "congruence", "rows": plain(factor)}
            self.bases.append(len(self.proved))
        super().definite(rows)  # type: ignore[no-untyped-call]


def certificate(
    system: str,
    name: str,
    inputs: Mapping[str, Any],
    witness: Sequence[Item],
    case: str = "PROVED",
    lower: Fraction | str | None = None,
    upper: Fraction | str | None = None,
) -> dict[str, Any]:
    """Make the document of a certificate and validate it.

    Parameters
    ----------
    system, name : str
        The statement ``system.name`` of ``statements.json``.
    inputs : mapping
        The statement's data: rationals, nested lists of them, or a graph's ``to_data()``.
    witness : sequence of dict
        Witness items in the order in which the statement's predicates ask for them, without those
        that show a matrix to be positive definite: these are found here.
    case : str, optional
        Which case of the statement.
    lower, upper : Fraction or str, optional
        The ends of the certified interval, where the case has them.

    Returns
    -------
    dict
        The document, ready for JSON.

    Raises
    ------
    CertificateError
        The checker refuses it; the message is the checker's reason.
    """
    statement = statements()[f"{system}.{name}"]
    document: dict[str, Any] = {
        "format": check.FORMAT,
        "system": system,
        "name": name,
        "digest": check.digest_of(statement),
        "case": case,
        "verdict": statement["cases"][case]["verdict"],
        "inputs": plain(inputs),
        "relies_on": statement["relies_on"],
        "witness": plain(witness),
        "about": {"producer": PRODUCER},
    }
    ends = {"lower": lower, "upper": upper}
    document |= {end: plain(value) for end, value in ends.items() if value is not None}
    provers: list[Prover] = []

    def prover(*arguments: Any) -> Prover:
        provers.append(Prover(*arguments))
        return provers[-1]

    try:
        check.check_document(document, statements(), prover)
        given, document["witness"] = document["witness"], provers[0].made
        if document["witness"] != given:  # else the checker itself has just been through it
            check.check_document(json.loads(json.dumps(document)), statements())
    except check.Reject as error:
        raise CertificateError(f"{system}.{name}: {error}") from error
    if len(json.dumps(document)) > check.FILE_BYTES:
        raise CertificateError(f"{system}.{name}: a file longer than the checker reads")
    return document
