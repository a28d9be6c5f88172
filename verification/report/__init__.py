"""Reports on what was found: terminal, Markdown, and one HTML page."""

from __future__ import annotations

from pathlib import Path


def build(folder: Path) -> tuple[Path, Path]:
    """Write ``report.html`` and ``report.md`` beside the records of a run.

    Parameters
    ----------
    folder : Path
        What `verify` left (``claims.json``, ``facts.json``, possibly ``networks.json``) or what
        `simulate` left (``run.json``); the claims come first where a folder has both.

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

    html, text = folder / "report.html", folder / "report.md"
    for path, content in zip((html, text), _pages(folder), strict=True):
        write_text(path, content)
    return html, text


def _pages(folder: Path) -> tuple[str, str]:
    """Page and Markdown, on claims or on a run."""
    if not (folder / "claims.json").exists() and (folder / "run.json").exists():
        from .records import read_run
        from .run_markdown import run_markdown
        from .run_page import run_page

        run = read_run(folder)
        return run_page(run), run_markdown(run)
    from .markdown import markdown
    from .page import page
    from .records import read_findings

    findings = read_findings(folder)
    return page(findings), markdown(findings)
