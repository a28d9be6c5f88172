"""Self-tests that go with generated source: vectors, and programs that count mismatches."""

from __future__ import annotations

import math

from .c99 import comment, prefix_of
from .lower import Lowered
from .printing import Source
from .python import arguments
from .vectors import COUNT, EDGES, Vector, vectors


def vectors_header(source: Source) -> str:
    """``SYSTEM_vectors.h``: hexadecimal numbers, so that every bit is there."""
    name = f"{prefix_of(source)}_vectors"
    lines = [*comment(["Data and results of the self-test, one row a vector."])]
    lines += [f"#ifndef {name.upper()}_H", f"#define {name.upper()}_H", "", "#include <math.h>", ""]
    for condition, precise in (("#ifndef TRK_REAL_FLOAT", True), ("#else", False)):
        lines.append(condition)
        for function in source.functions:
            table = vectors(source, function, precise)
            width = len(_numbers(table[0]))
            label = f"{function.program.name}_vectors"
            lines.append(f"static const trk_real {label}[{len(table)}][{width}] = {{")
            lines += [f"    {{{', '.join(_row(vector, precise))}}}," for vector in table]
            lines.append("};")
    return "\n".join([*lines, "#endif", "", "#endif"]) + "\n"


def _row(vector: Vector, precise: bool) -> list[str]:
    return [_hexadecimal(x, precise) for x in _numbers(vector)]


def _numbers(vector: Vector) -> list[float]:
    """Data, results, and how far these may be off where libraries differ."""
    given = [x for group in vector.given for x in group]
    return [*given, *vector.wanted, *vector.slack]


def _hexadecimal(x: float, precise: bool) -> str:
    if math.isnan(x):
        return "(trk_real)NAN"
    if math.isinf(x):
        return "(trk_real)INFINITY" if x > 0 else "-(trk_real)INFINITY"
    return hexadecimal(x) if precise else f"{hexadecimal(x)}f"


def hexadecimal(x: float) -> str:
    """Every bit of a finite number, without the zeros at the end."""
    head, _, power = float.hex(x).partition("p")
    return f"{head.rstrip('0').rstrip('.') if '.' in head else head}p{power}"


def c_program(source: Source) -> str:
    """``SYSTEM_selftest.c``: every vector, once beside and once in place."""
    system, prefix = source.stepper.system, prefix_of(source)
    lines = [*comment([f"Self-test: exit status 0 if every vector agrees {_how(source)}."])]
    lines += [f'#include "{system}.h"', f'#include "{system}_vectors.h"', ""]
    lines += ["#include <stdio.h>", "#include <string.h>", ""]
    lines += [*(_SAME if source.exact else _NEAR), ""]
    for function in source.functions:
        lines += [*_test(source, function), ""]
    tests = [f"{function.program.name}_mismatches()" for function in source.functions]
    total = (COUNT + len(EDGES)) * len(source.functions)
    lines += ["int main(void)", "{", f"    const unsigned long wrong = {' + '.join(tests)};"]
    lines += [f'    printf("{system}: {total} vectors, %lu mismatches\\n", wrong);']
    lines += [f"    (void){prefix}_digest;", "    return wrong == 0UL ? 0 : 1;", "}"]
    return "\n".join(lines) + "\n"


def _how(source: Source) -> str:
    return "bit by bit" if source.exact else "but for two roundings of each sine and cosine"


_SAME = [
    "static unsigned long differ(const trk_real *a, const trk_real *b, size_t count)",
    "{",
    "    unsigned long wrong = 0UL;",
    "    size_t k;",
    "    for (k = 0; k < count; k++) {",
    "        const int unknown = isnan(a[k]) && isnan(b[k]);",
    "        if (!unknown && memcmp(&a[k], &b[k], sizeof a[k]) != 0) {",
    "            wrong++;",
    "        }",
    "    }",
    "    return wrong;",
    "}",
]


_NEAR = [
    "/* allowed: how far each result may be off, 0 where all libraries agree */",
    "static unsigned long differ(const trk_real *a, const trk_real *b, size_t count)",
    "{",
    "    const trk_real *allowed = b + count;",
    "    unsigned long wrong = 0UL;",
    "    size_t k;",
    "    for (k = 0; k < count; k++) {",
    "        const int same = a[k] == b[k] || (isnan(a[k]) && isnan(b[k]));",
    "        const trk_real off = a[k] > b[k] ? a[k] - b[k] : b[k] - a[k];",
    "        if (!same && !(off <= allowed[k])) {",
    "            wrong++;",
    "        }",
    "    }",
    "    return wrong;",
    "}",
]


