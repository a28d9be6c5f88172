"""An estimator can be added as CONTRIBUTING.md says: its example is built and asked."""

import json
import os
import re
import shutil
import subprocess
import sys

import pytest

from tests.meta.repository import ROOT, tracked_files

TITLED = re.compile(r"^`([\w/]+\.py)`\n\n```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)
TUPLE = ROOT / "theory" / "systems" / "__init__.py"


@pytest.fixture(scope="module")
def checkout(tmp_path_factory):
    """The three packages and what the page adds to them."""
    folder = tmp_path_factory.mktemp("checkout")
    for name in tracked_files():
        if name.startswith(("theory/", "sensortrack/", "verification/")):
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, folder / name)
    for path, text in TITLED.findall((ROOT / "CONTRIBUTING.md").read_text()):
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text)
    known = re.sub(
        r"(import .*|MODULES = \(.*)variational", r"\1variational, smoother", TUPLE.read_text()
    )
    (folder / "theory" / "systems" / "__init__.py").write_text(known)
    run(folder, "theory", "generate", "--root", str(folder))
    return folder


def run(folder, module, *arguments):
    """Run a module of the copy, in a process that sees no other."""
    environment = {**os.environ, "PYTHONPATH": str(folder), "NO_COLOR": "1"}
    return subprocess.run(
        [sys.executable, "-m", module, *arguments],
        cwd=folder, env=environment, capture_output=True, text=True, check=False,
    )  # fmt: skip


def test_the_page_names_every_file_of_the_example(checkout):
    added = dict(TITLED.findall((ROOT / "CONTRIBUTING.md").read_text()))
    assert len(added) == 4
    assert all("smoother" in path for path in added)
    listed = run(checkout, "theory", "list")
    assert "smoother" in listed.stdout, listed.stderr


def test_its_claim_is_decided_with_a_file_that_the_checker_accepts(checkout):
    done = run(checkout, "verification", "verify", "smoother", "--out", "out", "--json")
    assert done.returncode == 0, done.stderr
    (claim,) = json.loads((checkout / "out" / "claims.json").read_text())
    assert (claim["verdict"], claim["sharp"]) == ("REFUTED", "g < 2")
    checker = checkout / "verification" / "certificates" / "check.py"
    files = [str(checkout / "out" / name) for name in claim["certificates"]]
    again = subprocess.run(
        [sys.executable, "-I", "-S", checker, *files], capture_output=True, check=False
    )
    assert again.returncode == 0
    assert "Constant-gain smoother" in (checkout / "out" / "report.html").read_text()


@pytest.mark.parametrize("gain,status", [("1.999", 0), ("2", 1), ("2.5", 1), ("0", 2), ("x", 2)])
def test_its_condition_is_decided_on_both_sides_of_the_limit(checkout, gain, status):
    done = run(checkout, "verification", "certify", "smoother.gain", "--set", f"g={gain}")
    assert done.returncode == status, done.stderr


def test_it_is_listed(checkout):
    assert "smoother.section_1_stable" in run(checkout, "verification", "claims", "smoother").stdout
    assert "gain" in run(checkout, "verification", "quantities", "smoother").stdout
