"""Printer for CasADi: the same lines on symbols."""

from __future__ import annotations

from .printing import Source, decimal, heading, text
from .python import arguments


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
            lines.append(f"    {line.name} = {text(function, line.expr, decimal, own=True)}")
        results = [text(function, result, decimal) for result in function.results]
        lines += ["    state_next_ = ca.vertcat(", *(f"        {r}," for r in results), "    )"]
        given = ", ".join(f"{group}_" for group in groups)
        labels = ", ".join(f'"{group}"' for group in groups)
        ends = f'[{given}], [state_next_], [{labels}], ["state_next"]'
        lines.append(f'    return ca.Function("{name}", {ends})')
    return "\n".join(lines) + "\n"
