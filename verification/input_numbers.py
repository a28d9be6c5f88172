"""Inputs that are numbers, matrices, points and places: from what was given to exact data."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from sensortrack.errors import InputError

from .exact.rationals import parse_exact
from .input_words import shown

if TYPE_CHECKING:
    from sensortrack.networks import Network

Rows = tuple[tuple[Fraction, ...], ...]


@dataclass(frozen=True)
class Setting:
    """What the other inputs of the same question say.

    Parameters
    ----------
    network : Network or None
        The network of ``--graph``.
    size : int
        Rows of the question's matrices and diagonals; where all of them are given as numbers, that
        of its vectors, where there are none that of its lists, else 1.
    """

    network: Network | None
    size: int


def number(name: str, given: object) -> Fraction:
    """A rational, from a JSON number or its text."""
    if isinstance(given, (bool, list, dict)) or given is None:
        raise InputError(name, shown(given), "a number is needed")
    if isinstance(given, str) and not given.strip():
        raise InputError(name, "an empty text", "a number is needed")
    if isinstance(given, str) and given.lstrip()[0] in "[{":
        raise InputError(name, f"{shown(given)}, which is no JSON", "JSON is needed")
    return parse_exact(given, name)


def entry(name: str, where: str, given: object) -> Fraction:
    """One number of a list; the error says where it stands."""
    try:
        return number(name, given)
    except InputError as error:
        raise InputError(name, f"{where} is {error.found}", error.needed) from None


def matrix(name: str, given: object) -> Fraction | Rows:
    """A square matrix by rows, or the number that stands for one."""
    if not isinstance(given, list):
        return number(name, given)
    needed = "a number or a square list of rows is needed"
    if not given:
        raise InputError(name, "an empty list", needed)
    for i, row in enumerate(given, start=1):
        if not isinstance(row, list):
            raise InputError(name, f"row {i} is {shown(row)}", needed)
        if len(row) != len(given[0]):
            found = f"row {i} has {len(row)} numbers, row 1 has {len(given[0])}"
            raise InputError(name, found, needed)
    if len(given) != len(given[0]):
        raise InputError(name, f"{len(given)} x {len(given[0])}", needed)
    return tuple(
        tuple(entry(name, f"entry {i},{j}", value) for j, value in enumerate(row, start=1))
        for i, row in enumerate(given, start=1)
    )


def matrices(name: str, given: object) -> tuple[Rows, ...]:
    """A list of matrices; a number is one of one row."""
    if not isinstance(given, list) or not given:
        raise InputError(name, shown(given), "a list of matrices is needed")
    found = []
    for k, rows in enumerate(given, start=1):
        try:
            read = matrix(name, rows)
        except InputError as error:
            raise InputError(name, f"matrix {k}: {error.found}", error.needed) from None
        found.append(read if isinstance(read, tuple) else ((read,),))
    return tuple(found)


def multiple_of_identity(_: str, data: Fraction | Rows, setting: Setting) -> Rows:
    """A number as that multiple of the identity."""
    if isinstance(data, tuple):
        return data
    size, zero = range(setting.size), Fraction(0)
    return tuple(tuple(data if i == j else zero for j in size) for i in size)


def planar(name: str, data: Fraction | Rows, _: Setting) -> Rows:
    """A matrix of two coordinates; a number as that multiple of the identity."""
    if isinstance(data, tuple) and len(data) != 2:
        raise InputError(name, f"{len(data)} x {len(data)}", "two coordinates, 2 x 2, are needed")
    return multiple_of_identity(name, data, Setting(None, 2))


def vector(name: str, given: object) -> tuple[Fraction, ...]:
    """A list of numbers; a number is one of one entry."""
    if not isinstance(given, list):
        return (number(name, given),)
    if not given:
        raise InputError(name, "an empty list", "a number for each coordinate is needed")
    return tuple(entry(name, f"number {i}", value) for i, value in enumerate(given, start=1))


def one_a_coordinate(
    name: str, data: tuple[Fraction, ...], setting: Setting
) -> tuple[Fraction, ...]:
    """One number a coordinate."""
    if len(data) != setting.size:
        needed = f"{setting.size} are needed, one a coordinate of the matrices"
        raise InputError(name, f"{len(data)} number{'s' if len(data) > 1 else ''}", needed)
    return data


def point(name: str, given: object) -> tuple[Fraction, ...]:
    """Two numbers."""
    if not isinstance(given, list) or len(given) != 2:
        raise InputError(name, shown(given), "a list of two numbers is needed")
    return tuple(entry(name, f"number {i}", value) for i, value in enumerate(given, start=1))


def points(name: str, given: object) -> tuple[tuple[Fraction, ...], ...]:
    """A list of points."""
    if not isinstance(given, list) or not given:
        raise InputError(name, shown(given), "a list of points of two numbers is needed")
    return tuple(_point_of(name, i, value) for i, value in enumerate(given, start=1))


def _point_of(name: str, place: int, given: object) -> tuple[Fraction, ...]:
    """One point of a list; the error says which."""
    try:
        return point(name, given)
    except InputError as error:
        raise InputError(name, f"point {place}: {error.found}", error.needed) from None


def blocks(name: str, given: object) -> tuple[tuple[int, ...], ...]:
    """Lists of places, counted from 0."""
    needed = "lists of whole numbers are needed, as in [[0, 1], [2, 3]]"
    if not isinstance(given, list) or not given:
        raise InputError(name, shown(given), needed)
    for k, places in enumerate(given, start=1):
        if not isinstance(places, list) or not places:
            raise InputError(name, f"list {k} is {shown(places)}", needed)
    return tuple(tuple(_place_of(name, k, x) for x in places) for k, places in enumerate(given, 1))


def _place_of(name: str, k: int, given: object) -> int:
    """One place of list k."""
    found = entry(name, f"a number of list {k}", given)
    if found.denominator != 1 or found < 0:
        raise InputError(name, f"list {k} has {found}", "whole numbers from 0 on are needed")
    return int(found)
