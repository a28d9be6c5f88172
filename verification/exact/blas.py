"""The BLAS that SciPy was built with, for C kernels."""

from __future__ import annotations

import ctypes
from functools import cache


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
