"""``sensortrack generate``: folders that test themselves, and what is refused."""

import json
import subprocess
import sys

import pytest

from verification.cli.main import main

GAINS = ("--set", "M=[[2,0.5],[0.5,1]]", "--set", "K=3", "--set", "C=1.5", "--set", "h=0.1")


def generate(out, *arguments, target="python"):
    return main(["generate", "variational", "--target", target, "--out", str(out), *arguments])


@pytest.mark.parametrize("target", ["python", "numpy", "casadi"])
@pytest.mark.parametrize("given", [(), GAINS, ("--coordinates", "1", "--set", "M=2")])
def test_python_targets_test_themselves(tmp_path, target, given):
    assert generate(tmp_path / "out", *given, target=target) == 0
    done = subprocess.run(
        [sys.executable, "selftest.py"],
        cwd=tmp_path / "out",
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert " 0 mismatches" in done.stdout


def test_the_python_target_imports_the_standard_library_alone(tmp_path):
    generate(tmp_path / "out")
    code = "import variational, sys; sys.exit(any(m in sys.modules for m in ('numpy', 'sympy')))"
    done = subprocess.run(
        [sys.executable, "-S", "-c", code], cwd=tmp_path / "out", capture_output=True, check=False
    )
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("given", [(), GAINS, ("--coordinates", "6")])
def test_the_c_target_needs_a_compiler_alone(tmp_path, given):
    assert generate(tmp_path / "out", *given, target="c") == 0
    done = subprocess.run(
        ["make", "-C", tmp_path / "out", "test"], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr


def test_inputs_given_become_constants(tmp_path):
    generate(tmp_path / "out", *GAINS)
    manifest = json.loads((tmp_path / "out" / "manifest.json").read_text())
    assert manifest["coordinates"] == 2
    assert manifest["layout"]["context"] == []
    assert manifest["constants"]["K"] == [["3", "0"], ["0", "3"]]


def test_an_unstable_step_is_remarked_on(tmp_path, capsys):
    gains = ("--set", "M=1", "--set", "K=1", "--set", "C=1")
    generate(tmp_path / "a", *gains, "--set", "h=3.2")
    assert "not stable" not in capsys.readouterr().err
    generate(tmp_path / "b", *gains, "--set", "h=3.3")
    assert "not stable at h = 33/10" in capsys.readouterr().err


@pytest.mark.parametrize(
    "given,name",
    [
        (("--set", "M=[[1,2],[2,1]]"), "M"),
        (("--set", "M=[[1,2],[0,1]]"), "M"),
        (("--set", "h=0"), "h"),
        (("--set", "h=-1"), "h"),
        (("--set", "h=1e400"), "h"),
        (("--set", "K=1e-400"), "K"),
        (("--set", "G=1"), "G"),
        (("--set", "M=[[1,0],[0,1]]", "--set", "K=[[1,0,0],[0,1,0],[0,0,1]]"), "K"),
        (("--set", "M=[[1,0],[0,1]]", "--coordinates", "3"), "M"),
        (("--coordinates", "0"), "--coordinates"),
        (("--coordinates", "13"), "--coordinates"),
        (("--graph", "path:3"), "graph"),
    ],
)
def test_bad_input_is_refused_by_name_and_nothing_is_written(tmp_path, capsys, given, name):
    assert generate(tmp_path / "out", *given) == 2
    assert capsys.readouterr().err.startswith(f"sensortrack: {name}: ")
    assert not (tmp_path / "out").exists()


def test_a_folder_that_holds_something_is_left_alone(tmp_path, capsys):
    (tmp_path / "mine.txt").write_text("mine")
    assert generate(tmp_path) == 2
    assert capsys.readouterr().err.startswith("sensortrack: --out: ")
    assert [path.name for path in tmp_path.iterdir()] == ["mine.txt"]
    assert generate(tmp_path / "mine.txt") == 2
    assert generate(tmp_path / "mine.txt" / "below") == 2


def test_an_unknown_system_is_named(tmp_path, capsys):
    assert main(["generate", "variatonal", "--target", "c", "--out", str(tmp_path / "o")]) == 2
    assert "did you mean variational" in capsys.readouterr().err


NODE = ("--set", "s=[3, 4]", "--set", "period=0.01")
GAINS_OF_NODE = ("--set", "beta_P=1/2", "--set", "beta_q=20", "--set", "det_min=1e-6")


def node(out, *arguments, target):
    return main(["generate", "bearing_dac", "--target", target, "--out", str(out), *arguments])


@pytest.mark.parametrize(
    "target,given",
    [
        ("python", NODE),
        ("numpy", ()),
        ("c", (*NODE, *GAINS_OF_NODE)),
        ("casadi", (*NODE, *GAINS_OF_NODE)),
    ],
)
def test_the_source_of_one_node_tests_itself(tmp_path, target, given):
    assert node(tmp_path / "out", *given, target=target) == 0
    run = [sys.executable, "selftest.py"] if target != "c" else ["make", "test"]
    done = subprocess.run(run, cwd=tmp_path / "out", capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert " 0 mismatches" in done.stdout


@pytest.mark.parametrize(
    "given,name",
    [
        (("--set", "s=[1]"), "s"),
        (("--set", "s=1"), "s"),
        (("--set", "period=0"), "period"),
        (("--set", "beta_P=-1"), "beta_P"),
        (("--set", "beta_q=0"), "beta_q"),
        (("--set", "det_min=1/4"), "det_min"),
        (("--set", "det_min=-1"), "det_min"),
        (("--coordinates", "3"), "--coordinates"),
        (("--set", "beta=1"), "beta"),
    ],
)
def test_bad_constants_of_a_node_are_refused_by_name(tmp_path, capsys, given, name):
    assert node(tmp_path / "out", *given, target="c") == 2
    assert capsys.readouterr().err.startswith(f"sensortrack: {name}: ")
    assert not (tmp_path / "out").exists()


BLOCK = ("--set", "alpha=0.05", "--set", "beta=1/4")


def block(out, *arguments, target):
    return main(["generate", "cyclic_spsa", "--target", target, "--out", str(out), *arguments])


BLOCKS = {
    "free": (),
    "h": ("--set", "h=[0.3, 0.3, 1.1, 1.1]", *BLOCK),
    "H": ("--set", "H=[[1,0.2],[0.2,0.7]]", "--set", "beta=3"),
    "twelve": ("--coordinates", "12", "--set", "h=0.1"),
}


@pytest.mark.parametrize(
    "target,given",
    [
        ("c", "H"),
        ("c", "twelve"),
        ("numpy", "h"),
        ("python", "free"),
        ("python", "h"),
        ("casadi", "h"),
        ("casadi", "H"),
    ],
)
def test_the_source_of_one_block_tests_itself(tmp_path, target, given):
    assert block(tmp_path / "out", *BLOCKS[given], target=target) == 0
    run = [sys.executable, "selftest.py"] if target != "c" else ["make", "CFLAGS=-O0", "test"]
    done = subprocess.run(run, cwd=tmp_path / "out", capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert " 0 mismatches" in done.stdout


@pytest.mark.parametrize(
    "given,size,constants",
    [
        ((), 2, set()),
        (("--set", "h=[1, 2, 3, 4]"), 4, {"H"}),
        (("--set", "h=1/2"), 2, {"H"}),
        (("--set", "H=1/2", "--coordinates", "6", *BLOCK), 6, {"H", "alpha", "beta"}),
    ],
)
def test_a_block_has_as_many_coordinates_as_its_hessian(tmp_path, given, size, constants):
    block(tmp_path / "out", *given, target="python")
    manifest = json.loads((tmp_path / "out" / "manifest.json").read_text())
    assert (manifest["coordinates"], {*manifest["constants"]}) == (size, constants)
    assert len(manifest["layout"]["state"]) == size


@pytest.mark.parametrize(
    "hessian,below,limit",
    [("h=[1, 1, 2, 2]", "0.33", "1/3"), ("H=[[1,0.9],[0.9,1]]", "0.52", "10/19")],
)
def test_a_step_that_is_unstable_without_noise_is_remarked_on(
    tmp_path, capsys, hessian, below, limit
):
    block(tmp_path / "a", "--set", hessian, "--set", f"alpha={below}", target="python")
    assert "not stable" not in capsys.readouterr().err
    block(tmp_path / "b", "--set", hessian, "--set", f"alpha={limit}", target="python")
    assert f"alpha = {limit} is not stable" in capsys.readouterr().err


@pytest.mark.parametrize(
    "given,name",
    [
        (("--set", "h=[1, 0]"), "h"),
        (("--set", "h=[1, 2]", "--set", "H=1"), "h"),
        (("--set", "H=[[1,2],[2,1]]"), "H"),
        (("--set", "H=[[1,2],[0,1]]"), "H"),
        (("--set", "h=[1, 2, 3]", "--coordinates", "2"), "h"),
        (("--set", f"h={[1] * 13}"), "--coordinates"),
        (("--coordinates", "0"), "--coordinates"),
        (("--set", "alpha=0"), "alpha"),
        (("--set", "beta=-1"), "beta"),
        (("--set", "beta=1e-400"), "beta"),
        (("--set", "alpha=1e31"), "alpha"),
        (("--set", "h=[1, 1e400]"), "h"),
        (("--set", "H=[[1e-400]]"), "H"),
        (("--set", "gamma=1"), "gamma"),
    ],
)
def test_bad_constants_of_a_block_are_refused_by_name(tmp_path, capsys, given, name):
    assert block(tmp_path / "out", *given, target="c") == 2
    assert capsys.readouterr().err.startswith(f"sensortrack: {name}: ")
    assert not (tmp_path / "out").exists()
