"""The BLAS that SciPy was built with, for C kernels."""

from __future__ import annotations

import ctypes
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from typing import Any


@cache
def blas() -> tuple[ctypes.c_void_p, ctypes.c_void_p] | None:
    """Addresses of dgemm and dtrsm in the BLAS that SciPy was built with."""
    try:
        from scipy.linalg import cython_blas
    except ImportError:
        return None
    name, address = ctypes.pythonapi.PyCapsule_GetName, ctypes.pythonapi.PyCapsule_GetPointer
    name.restype, name.argtypes = ctypes.c_char_p, [ctypes.py_object]
    address.restype, address.argtypes = ctypes.c_void_p, [ctypes.py_object, ctypes.c_char_p]
    capsules = [cython_blas.__pyx_capi__[key] for key in ("dgemm", "dtrsm")]
    if any(b"int *" not in name(capsule) for capsule in capsules):  # 64-bit integers
        return None
    gemm, trsm = (ctypes.c_void_p(address(capsule, name(capsule))) for capsule in capsules)
    return gemm, trsm


@contextmanager
def one_thread() -> Iterator[None]:
    """Let the BLAS work in one thread: on the small panels of sparse factors more only wait."""
    found = _threads()
    if found is None:
        yield
        return
    read, write = found
    before = read()
    write(1)
    try:
        yield
    finally:
        write(before)


@cache
def _threads() -> tuple[Any, Any] | None:
    """OpenBLAS's functions that tell and set the number of threads."""
    try:
        from scipy.linalg import cython_blas

        library = ctypes.CDLL(cython_blas.__file__)
    except (ImportError, OSError):
        return None
    for prefix in ("scipy_openblas", "openblas"):
        read = getattr(library, f"{prefix}_get_num_threads", None)
        write = getattr(library, f"{prefix}_set_num_threads", None)
        if read is not None and write is not None:
            return read, write
    return None
