"""Kinds of inputs: how what a user gave becomes exact data, and data become values.

A kind is an entry of `KINDS`: one function that reads what was given into exact data, and one that
fits these data to the rest of the question (the size of the other matrices, the nodes of the
network).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from sensortrack.errors import InputError

from . import input_networks, input_numbers
from .input_numbers import Setting
from .input_words import shown


@dataclass(frozen=True)
class Kind:
    """How one kind of input is read.

    Parameters
    ----------
    form : str
        What the user has to write, for lists and errors.
    read : callable
        ``read(name, given)`` returns exact data in the shape given.
    fit : callable
        ``fit(name, data, setting)`` returns the value that the quantity gets.
    """

    form: str
    read: Callable[[str, object], Any]
    fit: Callable[[str, Any, Setting], Any]


def _word(name: str, given: object) -> str:
    if not isinstance(given, str):
        raise InputError(name, shown(given), "a word is needed")
    return given


def _as_read(_: str, data: Any, __: Setting) -> Any:
    return data


KINDS: Mapping[str, Kind] = {
    "number": Kind('a number (0.1, "1/3")', input_numbers.number, _as_read),
    "matrix": Kind(
        "a number or a list of rows", input_numbers.matrix, input_numbers.multiple_of_identity
    ),
    "matrices": Kind("a list of numbers or of lists of rows", input_numbers.matrices, _as_read),
    "planar matrix": Kind(
        "a number or two rows of two numbers", input_numbers.matrix, input_numbers.planar
    ),
    "vector": Kind(
        "a number or a list of numbers", input_numbers.vector, input_numbers.one_a_coordinate
    ),
    "diagonal": Kind("a number or a list of numbers", input_numbers.vector, _as_read),
    "list": Kind("a number or a list of numbers", input_numbers.vector, _as_read),
    "word": Kind("a word", _word, _as_read),
    "point": Kind("a list of two numbers", input_numbers.point, _as_read),
    "points": Kind("a list of lists of two numbers", input_numbers.points, _as_read),
    "blocks": Kind("a list of lists of whole numbers", input_numbers.blocks, _as_read),
    "links": Kind("lists of links [a, b]", input_networks.links, input_networks.links_of_graph),
    "node numbers": Kind(
        "a number, a list or {node: number}",
        input_networks.node_numbers,
        input_networks.one_a_node,
    ),
}
