"""The answer to a question as the ``--json`` document, and as lines for a reader."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from fractions import Fraction
from pathlib import Path
from typing import Any

from verification.answers import Answer, Condition, Detail, Quantity
from verification.plain_text import harmless

LABEL = 13
LONGEST = 72
"""Characters of one input that are shown to a reader."""


def document_of(
    system: str,
    question: Quantity | Condition,
    found: Answer,
    inputs: Mapping[str, Any],
    path: str | None,
    seconds: float,
    details: Mapping[str, Detail],
) -> dict[str, Any]:
    """The ``--json`` document of an answer."""
    kind = "quantity" if isinstance(question, Quantity) else "condition"
    document: dict[str, Any] = {
        "system": system,
        kind: question.name,
        "value": jsonable(found.value),
        "exact": found.exact,
        "lower": jsonable(found.lower),
        "upper": jsonable(found.upper),
        "printed": jsonable(found.printed),
        "verdict": str(found.verdict),
        "certificate": path,
        "inputs": dict(inputs),
        "digest": _digest(system, found),
        "seconds": round(seconds, 6),
        "notes": list(found.notes),
    }
    if kind == "condition":
        document["margin"] = jsonable(found.margin)
    return document | {name: detail.data for name, detail in details.items()}


def details_of(found: Answer) -> dict[str, Detail]:
    """What explains an answer, by name."""
    made = {name: make() for name, make in found.more.items()}
    return {name: detail for name, detail in made.items() if detail is not None}


def jsonable(value: Any) -> Any:
    """Numbers as doubles, infinite ones as text, no number as null, lists likewise."""
    if value is None or isinstance(value, str):
        return value
    if isinstance(value, (list, tuple)):
        return [jsonable(entry) for entry in value]
    number = float(value)
    if math.isnan(number):
        return None
    if math.isinf(number):
        return "inf" if number > 0 else "-inf"
    return number


def _digest(system: str, found: Answer) -> str:
    """Digest of the certificate's statement, else of the system."""
    if found.certificate is not None:
        return str(found.certificate["digest"])
    from theory.systems import SYSTEMS

    return next((entry.digest for entry in SYSTEMS if entry.name == system), "")


def lines_of(
    document: Mapping[str, Any], details: Mapping[str, Detail], proved: str = "certified"
) -> list[str]:
    """The answer for a reader, a line each, without characters that a terminal acts on."""
    return [harmless(line) for line in _lines_of(document, details, proved)]


def _lines_of(document: Mapping[str, Any], details: Mapping[str, Detail], proved: str) -> list[str]:
    question = document.get("quantity", document.get("condition"))
    lines = [f"{document['system']}.{question}"]
    given = {name: value for name, value in document["inputs"].items() if value is not None}
    lines += [_line(name, _short(value)) for name, value in given.items()]
    lines.append("")
    if "quantity" in document:
        lines += _value_lines(document, proved)
    elif document["margin"] is not None:
        lines.append(_line("margin", f"{_digits(document['margin'])} from the threshold"))
    lines.append(_line("verdict", document["verdict"]))
    lines += [_line(*pair) for detail in details.values() for pair in detail.lines]
    lines += [_line("note", note) for note in document["notes"]]
    path = document["certificate"]
    if path is not None:
        lines.append(_line("certificate", f"{path} ({Path(path).stat().st_size} bytes)"))
        lines.append(_line("check", f"sensortrack check {path}"))
    return lines


def _value_lines(document: Mapping[str, Any], proved: str) -> list[str]:
    value, exact, printed = document["value"], document["exact"], document["printed"]
    lines = [_line("value", "none" if value is None else _digits(value))]
    if exact is not None:
        lines.append(_line("exactly", _exact(exact)))
    if document["lower"] is not None and document["upper"] is not None:
        ends = f"{_digits(document['lower'])} … {_digits(document['upper'])}"
        lines.append(_line("bracket", f"{ends} ({proved})"))
    elif document["lower"] is not None:
        lines.append(_line("at least", _digits(document["lower"])))
    elif document["upper"] is not None:
        lines.append(_line("at most", _digits(document["upper"])))
    if printed is not None:
        lines.append(_line("printed", _digits(printed) + _ratio(printed, value)))
    return lines


def _line(label: str, text: str) -> str:
    return f"  {label:<{LABEL - 1}} {text}"


def _short(value: Any) -> str:
    text = value if isinstance(value, str) else json.dumps(value).replace('"', "")
    return text if len(text) <= LONGEST else text[:LONGEST] + "…"


def _digits(value: Any) -> str:
    """All digits of a double, without a trailing .0; lists in brackets."""
    if isinstance(value, list):
        return f"[{', '.join(map(_digits, value))}]"
    text = str(value)
    return text.removesuffix(".0")


def _exact(exact: Mapping[str, Any]) -> str:
    """A rational as it is, an algebraic number by its polynomial and interval."""
    if exact["kind"] == "rational":
        return str(exact["value"])
    low, high = (_decimal(end) for end in exact["interval"])
    powers = [_term(int(c), k) for k, c in enumerate(exact["polynomial"]) if int(c)]
    polynomial = " ".join(reversed(powers)).removeprefix("+ ")
    return f"the root of {polynomial} between {low} and {high}"


def _term(coefficient: int, power: int) -> str:
    sign = "-" if coefficient < 0 else "+"
    letter = ("", "x", f"x^{power}")[min(power, 2)]
    size = "" if abs(coefficient) == 1 and power else f"{abs(coefficient)} "
    return f"{sign} {size}{letter}".rstrip()


def _decimal(end: Any) -> str:
    return f"{float(Fraction(str(end))):.6g}"


def _ratio(printed: Any, value: Any) -> str:
    """How far the printed value is from the sharp one."""
    if not isinstance(printed, float) or not isinstance(value, float) or value <= 0:
        return ""
    return f" ({printed / value:.4g} times the value)"
