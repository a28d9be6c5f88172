"""Generated steppers on flat arrays: in C where a compiler is, else on Python floats."""

from __future__ import annotations

import ctypes
import inspect
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from pathlib import Path
from types import ModuleType

import numpy as np
from numpy.typing import NDArray

from sensortrack.errors import InputError

from .build import kernel

Floats = NDArray[np.float64]
CROSSING = 400
"""Operations up to which Python floats are quicker than a call into C with four arrays."""
GENERATED = Path(__file__).parents[1] / "generated"


@dataclass(frozen=True)
class Stepper:
    """The generated functions of one system; both roads give the same bits.

    Parameters
    ----------
    module : ModuleType
        The source on Python floats, with layouts and digest.
    library : ctypes.CDLL or None
        The compiled source.
    reason : str
        Why there is no library; empty if there is one.
    """

    module: ModuleType
    library: ctypes.CDLL | None
    reason: str = ""

    @property
    def digest(self) -> str:
        """SHA-256 of the statements."""
        return str(self.module.DIGEST)

    def call(self, name: str, *groups: Sequence[float] | Floats) -> Floats:
        """Call one function.

        Parameters
        ----------
        name : str
            ``step``, ``init``, ...
        *groups : array of float
            The argument groups in order, each flat in the order of its layout.

        Returns
        -------
        ndarray
            The resulting state, or what else the function is for, flat.

        Raises
        ------
        InputError
            A group has not as many numbers as its layout.
        """
        self._fit(name, groups)
        if self.library is None or self.module.OPERATIONS[name] <= CROSSING:
            numbers = [np.asarray(group, dtype=np.float64).tolist() for group in groups]
            return np.array(getattr(self.module, name)(*numbers), dtype=np.float64)
        return self.compiled(name, *groups)

    def compiled(self, name: str, *groups: Sequence[float] | Floats) -> Floats:
        """Call one function of the compiled source; there must be a library.

        Parameters and result are those of `call`, which checks the sizes.
        """
        arrays = [np.ascontiguousarray(group, dtype=np.float64) for group in groups]
        group = getattr(self.module, "OUTPUTS", {}).get(name, "state")
        found = np.empty(len(getattr(self.module, group.upper())))
        function = self._function(name)
        function(*(ctypes.c_void_p(array.ctypes.data) for array in (*arrays, found)))
        return found

    def run(self, context: Floats, state: Floats, inputs: Floats) -> Floats:
        """Many steps: the states after each.

        Parameters
        ----------
        context, state : ndarray
            Flat.
        inputs : ndarray
            Samples by the numbers of one input.

        Returns
        -------
        ndarray
            Samples by the numbers of one state.

        Raises
        ------
        InputError
            A group, or a row of inputs, has not as many numbers as its layout.
        """
        blank = np.empty(len(self.module.INPUT))
        self._fit("step", (context, state, inputs[0] if len(inputs) else blank))
        if self.library is None:
            step, rows = self.module.step, []
            gains, now = context.tolist(), tuple(state.tolist())
            for row in inputs.tolist():
                now = step(gains, now, row)
                rows.append(now)
            return np.array(rows).reshape(len(inputs), len(state))
        given = np.ascontiguousarray(inputs, dtype=np.float64)
        work, found = state.astype(np.float64), np.empty((len(given), len(state)))
        gains = np.ascontiguousarray(context, dtype=np.float64)
        addresses = [array.ctypes.data for array in (gains, work, given)]
        self._function("run")(*addresses, ctypes.c_size_t(len(given)), found.ctypes.data)
        return found

    def _fit(self, name: str, groups: Sequence[Sequence[float] | Floats]) -> None:
        layout = _layout(self.module, name)
        if len(groups) != len(layout):
            needed = f"{len(layout)} are needed: {', '.join(group for group, _ in layout)}"
            raise InputError(name, f"{len(groups)} groups", needed)
        for (group, needed_size), given in zip(layout, groups, strict=True):
            if len(given) != needed_size:
                raise InputError(group, f"{len(given)} numbers", f"{needed_size} are needed")

    def _function(self, name: str) -> ctypes._NamedFuncPointer:
        assert self.library is not None
        return _prepared(self.library, f"trk_{self.module.SYSTEM}_{name}", name == "run")


@cache
def stepper(system: str) -> Stepper:
    """Load the generated functions of a system.

    Parameters
    ----------
    system : str
        One that has generated source.

    Returns
    -------
    Stepper
        On Python floats where the source cannot be compiled or is of another version.
    """
    module = import_module(f"sensortrack.generated.{system}")
    found = kernel(system, GENERATED)
    if found.library is None:
        return Stepper(module, None, found.reason)
    digest = getattr(found.library, f"trk_{system}_digest")
    digest.restype = ctypes.c_char_p
    if digest().decode() != module.DIGEST:
        return Stepper(module, None, f"{system}.c and {system}.py are of different versions")
    return Stepper(module, found.library)


@cache
def _layout(module: ModuleType, name: str) -> tuple[tuple[str, int], ...]:
    """Argument groups of a function, each with its size."""
    groups = [text.rstrip("_") for text in inspect.signature(getattr(module, name)).parameters]
    return tuple((group, len(getattr(module, group.upper()))) for group in groups)


@cache
def _prepared(library: ctypes.CDLL, name: str, many: bool) -> ctypes._NamedFuncPointer:
    function: ctypes._NamedFuncPointer = getattr(library, name)
    function.restype = None
    if many:
        address = ctypes.c_void_p
        function.argtypes = [address, address, address, ctypes.c_size_t, address]
    return function
