"""The page of one simulated run: what was run, how good it was, what bounded it."""

from __future__ import annotations

from . import several_tables
from .dom import Element, el
from .header import facts
from .page import document
from .plots import plot
from .records import Record, count, digits
from .run_figures import figures
from .several_figures import several_figures


def run_page(run: Record) -> str:
    """Return the page's text.

    Parameters
    ----------
    run : dict
        Content of ``run.json``.
    """
    names = {"summary": "Summary", "figures": "Figures", "bounds": "Bounds", "setting": "Setting"}
    rail = el(
        "nav",
        [el("a", text, href=f"#{key}") for key, text in names.items()],
        class_="rail",
        aria_label="Sections",
    )
    body = el("main", _summary(run), _figures(run), _bounds(run), _setting(run))
    return document(f"{run['title']} – SensorTrack", rail, _header(run), body, _footer(run))


def run_headline(run: Record) -> str:
    """The result of a run in one sentence."""
    if "targets" in run:
        return several_tables.headline(run)
    own = {row["estimate"]: row for row in run["summary"]}[run["system"]]
    rms = f"{digits(own['position_rms'])} m rms" if own["position_rms"] is not None else "unknown"
    bounds = run.get("bounds", [])
    if not bounds:
        return f"{run['title']}: position error {rms}"
    broken = sum(not entry["holds"] for entry in bounds)
    said = "every proved bound held" if not broken else f"{count(broken, 'bound')} crossed"
    return f"{run['title']}: position error {rms}, {said}"


def _header(run: Record) -> Element:
    theme = el("button", "Theme: Auto", type="button", id="theme", class_="jsonly")
    return el(
        "header",
        el("div", el("span", el("b", "SensorTrack"), " run report"), theme, class_="brand"),
        el("h1", run_headline(run)),
        el("p", run.get("about", ""), class_="lede"),
        facts(run_facts(run)),
        class_="top",
        id="top",
    )


def run_facts(run: Record) -> dict[str, str]:
    """What is needed to run it again."""
    samples, length = run.get("samples", len(run["time"])), run["time"][-1] - run["time"][0]
    return {
        "Command": run.get("command", ""),
        "Seed": str(run["seed"]),
        "Samples": f"{samples} over {digits(length)} s",
        "Version": f"SensorTrack {run.get('version', '')}",
        "Digest": run["digest"][:16],
    }


def _summary(run: Record) -> Element:
    events = [el("li", f"{digits(e['time'])} s: {e['text']}") for e in run.get("events", [])]
    return el(
        "section",
        el("h2", "How good it was"),
        el("p", several_tables.lede(run), class_="sub") if "targets" in run else None,
        _table(*summary_table(run)),
        [el("h3", "Events"), el("ul", events)] if events else None,
        id="summary",
    )


SUMMARY_HEAD = ("estimate", "position error, rms in m", "velocity error, rms in m/s", "from, s")


def summary_table(run: Record) -> tuple[tuple[str, ...], list[list[str]]]:
    """Head and rows of the summary, the same in every report."""
    if "targets" in run:
        return several_tables.HEAD, several_tables.rows(run)
    return SUMMARY_HEAD, summary_rows(run)


def summary_rows(run: Record) -> list[list[str]]:
    """One row an estimate."""
    labels = {entry["name"]: entry["label"] for entry in run["estimates"]}
    return [
        [
            labels.get(row["estimate"], row["estimate"]),
            digits(row["position_rms"]),
            digits(row["velocity_rms"]),
            digits(row.get("from")),
        ]
        for row in run["summary"]
    ]


BOUND_HEAD = ("bound", "of", "statement", "held", "reached")


def bound_rows(run: Record) -> list[list[str]]:
    """One row a bound."""
    return [
        [
            entry["name"],
            f"{entry['of']}, {entry['quantity']}",
            "; ".join(filter(None, (entry["statement"], entry.get("remark")))),
            "yes" if entry["holds"] else "no",
            f"{100 * float(entry['reached']):.3g} %",
        ]
        for entry in run.get("bounds", [])
    ]


def _figures(run: Record) -> Element:
    drawn = [
        el(
            "figure",
            plot(figure, f"figure-{name}"),
            el("figcaption", figure.caption),
            id=f"figure-{name}",
        )
        for name, figure in (several_figures if "targets" in run else figures)(run)
    ]
    return el("section", el("h2", "Figures"), el("div", drawn, class_="pair"), id="figures")


def _bounds(run: Record) -> Element:
    rows = bound_rows(run)
    said = el("p", "No bound is proved for this setting.", class_="sub")
    table = _table(BOUND_HEAD, rows) if rows else said
    return el("section", el("h2", "Proved bounds beside the run"), table, id="bounds")


def _setting(run: Record) -> Element:
    parameters = [[name, str(value)] for name, value in run["parameters"].items()]
    assumed = [el("li", text) for text in run.get("assumptions", [])]
    notes = [el("li", text) for text in run.get("notes", [])]
    return el(
        "section",
        el("h2", "Setting"),
        _table(("parameter", "value"), parameters),
        [el("h3", "Chosen here, because the paper does not print it"), el("ul", assumed)]
        if assumed
        else None,
        [el("h3", "Notes"), el("ul", notes)] if notes else None,
        id="setting",
    )


def _table(head: tuple[str, ...], rows: list[list[str]]) -> Element:
    top = el("tr", [el("th", text, scope="col") for text in head])
    body = [
        el("tr", el("th", name, scope="row"), [el("td", cell) for cell in cells])
        for name, *cells in rows
    ]
    return el("div", el("table", el("thead", top), el("tbody", body)), class_="scroll")


def _footer(run: Record) -> Element:
    words = f"SensorTrack {run.get('version', '')}. This page loads nothing from anywhere."
    return el("footer", el("p", words))
