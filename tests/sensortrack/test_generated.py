"""The committed source is what theory generates, and all languages agree bit by bit."""

import ctypes
import itertools
import os
import re
import shutil
import subprocess
import sys

import numpy as np
import pytest

from sensortrack.generated import variational, variational_numpy
from sensortrack.kernels.steppers import stepper
from tests.meta.repository import ROOT
from theory.__main__ import generated_files
from theory.codegen.emit import STEPPERS, files, stepper_of
from theory.codegen.printing import source_of
from theory.codegen.vectors import vectors
from theory.systems.variational.stepper import STEPPER

SOURCE = source_of(STEPPER)
FUNCTIONS = {function.program.name: vectors(SOURCE, function) for function in SOURCE.functions}
FOLDERS = [(name, compiler) for name in STEPPERS for compiler in ("gcc", "clang")]
FOLDERS += [("variational", "cc")]
GENERATED = generated_files()


def bits(values):
    return [float(x).hex() for x in values]


@pytest.mark.parametrize("name", sorted(GENERATED))
def test_the_committed_file_is_what_theory_generates(name):
    current = (ROOT / name).read_text()
    assert current == GENERATED[name], "run 'make generate' and look at the difference"


@pytest.mark.parametrize("seed", ["0", "17"])
def test_the_same_bytes_come_out_whatever_the_hash_seed(seed):
    done = subprocess.run(
        [sys.executable, "-m", "theory", "generate", "--check"],
        cwd=ROOT,
        env={**os.environ, "PYTHONHASHSEED": seed},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout


def test_source_names_no_date_host_or_folder():
    for text in files(SOURCE, "c").values():
        assert not re.search(r"/home|/root|/work|20\d\d-\d\d", text)


def test_lanes_are_independent():
    rows = FUNCTIONS["step"][:5]
    stacked = [np.array(group).T for group in zip(*(row.given for row in rows), strict=True)]
    found = variational_numpy.step(*stacked)
    for lane, row in enumerate(rows):
        assert bits(found[:, lane]) == bits(row.wanted)


def test_without_a_compiler_the_same_numbers_come_from_floats(monkeypatch):
    monkeypatch.setenv("SENSORTRACK_NO_COMPILER", "1")
    stepper.cache_clear()
    plain = stepper("variational")
    assert plain.library is None
    assert "SENSORTRACK_NO_COMPILER" in plain.reason
    for vector in FUNCTIONS["step"][:8]:
        assert bits(plain.call("step", *vector.given)) == bits(vector.wanted)
    rng = np.random.default_rng(2)
    state, inputs = rng.normal(size=9), rng.normal(size=(3, 6))
    context = np.array(FUNCTIONS["step"][0].given[0])
    found = plain.run(context, state, inputs)
    stepper.cache_clear()
    monkeypatch.delenv("SENSORTRACK_NO_COMPILER")
    assert bits(found.ravel()) == bits(stepper("variational").run(context, state, inputs).ravel())


@pytest.mark.parametrize("system,compiler", FOLDERS)
def test_the_folder_tests_itself_with_a_compiler_alone(tmp_path, system, compiler):
    if shutil.which(compiler) is None:
        pytest.skip(f"{compiler} is not installed")
    for name, text in files(source_of(stepper_of(system)), "c").items():
        (tmp_path / name).write_text(text)
    done = subprocess.run(
        ["make", "-C", tmp_path, f"CC={compiler}", "test"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.count(" 0 mismatches") == 2
    assert "warning" not in done.stderr


def test_the_self_test_sees_a_wrong_coefficient(tmp_path):
    for name, text in files(SOURCE, "c").items():
        wrong = text.replace("(h * K_01)", "(h * K_02)") if name.endswith("l.c") else text
        (tmp_path / name).write_text(wrong)
    done = subprocess.run(
        ["make", "-C", tmp_path, "test"], capture_output=True, text=True, check=False
    )
    assert done.returncode != 0
    assert " 0 mismatches" not in done.stdout


@pytest.mark.parametrize(
    "right,wrong",
    [
        ("((-TRK_R(1.0)) * TRK_SIN(theta))", "(TRK_R(1.0) * TRK_SIN(theta))"),
        ("(p_i_det > det_min) ?", "(p_i_det < det_min) ?"),
    ],
)
def test_the_self_test_with_slack_sees_a_wrong_line(tmp_path, right, wrong):
    texts = files(source_of(stepper_of("bearing_dac")), "c")
    assert right in texts["bearing_dac.c"]
    for name, text in texts.items():
        (tmp_path / name).write_text(
            text.replace(right, wrong) if name == "bearing_dac.c" else text
        )
    build = ["make", "-C", tmp_path, "CFLAGS=-O0", "selftest"]
    subprocess.run(build, check=True, capture_output=True)
    done = subprocess.run([tmp_path / "selftest"], capture_output=True, text=True, check=False)
    assert done.returncode != 0
    assert " 0 mismatches" not in done.stdout


def test_a_library_of_another_version_is_not_used(monkeypatch):
    stepper.cache_clear()
    monkeypatch.setattr(variational, "DIGEST", "0" * 64)
    found = stepper("variational")
    stepper.cache_clear()
    assert found.library is None
    assert "different versions" in found.reason


def test_the_layout_says_name_and_unit_of_every_number():
    layout = [variational.CONTEXT, variational.STATE, variational.INPUT]
    assert [len(group) for group in layout] == [19, 9, 6]
    assert dict(variational.CONTEXT)["K_01"] == "kg/s^2"
    assert isinstance(stepper("variational").library, ctypes.CDLL)
    names = list(itertools.chain.from_iterable(dict(group) for group in layout))
    assert len({*names}) == len(names)
