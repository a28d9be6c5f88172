"""Compile a C source of this folder once, keep the library in the user's cache, and load it.

The library's name carries a digest of the source, the flags and the machine, so that an edited
source is compiled anew and an unchanged one is not. Whatever goes wrong on the way (no compiler,
no cache folder, a compiler that cannot read the source) leaves a kernel without library whose
`reason` says why; callers then take their road in Python.
"""

from __future__ import annotations

import ctypes
import hashlib
import os
import platform
import shlex
import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from functools import cache
from pathlib import Path

FLAGS = ("-std=c99", "-O2", "-shared", "-fPIC", "-ffp-contract=off")
NATIVE = ("-O3", "-march=native")
COMPILE_SECONDS = 120


@dataclass(frozen=True)
class Kernel:
    """A compiled C source, or the reason why there is none.

    Parameters
    ----------
    name : str
        Name of the source without its ending.
    library : ctypes.CDLL or None
        The loaded library.
    reason : str
        Why there is no library; empty if there is one.
    """

    name: str
    library: ctypes.CDLL | None
    reason: str = ""


def kernel(name: str, folder: Path = Path(__file__).parent, native: bool = False) -> Kernel:
    """Compile and load ``NAME.c`` of a folder.

    Parameters
    ----------
    name : str
        Name of the source without its ending.
    folder : Path, optional
        Where the source lies; the folder of this module by default.
    native : bool, optional
        Use all that this very processor can do. The library's name then tells processors apart,
        so that a cache which several machines share serves each of them. Contraction stays off.

    Returns
    -------
    Kernel
        Without library if ``SENSORTRACK_NO_COMPILER`` is 1 or the source cannot be compiled here.
    """
    if os.environ.get("SENSORTRACK_NO_COMPILER") == "1":
        return Kernel(name, None, "SENSORTRACK_NO_COMPILER is 1")
    settings = os.environ.get("CC", "cc"), os.environ.get("XDG_CACHE_HOME", "")
    return _kernel(name, folder, native, *settings)


def cache_folder() -> Path:
    """Folder of compiled libraries: below ``XDG_CACHE_HOME``, else ``~/.cache``."""
    base = os.environ.get("XDG_CACHE_HOME", "")
    parent = Path(base) if Path(base).is_absolute() else Path("~/.cache").expanduser()
    return parent / "sensortrack" / "kernels"


@cache
def _processor() -> str:
    """What this processor can do, as the system lists it; empty where it does not say."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError):
        return ""
    return next((line for line in lines if line.startswith(("flags", "Features"))), "")


@cache
def _kernel(name: str, folder: Path, native: bool, compiler: str, _cache_home: str) -> Kernel:
    """Kept for each setting, since callers ask before every call into C."""
    source = folder / f"{name}.c"
    if native and _processor():
        found = _loaded(source, compiler, NATIVE)
        if found.library is not None:
            return found
    return _loaded(source, compiler, ())


def _loaded(source: Path, compiler: str, more: tuple[str, ...]) -> Kernel:
    name = source.stem
    try:
        built = _built(source, shlex.split(compiler), cache_folder(), more)
        return Kernel(name, ctypes.CDLL(str(built)))
    except (OSError, ValueError, subprocess.SubprocessError) as error:
        detail = error.stderr if isinstance(error, subprocess.CalledProcessError) else ""
        return Kernel(name, None, f"{name}.c: {error} {detail}".strip())


def _built(source: Path, compiler: list[str], folder: Path, more: tuple[str, ...]) -> Path:
    """Path of the library, compiled if it is not in the cache."""
    flags = (*FLAGS, *more)
    keys = (*compiler, *flags, platform.system(), platform.machine(), _processor() if more else "")
    digest = hashlib.sha256(source.read_bytes() + "\0".join(keys).encode()).hexdigest()
    target = folder / f"{source.stem}-{digest[:24]}.so"
    if not target.exists():
        _compile([*compiler, *flags], source, target)
    return target


def _compile(compiler: list[str], source: Path, target: Path) -> None:
    """Compile beside the target and rename, so that nobody ever loads half a library."""
    if not compiler or shutil.which(compiler[0]) is None:
        raise FileNotFoundError(f"no C compiler {' '.join(compiler)!r}")
    target.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    handle, unfinished = tempfile.mkstemp(suffix=".so", dir=target.parent)
    os.close(handle)
    command = [*compiler, "-o", unfinished, str(source), "-lm"]
    try:
        subprocess.run(command, check=True, capture_output=True, text=True, timeout=COMPILE_SECONDS)
        Path(unfinished).replace(target)
    finally:
        Path(unfinished).unlink(missing_ok=True)
