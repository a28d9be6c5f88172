"""The report on one run as Markdown: words and digits of the page."""

from __future__ import annotations

from .markdown import escape, table_of
from .records import Record, digits
from .run_page import (
    BOUND_HEAD,
    bound_rows,
    run_facts,
    run_headline,
    summary_table,
)


def run_markdown(run: Record) -> str:
    """Return the whole text."""
    parts = [f"# {escape(run_headline(run))}", escape(run.get("about", ""))]
    parts += ["## How good it was", table_of(*summary_table(run))]
    parts += _list("Events", [f"{digits(e['time'])} s: {e['text']}" for e in run.get("events", [])])
    rows = bound_rows(run)
    if rows:
        parts += ["## Proved bounds beside the run", table_of(BOUND_HEAD, rows)]
    parameters = [[name, str(value)] for name, value in run["parameters"].items()]
    parts += ["## Setting", table_of(("parameter", "value"), parameters)]
    parts += _list("Chosen here, because the paper does not print it", run.get("assumptions", []))
    parts += _list("Notes", run.get("notes", []))
    facts = run_facts(run)
    parts.append("\n".join(f"- {name}: {escape(value)}" for name, value in facts.items()))
    return "\n\n".join(part for part in parts if part) + "\n"


def _list(title: str, entries: list[str]) -> list[str]:
    if not entries:
        return []
    return [f"### {title}", "\n".join(f"- {escape(entry)}" for entry in entries)]
