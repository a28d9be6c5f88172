"""Generated source beside a slow evaluation of the laws in many digits."""

from hypothesis import given, settings
from hypothesis import strategies as st

from theory.codegen.printing import source_of
from theory.codegen.python import python
from theory.reference import evaluate
from theory.systems.variational.stepper import STEPPER

SOURCE = source_of(STEPPER)
SPACE: dict = {}
exec(python(SOURCE), SPACE)
ULP = 2.0**-52


def worst(name, groups):
    """Largest error of the generated function, relative to its largest result."""
    program = next(p for p in STEPPER.programs if p.name == name)
    layout = {g: SOURCE.layout(g) for g in program.groups if SOURCE.layout(g)}
    exact = evaluate(STEPPER, program, 3, dict(zip(layout, groups, strict=True)))
    found = SPACE[name](*groups)
    size = max(abs(x) for x in exact)
    return max(abs(a - b) for a, b in zip(found, exact, strict=True)) / size


@settings(max_examples=30)
@given(
    st.lists(st.floats(-100, 100), min_size=9, max_size=9),
    st.lists(st.floats(-100, 100), min_size=6, max_size=6),
    st.floats(0.001, 0.5),
)
def test_any_state_is_within_a_few_roundings(state, measured, h):
    gains = [2, 0.5, 0, 1, 0.2, 1.5, 4, 1, 0, 3, -0.5, 2, 1, 0, 0.3, 0.5, 0, 0.8]
    if max(map(abs, [*state, *measured])) > 1e-6:
        for name in ("step", "leapfrog_step"):
            assert worst(name, ([*gains, h], state, measured)) < 64 * ULP
