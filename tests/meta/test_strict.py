"""A strict run refuses skips, in tests and in whole modules; an ordinary run shows them."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

CONFTEST = Path(__file__).parents[1] / "conftest.py"

SKIPS = {
    "a test": "import pytest\ndef test_it(): pytest.skip('nothing here')\n",
    "a module": "import pytest\npytest.importorskip('no_such_package_anywhere')\n",
}


@pytest.mark.parametrize("what", SKIPS)
@pytest.mark.parametrize("strict", [False, True])
def test_skips_are_refused_only_in_a_strict_run(tmp_path: Path, what: str, strict: bool) -> None:
    (tmp_path / "conftest.py").write_text(CONFTEST.read_text())
    (tmp_path / "pytest.ini").write_text("[pytest]\n")
    (tmp_path / "test_skips.py").write_text(SKIPS[what])
    (tmp_path / "test_passes.py").write_text("def test_it(): pass\n")
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("PYTEST", "SENSOR"))}
    if strict:
        environment["SENSORTRACK_STRICT"] = "1"

    run = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", str(tmp_path)],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        env=environment,
        check=False,
    )

    assert (run.returncode != 0) == strict, run.stdout
    assert ("refused in a strict run" in run.stdout) == strict, run.stdout
