"""The dispatcher: quick help, errors on one line, exit statuses of what goes wrong."""

import os
import subprocess
import sys

import pytest

from tests.meta.repository import ROOT
from verification.cli import main as module
from verification.cli.main import COMMANDS, main

HEAVY = {"numpy", "scipy", "sympy", "flint", "rich", "cvxpy", "networkx", "theory"}


def start(*argv, **options):
    return subprocess.run(
        [sys.executable, "-m", "verification", *argv],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
        **options,
    )


def test_help_imports_nothing_heavy():
    code = (
        "import sys; before = set(sys.modules)\n"
        "from verification.cli.main import main\n"
        "assert main(['--help']) == 0\n"
        "print(*sorted(set(sys.modules) - before), file=sys.stderr)"
    )
    run = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True
    )
    loaded = run.stderr.split()
    assert not HEAVY & {name.partition(".")[0] for name in loaded}
    ours = {name for name in loaded if name.startswith(("verification", "sensortrack"))}
    assert ours == {"verification", "verification.cli", "verification.cli.main"}
    # argparse and what it needs, a count because times differ between machines
    assert len(loaded) < 60


def test_help_lists_exactly_the_commands_that_have_a_file(capsys):
    assert main(["--help"]) == 0
    out = capsys.readouterr().out
    for name, summary in COMMANDS.items():
        assert name in out
        assert summary in out
        assert (ROOT / "verification" / "cli" / f"{name}.py").is_file()


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_has_help(name, capsys):
    assert main([name, "--help"]) == 0
    assert f"sensortrack {name}" in capsys.readouterr().out


def test_the_version_is_printed(capsys):
    assert main(["--version"]) == 0
    assert capsys.readouterr().out.startswith("sensortrack 0.")


@pytest.mark.parametrize(
    "argv, first",
    [
        ([], "command: not given;"),
        (["boudn"], "boudn: no such command; did you mean bound?"),
        (["bound"], "the following arguments are required: SYSTEM.QUANTITY;"),
        (["bound", "toy.total", "--grap", "path:3"], "unrecognized arguments: --grap path:3;"),
        (["--nothing"], "unrecognized arguments: --nothing;"),
        (["verify", "--jobs", "0"], "--jobs: '0'; a whole number from 1 to 256 is needed;"),
        (["check"], "the following arguments are required: FILE;"),
        (["bound", "toy.total", "--set"], "--set: expected one argument;"),
    ],
)
def test_misuse_exits_2_with_one_line(run, argv, first):
    status, out, err = run(*argv)
    assert (status, out) == (2, "")
    assert err[0].startswith(f"sensortrack: {first}")


def test_an_unexpected_error_is_one_line_and_its_own_status(run):
    status, out, err = run("bound", "toy.broken")
    assert (status, out) == (70, "")
    assert err[0] == "sensortrack: internal: RuntimeError: two lines"
    assert len(err) == 2


@pytest.mark.parametrize("place", [0, 2])
def test_debug_shows_the_traceback_wherever_it_stands(run, place):
    argv = ["bound", "toy.broken"]
    argv.insert(place, "--debug")
    status, _, err = run(*argv)
    assert status == 70
    assert err[0].startswith("Traceback")
    assert "sensortrack: internal: RuntimeError: two lines" in err


def test_debug_shows_the_traceback_of_input_errors_too(run):
    assert run("bound", "toy.nothing", "--debug")[2][0].startswith("Traceback")


def test_a_missing_package_says_what_brings_it(run, monkeypatch):
    def fail(options):
        raise ModuleNotFoundError("No module named 'flint'", name="flint.types")

    monkeypatch.setattr("verification.cli.systems.run", fail)
    status, _, err = run("systems")
    assert status == 2
    assert err == [
        "sensortrack: python-flint: not installed; pip install 'sensortrack[verify]' brings it"
    ]


def test_a_missing_module_of_ours_is_a_fault(run, monkeypatch):
    def fail(options):
        raise ModuleNotFoundError("No module named 'theory.x'", name="theory.x")

    monkeypatch.setattr("verification.cli.systems.run", fail)
    assert run("systems")[0] == 70


def test_an_interrupt_exits_130(run, monkeypatch):
    def interrupt(options):
        raise KeyboardInterrupt

    monkeypatch.setattr("verification.cli.systems.run", interrupt)
    status, out, err = run("systems")
    assert (status, out, err) == (130, "", ["sensortrack: interrupted"])


def test_a_closed_pipe_is_silent():
    reader, writer = os.pipe()
    os.close(reader)
    try:
        run = subprocess.run(
            [sys.executable, "-m", "verification", "claims"],
            cwd=ROOT,
            stdout=writer,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
        )
    finally:
        os.close(writer)
    assert (run.returncode, run.stderr) == (141, "")


def test_a_narrow_encoding_prints_substitutes():
    environment = {**os.environ, "PYTHONIOENCODING": "ascii"}
    run = start("bound", "variational.step_limti", "--debug", env=environment)
    assert run.returncode == 2
    argv = ["bound", "variational.step_limit", "--set", "M=1", "--set", "K=1", "--set", "C=1"]
    run = start(*argv, env=environment)
    assert run.returncode == 0
    assert "3.23606797749979" in run.stdout


def test_statuses_of_faults_differ_from_those_of_answers():
    faults = {module.FAULT, module.INTERRUPTED, module.UNREAD}
    assert len(faults) == 3
    assert not faults & {0, 1, 2, 3, 4}
