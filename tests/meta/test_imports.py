"""Imports point one way, and the checker stands on the standard library alone."""

import ast
import subprocess
import sys
from pathlib import Path

from tests.meta.repository import ROOT

CHECKER = ROOT / "verification" / "certificates" / "check.py"


def test_import_contracts_are_kept() -> None:
    program = Path(sys.executable).parent / "lint-imports"
    run = subprocess.run(
        [program, "--no-cache"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stdout + run.stderr


def imported_by(path: Path) -> set[str]:
    """Top-level names of all imports, those inside functions included."""
    names: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            names |= {alias.name.partition(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, "a relative import cannot work in a file that runs alone"
            names.add((node.module or "").partition(".")[0])
    return names


def test_the_checker_imports_the_standard_library_only() -> None:
    assert imported_by(CHECKER) <= sys.stdlib_module_names


def test_the_checker_runs_without_site_packages() -> None:
    code = f"import runpy; runpy.run_path({str(CHECKER)!r})"
    run = subprocess.run(
        [sys.executable, "-I", "-S", "-c", code], capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stderr
