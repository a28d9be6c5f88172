"""The files of each target, as text by name."""

from __future__ import annotations

import json
from collections.abc import Mapping
from importlib import import_module

from .c99 import COMPILE, header, implementation
from .casadi import casadi
from .printing import ABI, GENERATOR, Source
from .python import arguments, numpy, python
from .selftest import c_program, python_program, vectors_header
from .stepper import Stepper

TARGETS = ("python", "numpy", "c", "casadi")
STEPPERS = ("bearing_dac", "cyclic_spsa", "variational")
"""Systems whose laws are generated."""


def stepper_of(system: str) -> Stepper:
    """What is generated for a system.

    Parameters
    ----------
    system : str
        One of `STEPPERS`.
    """
    found: Stepper = import_module(f"theory.systems.{system}.stepper").STEPPER
    return found


def files(source: Source, target: str) -> Mapping[str, str]:
    """The files of a folder that is dropped into a project.

    Parameters
    ----------
    source : Source
    target : str
        One of `TARGETS`.

    Returns
    -------
    mapping of str to str
        File name to text; the same input gives the same bytes.
    """
    system = source.stepper.system
    if target == "c":
        made = {
            f"{system}.h": header(source),
            f"{system}.c": implementation(source),
            f"{system}_vectors.h": vectors_header(source),
            f"{system}_selftest.c": c_program(source),
            "Makefile": _makefile(system),
            "CMakeLists.txt": _cmake(system),
        }
    else:
        printed = {"python": python, "numpy": numpy, "casadi": casadi}[target](source)
        made = {f"{system}.py": printed, "selftest.py": python_program(source, target)}
    return made | {
        "manifest.json": _manifest(source, target, [*made]),
        "README.md": _readme(source, target),
    }


def committed(source: Source) -> Mapping[str, str]:
    """The files that the runtime ships, by name within its folder of generated source."""
    system = source.stepper.system
    in_c = files(source, "c")
    kept = (f"{system}.h", f"{system}.c", f"{system}_vectors.h", f"{system}_selftest.c")
    return {
        f"{system}.py": python(source),
        f"{system}_numpy.py": numpy(source),
        **{name: in_c[name] for name in kept},
    }


def _manifest(source: Source, target: str, names: list[str]) -> str:
    content = {
        "system": source.stepper.system,
        "target": target,
        "generator": GENERATOR,
        "abi": ABI,
        "digest": source.digest,
        "coordinates": source.n,
        "constants": {
            name: [[str(x) for x in row] for row in rows] for name, rows in source.given.items()
        },
        "layout": {group: source.layout(group) for group in source.stepper.groups},
        "operations": source.operations,
        "guards": source.stepper.guards,
        "files": sorted(names),
    }
    return json.dumps(content, indent=1, sort_keys=True) + "\n"


def _makefile(system: str) -> str:
    objects = f"{system}.c {system}_selftest.c"
    heads = f"{system}.h {system}_vectors.h"
    return f"""CC ?= cc
CFLAGS ?= -O2
STRICT = {COMPILE} -Werror

test: selftest selftest_float
\t./selftest
\t./selftest_float

selftest: {objects} {heads}
\t$(CC) $(CFLAGS) $(STRICT) -o $@ {objects} -lm

selftest_float: {objects} {heads}
\t$(CC) $(CFLAGS) $(STRICT) -DTRK_REAL_FLOAT -o $@ {objects} -lm

clean:
\trm -f selftest selftest_float

.PHONY: test clean
"""


def _cmake(system: str) -> str:
    return f"""cmake_minimum_required(VERSION 3.10)
project({system} C)
enable_testing()
add_compile_options(-ffp-contract=off)
add_library(trk_{system} STATIC {system}.c)
set_target_properties(trk_{system} PROPERTIES C_STANDARD 99)
target_include_directories(trk_{system} PUBLIC ${{CMAKE_CURRENT_SOURCE_DIR}})
add_executable(selftest {system}_selftest.c)
target_link_libraries(selftest trk_{system} m)
add_test(NAME selftest COMMAND selftest)
"""


def _readme(source: Source, target: str) -> str:
    system = source.stepper.system
    test = "make test" if target == "c" else "python selftest.py"
    constants = ", ".join(source.given) or "none"
    rows = [
        f"| {group} | {slot.name} | {slot.unit} | {slot.meaning} |"
        for group in source.stepper.groups
        for slot in source.slots(group)
    ]
    calls = {
        "c": f"`trk_{system}_init`, then `trk_{system}_step` at each sample; `trk_{system}_run` "
        "takes many samples at once. Compile with `-ffp-contract=off` for equal bits everywhere; "
        "`-DTRK_REAL_FLOAT` computes in single precision.",
        "python": "`init`, then `step` at each sample: flat sequences of floats in, a tuple out.",
        "numpy": "`init`, then `step` at each sample: the first axis is the component, all other "
        "axes are lanes.",
        "casadi": "Each function returns a `casadi.Function` of the groups below.",
    }
    functions = [
        f"| `{f.program.name}({', '.join(arguments(source, f))})` | {f.program.output} | "
        f"{f.program.about} |"
        for f in source.functions
    ]
    lines = [f"# {source.stepper.title}", "", f"{source.n} coordinates; constants: {constants}."]
    lines += ["", calls[target], "", f"`{test}` runs the self-test.", ""]
    lines += ["| function of groups | result | what it is |", "| --- | --- | --- |", *functions, ""]
    lines += ["| group | name | unit | meaning |", "| --- | --- | --- | --- |", *rows, ""]
    lines += [
        "Matrices are kept as upper triangles by rows. Assumed, so that no division fails:",
        "",
    ]
    lines += [f"- {guard}" for guard in source.stepper.guards]
    return "\n".join(lines) + "\n"
