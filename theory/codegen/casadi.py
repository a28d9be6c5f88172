"""Printer for CasADi: the same lines on symbols."""

from __future__ import annotations

from .printing import Language, Source, decimal, heading, text
from .python import arguments

SYMBOLS = Language(
    decimal,
    {
        **{name: f"ca.{name}({{0}})" for name in ("sin", "cos", "sqrt")},
        "sgn": "(({0} > {1}) - ({0} < {1}))",
        "select": "ca.if_else({0} > {1}, {2}, {3})",
    },
)


def casadi(source: Source) -> str:
    """Module whose functions return ``casadi.Function``; CasADi keeps the order of operations."""
    lines = ['"""' + heading(source)[0], *heading(source)[1:], '"""', ""]
    lines += ["from __future__ import annotations", "", "import casadi as ca", ""]
    lines += [f'DIGEST = "{source.digest}"']
    for function in source.functions:
        name, groups = function.program.name, arguments(source, function)
        lines += ["", "", f"def {name}():", f'    """{function.program.about}"""']
        for group in groups:
            names = [entry for entry, _ in source.layout(group)]
            lines.append(f'    {group}_ = ca.SX.sym("{group}", {len(names)})')
            lines += [f"    {entry} = {group}_[{k}]" for k, entry in enumerate(names)]
        for line in function.lines:
            lines += [f"    # {line.heading}"] if line.heading else []
            lines.append(f"    {line.name} = {text(function, line.expr, SYMBOLS, own=True)}")
        results = [text(function, result, SYMBOLS) for result in function.results]
        out = f"{function.program.output}_next"
        lines += [f"    {out}_ = ca.vertcat(", *(f"        {r}," for r in results), "    )"]
        given = ", ".join(f"{group}_" for group in groups)
        labels = ", ".join(f'"{group}"' for group in groups)
        ends = f'[{given}], [{out}_], [{labels}], ["{out}"]'
        lines.append(f'    return ca.Function("{name}", {ends})')
    return "\n".join(lines) + "\n"
