"""Generated C in a program of one's own: the same estimates as those of the Python estimator."""

import shlex
import subprocess
import sysconfig
from pathlib import Path

import numpy as np

from sensortrack.estimators import CyclicSpsa
from sensortrack.polar import PolarView
from sensortrack.schedules import Schedule
from verification.cli.main import main

PROGRAM = Path(__file__).with_name("spsa_sensor.c")
STRICT = ("-std=c99", "-Wall", "-Wextra", "-Wconversion", "-Werror", "-O1", "-ffp-contract=off")
SENDERS = {"p": ("a", (0.0, 0.0)), "q": ("b", (40.0, -3.0))}
CYCLES = 30


def text(values):
    return " ".join(f"{float(value):.17g}" for value in values)


def test_a_program_around_the_generated_source_follows_as_the_estimator_does(tmp_path):
    out = tmp_path / "block"
    assert main(["generate", "cyclic_spsa", "--target", "c", "--out", str(out)]) == 0
    compiler = shlex.split(sysconfig.get_config_var("CC") or "cc")[0]
    command = [compiler, *STRICT, f"-I{out}", PROGRAM, out / "cyclic_spsa.c", "-lm"]
    subprocess.run([*command, "-o", tmp_path / "sensor"], check=True)

    rng = np.random.default_rng(3)
    schedule = Schedule([["p"], ["q"]], {name: sender for name, (sender, _) in SENDERS.items()})
    estimator = CyclicSpsa(schedule, {"p": 0.5, "q": 0.5}, alpha=0.25, beta=2.0, seed=9)
    state = estimator.init(positions={"p": (30.0, 25.0), "q": (-4.0, 60.0)})
    lines, wanted = [text(row) for row in state.positions], []
    for t in range(1, 4 * CYCLES + 1):
        target = "pq"[(t - 1) // 2 % 2]
        if t % 4 == 1:
            lines.append(text(estimator.perturbation(schedule.turn(t).cycle).ravel()))
        angle, distance = rng.uniform(-3, 3), rng.uniform(5, 50)
        lines.append(text((angle, distance)))
        sender, place = SENDERS[target]
        state = estimator.step(t, state, [PolarView(sender, target, angle, distance, place)])
        if t % 2 == 0:
            wanted.append(state.positions["pq".index(target)])
    given = "\n".join(lines)
    done = subprocess.run(
        [tmp_path / "sensor"], input=given, capture_output=True, text=True, check=True
    )
    found = [[float(word) for word in line.split()] for line in done.stdout.splitlines()]
    assert len(found) == 2 * CYCLES
    assert np.allclose(found, wanted, rtol=1e-12, atol=1e-12)
