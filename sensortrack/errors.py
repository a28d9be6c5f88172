"""Errors that say which argument is wrong, what was found and what is needed."""

from __future__ import annotations


class SensorTrackError(Exception):
    """Base of every error that SensorTrack raises on purpose."""


class InputError(SensorTrackError):
    """An argument is unusable.

    Parameters
    ----------
    name : str
        The input's name as the user knows it (``graph``, ``M``, ``--params``).
    found : str
        What was found.
    needed : str
        What is needed instead.
    cure : str, optional
        How to mend it: one or more further lines.
    """

    def __init__(self, name: str, found: str, needed: str, cure: str = "") -> None:
        self.name = name
        self.found = found
        self.needed = needed
        self.cure = cure
        super().__init__(f"{name}: {found}; {needed}" + (f"\n{cure}" if cure else ""))


class MissingExtra(SensorTrackError):
    """A package that belongs to an optional extra is not installed.

    Parameters
    ----------
    package : str
        The package that could not be imported.
    extra : str
        The extra of this distribution that brings it.
    """

    def __init__(self, package: str, extra: str) -> None:
        self.package = package
        self.extra = extra
        super().__init__(f"{package}: not installed; pip install 'sensortrack[{extra}]' brings it")
