"""Printers for Python: plain floats, and the same lines on NumPy lanes."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

from .lower import Lowered
from .printing import CALLS, Language, Source, decimal, heading, text
from .scalars import LIBM

WIDTH = 96
NAMES = {"sin": "Sine", "cos": "Cosine"}


Ending = Callable[[list[str]], list[str]]
"""Writes the return statement from the results."""


@dataclass(frozen=True)
class Style:
    """Imports and annotations of a module, and how its functions are written."""

    imports: tuple[str, ...]
    argument: str
    result: str
    language: Language


PLAIN = Style(
    ("from collections.abc import Sequence", ""),
    "Sequence[float]",
    "tuple[float, ...]",
    Language(
        decimal,
        CALLS
        | {
            "sgn": "(float({0} > {1}) - float({0} < {1}))",
            "select": "({2} if {0} > {1} else {3})",
        },
    ),
)
LANES = Style(
    ("import numpy as np", "from numpy.typing import ArrayLike, NDArray", ""),
    "ArrayLike",
    "NDArray[np.float64]",
    Language(
        decimal,
        {
            **{name: f"np.{name}({{0}})" for name in ("sin", "cos", "sqrt")},
            "sgn": "np.subtract({0} > {1}, {0} < {1}, dtype=float)",
            "select": "np.where({0} > {1}, {2}, {3})",
        },
    ),
)


def python(source: Source) -> str:
    """Module on floats: no import but the future; a call is a few hundred operations."""
    return _module(source, PLAIN, _tuple_of)


def numpy(source: Source) -> str:
    """Module on arrays whose first axis is the component and whose other axes are lanes."""
    return _module(source, LANES, _stack_of)


def _module(source: Source, style: Style, ending: Ending) -> str:
    lines = ['"""' + heading(source)[0], *heading(source)[1:], '"""', ""]
    lines += ["from __future__ import annotations", "", *_imports(source, style)]
    lines += [f'SYSTEM = "{source.stepper.system}"', f'DIGEST = "{source.digest}"']
    for group in source.stepper.groups:
        lines += _constant(
            group.upper(), (f'("{n}", "{unit}")' for n, unit in source.layout(group))
        )
    lines += _constant("GUARDS", (f'"{guard}"' for guard in source.stepper.guards))
    lines += ["OPERATIONS = {"]
    lines += [f'    "{name}": {count},' for name, count in source.operations.items()] + ["}"]
    lines += _outputs(source)
    lines += _helpers(source) if style is PLAIN else []
    for function in source.functions:
        lines += ["", "", *_function(source, function, style, ending)]
    return "\n".join(lines) + "\n"


def _imports(source: Source, style: Style) -> list[str]:
    """The mathematics of the standard library comes first, where plain floats need it."""
    if style is not PLAIN:
        return [*style.imports]
    used = ["import math"] if not source.exact else []
    roots = ["from math import sqrt"] if "sqrt" in source.calls else []
    return [*used, *style.imports[:1], *roots, *style.imports[1:]]


def _outputs(source: Source) -> list[str]:
    """Groups that come out of functions, where it is not the state."""
    others = {
        f.program.name: f.program.output for f in source.functions if f.program.output != "state"
    }
    if not others:
        return []
    return ["OUTPUTS = {", *(f'    "{name}": "{group}",' for name, group in others.items()), "}"]


def _helpers(source: Source) -> list[str]:
    """Sine and cosine that answer NaN where the standard library refuses."""
    lines: list[str] = []
    for name in sorted({*LIBM} & source.calls):
        lines += ["", "", f"def {name}(x: float) -> float:"]
        lines += [f'    """{NAMES[name]} of a finite angle in rad, else NaN, as in C."""']
        lines += [f"    return math.{name}(x) if math.isfinite(x) else math.nan"]
    return lines


def _constant(name: str, parts: Iterable[str]) -> list[str]:
    return [f"{name} = (", *(f"    {part}," for part in parts), ")"]


def arguments(source: Source, function: Lowered) -> list[str]:
    """Argument groups that hold numbers; the input is called so, because input is a builtin."""
    return [group for group in function.program.groups if source.layout(group)]


def _function(source: Source, function: Lowered, style: Style, ending: Ending) -> list[str]:
    groups = arguments(source, function)
    given = ", ".join(f"{group}_: {style.argument}" for group in groups)
    lines = [f"def {function.program.name}({given}) -> {style.result}:"]
    lines.append(f'    """{function.program.about}."""')
    for group in groups:
        names = [name for name, _ in source.layout(group)]
        value = f"np.asarray({group}_, dtype=float)" if style is LANES else f"{group}_"
        lines += _wrapped(f"({', '.join(names)},) = {value}", "    ")
    for line in function.lines:
        lines += [f"    # {line.heading}"] if line.heading else []
        lines.append(f"    {line.name} = {text(function, line.expr, style.language, own=True)}")
    lines += ending([text(function, result, style.language) for result in function.results])
    return lines


def _tuple_of(results: list[str]) -> list[str]:
    return ["    return (", *(f"        {result}," for result in results), "    )"]


def _stack_of(results: list[str]) -> list[str]:
    rows = [f"        {result}," for result in results]
    return ["    return np.stack(np.broadcast_arrays(", *rows, "    ))"]


def _wrapped(statement: str, indent: str) -> list[str]:
    """One assignment from a tuple, on several lines if it is long."""
    if len(indent + statement) <= WIDTH:
        return [indent + statement]
    names, _, value = statement.partition(" = ")
    inner = names.strip("(),").split(", ")
    return [f"{indent}(", *(f"{indent}    {name}," for name in inner), f"{indent}) = {value}"]
