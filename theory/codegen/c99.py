"""Printer for C99: structs of one real type, one function a program, no memory of its own."""

from __future__ import annotations

from fractions import Fraction

from .lower import Lowered, entries
from .printing import ABI, Language, Source, heading, text
from .python import arguments

COMPILE = "-std=c99 -Wall -Wextra -Wconversion -Wdouble-promotion -pedantic -ffp-contract=off"


def header(source: Source) -> str:
    """Types, prototypes, and what they assume."""
    system, prefix = source.stepper.system, prefix_of(source)
    guard = f"{prefix.upper()}_H"
    lines = [*comment([*heading(source), "", f"compile with {COMPILE}"]), ""]
    lines += [f"#ifndef {guard}", f"#define {guard}", "", "#include <stddef.h>", ""]
    single, double = (
        [f"#define TRK_{name.upper()} {name}{ending}" for name in _mathematics(source)]
        for ending in ("f", "")
    )
    lines += ["#ifdef TRK_REAL_FLOAT", "typedef float trk_real;", "#define TRK_R(x) x##f"]
    lines += [*single, "#else", "typedef double trk_real;", "#define TRK_R(x) x", *double]
    lines += ["#endif", ""]
    lines += [f"#define {prefix.upper()}_ABI {ABI}", f"#define {prefix.upper()}_N {source.n}", ""]
    for group in source.stepper.groups:
        lines += _struct(source, group)
    lines += ["#ifdef __cplusplus", 'extern "C" {', "#endif", ""]
    for function in source.functions:
        inside = "; the result may be the state that went in"
        ending = inside if function.program.output == "state" else ""
        lines += comment([f"{function.program.about}{ending}."])
        lines += [f"{_prototype(source, function)};", ""]
    lines += comment(["Many steps; if out is not a null pointer, each state is written to it."])
    lines += [f"{_run_prototype(source)};", ""]
    lines += comment([f"SHA-256 of the statements: tells two versions of {system} apart."])
    lines += [f"const char *{prefix}_digest(void);", ""]
    lines += ["#ifdef __cplusplus", "}", "#endif", "", "#endif"]
    return "\n".join(lines) + "\n"


def implementation(source: Source) -> str:
    """The functions."""
    prefix = prefix_of(source)
    lines = [f'#include "{source.stepper.system}.h"', ""]
    lines += ["#include <math.h>", ""] if _mathematics(source) else []
    lines += [f"const char *{prefix}_digest(void)", "{", f'    return "{source.digest}";', "}", ""]
    for function in source.functions:
        lines += [*_function(source, function), ""]
    lines += _run(source)
    return "\n".join(lines) + "\n"


def prefix_of(source: Source) -> str:
    """What all names of a system begin with."""
    return f"trk_{source.stepper.system}"


def literal(value: Fraction) -> str:
    """A number in the real type."""
    number = repr(abs(float(value)))
    number = number if {".", "e"} & {*number} else f"{number}.0"
    number = number if "." in number else number.replace("e", ".0e")
    return f"TRK_R({number})" if value >= 0 else f"(-TRK_R({number}))"


C = Language(
    literal,
    {
        **{name: f"TRK_{name.upper()}({{0}})" for name in ("sin", "cos", "sqrt")},
        "sgn": "(trk_real)(({0} > {1}) - ({0} < {1}))",
        "select": "(({0} > {1}) ? {2} : {3})",
    },
)


def _mathematics(source: Source) -> list[str]:
    """Functions of the C library that are called."""
    return sorted({"sin", "cos", "sqrt"} & source.calls)


def comment(lines: list[str]) -> list[str]:
    """A block comment."""
    if len(lines) == 1:
        return [f"/* {lines[0]} */"]
    return ["/*", *(f" * {line}".rstrip() for line in lines), " */"]


def _struct(source: Source, group: str) -> list[str]:
    slots = source.slots(group)
    if not slots:
        return []
    lines = ["typedef struct {"]
    for slot in slots:
        count = len(entries(slot, source.n))
        size = f"[{count}]" if slot.shape else ""
        lines.append(f"    trk_real {slot.name}{size}; /* {slot.unit}: {slot.meaning} */")
    return [*lines, f"}} {prefix_of(source)}_{group};", ""]


def _prototype(source: Source, function: Lowered) -> str:
    prefix = prefix_of(source)
    given = [f"const {prefix}_{group} *{group}" for group in arguments(source, function)]
    name = f"{prefix}_{function.program.name}"
    return f"void {name}({', '.join([*given, f'{prefix}_{function.program.output} *next'])})"


def _run_prototype(source: Source) -> str:
    prefix = prefix_of(source)
    context = [f"const {prefix}_context *context"] if source.layout("context") else []
    rest = [
        f"{prefix}_state *state",
        f"const {prefix}_input *input",
        "size_t count",
        f"{prefix}_state *out",
    ]
    return f"void {prefix}_run({', '.join(context + rest)})"


def _function(source: Source, function: Lowered) -> list[str]:
    lines = [_prototype(source, function), "{"]
    used = _used(function)
    for group in arguments(source, function):
        read = [(name, place) for name, place in _places(source, group) if name in used]
        lines += [f"    const trk_real {name} = {group}->{place};" for name, place in read]
        lines += [] if read else [f"    (void){group};"]
    for line in function.lines:
        lines += ["", f"    /* {line.heading} */"] if line.heading else []
        value = text(function, line.expr, C, own=True)
        lines.append(f"    const trk_real {line.name} = {value};")
    lines.append("")
    places = _places(source, function.program.output)
    for (_, place), result in zip(places, function.results, strict=True):
        lines.append(f"    next->{place} = {text(function, result, C)};")
    return [*lines, "}"]


def _places(source: Source, group: str) -> list[tuple[str, str]]:
    """Name of each number and where it lies in its struct."""
    return [
        (name, f"{slot.name}[{k}]" if slot.shape else slot.name)
        for slot in source.slots(group)
        for k, name in enumerate(entries(slot, source.n))
    ]


def _used(function: Lowered) -> set[str]:
    """Names that the lines and results read."""
    found: set[str] = set()
    stack = [line.expr for line in function.lines] + list(function.results)
    while stack:
        part = stack.pop()
        found |= {part.name} if part.op == "name" else set()
        stack.extend(part.args)
    return found


def _run(source: Source) -> list[str]:
    prefix = prefix_of(source)
    context = "context, " if source.layout("context") else ""
    return [
        _run_prototype(source),
        "{",
        "    size_t k;",
        "    for (k = 0; k < count; k++) {",
        f"        {prefix}_step({context}state, &input[k], state);",
        "        if (out != NULL) {",
        "            out[k] = *state;",
        "        }",
        "    }",
        "}",
    ]
