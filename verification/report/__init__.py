"""Reports on what was found: terminal, Markdown, and one HTML page."""

from __future__ import annotations

from pathlib import Path


def build(folder: Path) -> tuple[Path, Path]:
    """Write ``report.html`` and ``report.md`` beside the records of a run.

    Parameters
    ----------
    folder : Path
        With ``claims.json``, ``facts.json`` and possibly ``networks.json``.

    Returns
    -------
    tuple of Path
        The page and the Markdown.

    Raises
    ------
    OSError, ValueError
        A record is missing or unreadable, or the folder cannot be written.
    """
    from verification.files import write_text

    from .markdown import markdown
    from .page import page
    from .records import read_findings

    findings = read_findings(folder)
    html, text = folder / "report.html", folder / "report.md"
    write_text(html, page(findings))
    write_text(text, markdown(findings))
    return html, text
