"""Laws of every generated stepper: purity, shapes, units, frames, replay, one result everywhere."""

import numpy as np
import pytest

from sensortrack.errors import InputError
from sensortrack.kernels.steppers import stepper
from tests.laws.cases import CONDITION, FRAMES
from tests.laws.loading import loaded
from theory.codegen.casadi import casadi
from theory.codegen.emit import STEPPERS, stepper_of
from theory.codegen.printing import source_of
from theory.codegen.python import numpy, python
from theory.codegen.vectors import vectors
from theory.reference import evaluate
from theory.units import parse_unit

SOURCES = {name: source_of(stepper_of(name)) for name in STEPPERS}
FUNCTIONS = [(name, f) for name, source in SOURCES.items() for f in source.functions]
EACH = pytest.mark.parametrize(
    "system, function", FUNCTIONS, ids=[f"{name}.{f.program.name}" for name, f in FUNCTIONS]
)
SHIFT = {"m": 2.0, "s": 0.5, "kg": 4.0, "rad": 1.0}
"""New units, as powers of two of the old ones: nothing is rounded by changing to them."""
ROUNDINGS = 64 * 2.0**-52


def bits(values):
    return [float(x).hex() for x in values]


def drawn(system, function, count=16):
    """Arguments that the function is meant for, from its test vectors."""
    for vector in vectors(SOURCES[system], function)[:count]:
        yield [np.array(group) for group in vector.given]


def groups_of(system, function):
    return [group for group in function.program.groups if SOURCES[system].layout(group)]


@EACH
def test_arguments_stay_as_they_are_and_the_same_call_gives_the_same_bits(system, function):
    for groups in drawn(system, function):
        before = [bits(group) for group in groups]
        first = stepper(system).call(function.program.name, *groups)
        again = stepper(system).call(function.program.name, *groups)
        assert [bits(group) for group in groups] == before
        assert bits(first) == bits(again)
        assert first is not again


@EACH
def test_results_are_flat_doubles_of_the_layout(system, function):
    size = len(SOURCES[system].layout(function.program.output))
    for groups in drawn(system, function, 2):
        for given in (groups, [g.tolist() for g in groups], [np.repeat(g, 2)[::2] for g in groups]):
            found = stepper(system).call(function.program.name, *given)
            assert (found.shape, found.dtype) == ((size,), np.float64)
            assert bits(found) == bits(stepper(system).call(function.program.name, *groups))


@EACH
def test_a_group_of_another_length_is_refused(system, function):
    (groups,) = drawn(system, function, 1)
    for k, name in enumerate(groups_of(system, function)):
        for wrong in (groups[k][:-1], np.append(groups[k], 0.0)):
            with pytest.raises(InputError, match=name):
                stepper(system).call(function.program.name, *groups[:k], wrong, *groups[k + 1 :])
    with pytest.raises(InputError, match=function.program.name):
        stepper(system).call(function.program.name, *groups[1:])


@EACH
def test_other_units_give_the_same_numbers_in_those_units(system, function):
    """Bit by bit, since the factors are powers of two."""
    source = SOURCES[system]
    for groups in drawn(system, function):
        turned = [
            g * factors(source, name)
            for g, name in zip(groups, groups_of(system, function), strict=True)
        ]
        plain = stepper(system).call(function.program.name, *groups)
        found = stepper(system).call(function.program.name, *turned)
        assert bits(found) == bits(plain * factors(source, function.program.output))


def factors(source, group):
    """What one of each number's unit is in the new units."""
    found = []
    for _, unit in source.layout(group):
        factor = 1.0
        for base, power in parse_unit(unit).powers:
            factor *= SHIFT[base] ** int(power)
        found.append(factor)
    return np.array(found)


TURNED = [(name, f) for name, f in FUNCTIONS if f.program.name in FRAMES[name].functions]


@pytest.mark.parametrize(
    "system, function", TURNED, ids=[f"{name}.{f.program.name}" for name, f in TURNED]
)
def test_a_turned_frame_turns_the_result(system, function):
    frame, source = FRAMES[system], SOURCES[system]
    turn = frame.draw(np.random.default_rng(8))

    def turned(group, numbers):
        return frame.turned([name for name, _ in source.layout(group)], numbers, turn)

    for groups in drawn(system, function):
        found = stepper(system).call(
            function.program.name,
            *(turned(name, g) for g, name in zip(groups, groups_of(system, function), strict=True)),
        )
        plain = stepper(system).call(function.program.name, *groups)
        wanted = turned(function.program.output, plain)
        assert found == pytest.approx(wanted, rel=1e-9, abs=1e-9 * np.abs(wanted).max())


@pytest.mark.parametrize("system", STEPPERS)
def test_replay_is_step_after_step(system):
    step = next(f for f in SOURCES[system].functions if f.program.name == "step")
    (groups,) = drawn(system, step, 1)
    context, state, given = groups
    inputs = np.random.default_rng(5).normal(size=(20, len(given)))
    rows = stepper(system).run(context, state, inputs)
    for row, one in zip(rows, inputs, strict=True):
        state = stepper(system).call("step", context, state, one)
        assert bits(row) == bits(state)
    assert bits(stepper(system).run(context, groups[1], inputs).ravel()) == bits(rows.ravel())


@EACH
def test_floats_numpy_casadi_and_compiled_source_agree(system, function):
    """Bit by bit where only + - * / and square roots occur, which every language rounds alike.

    Sines and cosines are those of one C library for floats and compiled source, again bit by bit;
    those of NumPy and CasADi may differ by the slack of the vector.
    """
    source, name = SOURCES[system], function.program.name
    loaded_numpy, in_casadi = loaded(numpy(source))[name], loaded(casadi(source))[name]()
    one_library = [
        loaded(python(source))[name],
        lambda *groups: stepper(system).call(name, *groups),
        lambda *groups: stepper(system).compiled(name, *groups),
    ]
    others = [
        lambda *groups: loaded_numpy(*map(np.array, groups)),
        lambda *groups: in_casadi(*groups).full().ravel(),
    ]
    for vector in vectors(source, function):
        for road in one_library if not source.exact else one_library + others:
            assert bits(road(*vector.given)) == bits(vector.wanted)
        for road in () if source.exact else others:
            off = np.abs(road(*vector.given) - np.array(vector.wanted))
            same = np.isnan(road(*vector.given)) & np.isnan(vector.wanted)
            assert (same | (off <= vector.slack)).all()


@EACH
def test_slack_is_a_few_roundings_of_what_the_data_determine(system, function):
    """No result of a vector hangs on the last bit of a sine, and no status on any bit of it."""
    source = SOURCES[system]
    names = [name for name, _ in source.layout(function.program.output)]
    for vector in vectors(source, function):
        if source.exact:
            assert vector.slack == ()
            continue
        finite = [abs(x) for x in vector.wanted if np.isfinite(x)]
        for name, slack in zip(names, vector.slack, strict=True):
            allowed = 0.0 if name in ("status", "known") else 4 * CONDITION[system] * ROUNDINGS
            assert slack <= allowed * max([1.0, *finite])


@EACH
def test_fifty_digits_are_met_within_a_few_roundings(system, function):
    source, name = SOURCES[system], function.program.name
    names = groups_of(system, function)
    for groups in drawn(system, function, 64):
        given = dict(zip(names, (g.tolist() for g in groups), strict=True))
        exact = evaluate(source.stepper, function.program, source.n, given)
        found = stepper(system).call(name, *groups)
        error = max(abs(a - b) for a, b in zip(found.tolist(), exact, strict=True))
        assert error <= CONDITION[system] * ROUNDINGS * max(abs(x) for x in exact)
