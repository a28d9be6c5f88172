"""How arrays are handed to functions of the C sources."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
from numpy.typing import NDArray


def pointer(array: NDArray[Any]) -> ctypes.c_void_p:
    """Address of a contiguous array for a C function; it keeps the array alive."""
    assert array.flags.c_contiguous
    return array.ctypes.data_as(ctypes.c_void_p)


def call(function: Any, *arguments: Any, returns: Any = ctypes.c_int64) -> Any:
    """Call a function of a kernel with whole numbers and contiguous arrays.

    Parameters
    ----------
    function : ctypes function
    *arguments : int or ndarray
        Whole numbers become 64-bit ones.
    returns : ctypes type or None, optional
    """
    function.restype = returns
    return function(*map(_passed, arguments))


def _passed(argument: Any) -> Any:
    return pointer(argument) if isinstance(argument, np.ndarray) else ctypes.c_int64(argument)