def _test(source: Source, function: Lowered) -> list[str]:
    prefix, name, output = prefix_of(source), function.program.name, function.program.output
    groups = arguments(source, function)
    sizes = {group: len(source.layout(group)) for group in groups}
    count, state = sum(sizes.values()), len(source.layout(output))
    lines = [f"static unsigned long {name}_mismatches(void)", "{"]
    lines += ["    unsigned long wrong = 0UL;", "    size_t k;"]
    rows = f"sizeof {name}_vectors / sizeof {name}_vectors[0]"
    lines.append(f"    for (k = 0; k < {rows}; k++) {{")
    lines.append(f"        const trk_real *row = {name}_vectors[k];")
    lines += [f"        {prefix}_{group} {group};" for group in groups]
    lines += [f"        {prefix}_{output} next;", f"        trk_real found[{state}];"]
    start = 0
    for group, size in sizes.items():
        lines.append(f"        memcpy(&{group}, row + {start}, {size} * sizeof *row);")
        start += size
    given = ", ".join(f"&{group}" for group in groups)
    wanted = [f"        memcpy(found, &{{0}}, {state} * sizeof *row);"]
    wanted.append(f"        wrong += differ(found, row + {count}, {state});")
    lines += [f"        {prefix}_{name}({given}, &next);"]
    lines += [line.format("next") for line in wanted]
    if output == "state" and output in groups:
        lines += [f"        {prefix}_{name}({given}, &state);"]
        lines += [line.format("state") for line in wanted]
    return [*lines, "    }", "    return wrong;", "}"]


def python_program(source: Source, target: str) -> str:
    """``selftest.py``: the same vectors for the Python targets."""
    head = f'"""Self-test: exit status 0 if every vector agrees {_how(source)}."""'
    lines = [head, "", "import math"]
    lines += ["import sys", "", f"import {source.stepper.system} as generated", ""]
    lines += _CALLS[target]
    lines += ["", "VECTORS = {"]
    for function in source.functions:
        lines.append(f'    "{function.program.name}": [')
        for vector in vectors(source, function):
            groups = ", ".join(f"[{', '.join(map(_text, group))}]" for group in vector.given)
            wanted, slack = (", ".join(map(_text, row)) for row in (vector.wanted, vector.slack))
            allowed = "" if source.exact else f", [{slack}]"
            lines.append(f"        (({groups},), [{wanted}]{allowed}),")
        lines.append("    ],")
    lines += ["}", "", "", *(_COUNT if source.exact else _COUNT_NEAR)]
    return "\n".join(lines) + "\n"


def _text(x: float) -> str:
    if math.isfinite(x):
        return f'float.fromhex("{hexadecimal(x)}")'
    return f'float("{x}")'


_CALLS = {
    "python": ["", "def call(name, groups):", "    return getattr(generated, name)(*groups)", ""],
    "numpy": [
        "import numpy as np",
        "",
        "",
        "def call(name, groups):",
        "    return getattr(generated, name)(*(np.array(group) for group in groups)).tolist()",
        "",
    ],
    "casadi": [
        "",
        "def call(name, groups):",
        "    return getattr(generated, name)()(*groups).full().ravel().tolist()",
        "",
    ],
}

_COUNT = [
    "def same(a, b):",
    "    return a.hex() == b.hex() or (math.isnan(a) and math.isnan(b))",
    "",
    "",
    "wrong, total = 0, 0",
    "for name, rows in VECTORS.items():",
    "    for groups, wanted in rows:",
    "        found = [float(x) for x in call(name, groups)]",
    "        total += 1",
    "        wrong += not all(same(a, b) for a, b in zip(found, wanted, strict=True))",
    'print(f"{generated.__name__}: {total} vectors, {wrong} mismatches")',
    "sys.exit(1 if wrong else 0)",
]

_COUNT_NEAR = [
    "def same(a, b, allowed):",
    "    return a == b or abs(a - b) <= allowed or (math.isnan(a) and math.isnan(b))",
    "",
    "",
    "wrong, total = 0, 0",
    "for name, rows in VECTORS.items():",
    "    for groups, wanted, allowed in rows:",
    "        found = [float(x) for x in call(name, groups)]",
    "        total += 1",
    "        wrong += not all(map(same, found, wanted, allowed))",
    'print(f"{generated.__name__}: {total} vectors, {wrong} mismatches")',
    "sys.exit(1 if wrong else 0)",
]
