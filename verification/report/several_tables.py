"""What is said of a run in which several sensors follow several targets."""

from __future__ import annotations

import math

from .records import Record, count, digits, number_word

HEAD = (
    "estimate",
    "error at the start, rms in m",
    "settled at, s",
    "expected, s",
    "error, rms in m",
    "expected, m",
    "closed form, m",
    "alpha over its limit",
    "diverged at, s",
)


def metres(value: float | None) -> str:
    """Four significant digits, thousands apart, without an exponent where there is room."""
    if value is None:
        return "–"
    if value and not 1e-3 <= abs(value) < 1e12:
        return f"{value:.4g}"
    rounded = float(f"{value:.4g}")
    places = 3 - math.floor(math.log10(abs(rounded))) if rounded else 0
    if places >= 0:
        return f"{rounded:.{places}f}".rstrip("0").rstrip(".") if places else f"{rounded:.0f}"
    return f"{rounded:,.0f}".replace(",", "\u202f")


def rows(run: Record) -> list[list[str]]:
    """One row an estimate; what was expected is known of cyclic SPSA only."""
    labels = {entry["name"]: entry["label"] for entry in run["estimates"]}
    expected = {entry["of"]: entry for entry in run.get("expected", ())}
    made = []
    for row in run["summary"]:
        beside = expected.get(row["estimate"], {})
        limit = beside.get("limit")
        share = beside["alpha"] / limit if limit else None
        made.append(
            [
                labels[row["estimate"]],
                metres(row["start"]),
                digits(row["settled"]),
                digits(beside.get("settled")),
                metres(row["position_rms"]),
                metres(beside.get("rms")),
                metres(beside.get("frozen")),
                "–" if share is None else metres(float(f"{share:.3g}")),
                digits(row["diverged"]),
            ]
        )
    return made


def headline(run: Record) -> str:
    """The result in one sentence."""
    best = [row for row in run["summary"] if row["estimate"] in own_settings(run)]
    labels = {entry["name"]: entry["label"] for entry in run["estimates"]}
    whole = [row for row in best if row["position_rms"] is not None]
    lost = sum(row["diverged"] is not None for row in best)
    many = f"{number_word(lost)} of {count(len(best), 'setting')} diverged"
    said = ("it diverged" if len(best) == 1 else many) if lost else "nothing diverged"
    if not whole:
        return f"{run['title']}: {said}"
    first = min(whole, key=lambda row: float(row["position_rms"]))
    name = labels[first["estimate"]]
    with_ = f" with {name}" if len(best) > 1 else ""
    return f"{run['title']}: {metres(first['position_rms'])} m rms{with_}; {said}"


def lede(run: Record) -> str:
    """How to read the table."""
    since = run["summary"][0]["from"]
    return (
        f"Root-mean-square over all sensors and targets; the error is that from {since:g} s on, "
        "settled means below a tenth of the first estimate's error at the start. What is expected "
        "are exact moments along the paths of this run, over all draws of the errors and of the "
        "perturbations; the closed form is the error that would settle if the geometry in the "
        "middle of that time lasted. Above 1, alpha is beyond the step at which the mean square "
        "stays bounded everywhere."
    )


def own_settings(run: Record) -> list[str]:
    """Names of the settings of the algorithm, without the one that stands for another."""
    return [e["name"] for e in run["spsa"]["variants"] if e["name"] != "plain"]


def text_lines(run: Record) -> list[str]:
    """The table in plain text, for a terminal."""
    short = (
        "",
        "start",
        "settled",
        "expected",
        "rms",
        "expected",
        "closed form",
        "alpha/limit",
        "diverged",
    )
    body = rows(run)
    width = max(len(row[0]) for row in body)
    units = (f"rms from {run['summary'][0]['from']:g} s", "m", "s", "s", "m", "m", "m", "", "s")
    return [
        f"{first:<{width + 2}}" + "".join(f"{cell:>13}" for cell in rest)
        for first, *rest in ((*short,), (*units,), *((f"  {row[0]}", *row[1:]) for row in body))
    ]
