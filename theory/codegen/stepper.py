"""What is generated for a system: which laws, in which order, on which data."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from ..expressions import Tree


@dataclass(frozen=True)
class Slot:
    """One named piece of data: a scalar, a vector, or a symmetric matrix kept as a triangle.

    Parameters
    ----------
    name : str
        As in the laws, or what it stands for there.
    shape : tuple of str or int
        ``()``, ``("n",)`` or ``("n", "n")``; n is chosen when source is generated.
    unit : str
    meaning : str
    drawn : (float, float), optional
        Ends of what test vectors take; by default what suits gains and their states.
    """

    name: str
    shape: tuple[str, ...]
    unit: str
    meaning: str
    drawn: tuple[float, float] | None = None


@dataclass(frozen=True)
class Assignment:
    """One law as a computation.

    Parameters
    ----------
    target : str
        What is computed; ``next(x)`` is the value one sample later.
    tree : tuple
        The right side. Beside the language of laws, ``("entry", tree, i, j)`` is one number of a
        matrix, ``("rows", (tree, tree), ...)`` a matrix of numbers, and ``("direction", tree)`` a
        vector over its length, 0 for the vector 0.
    source : str
        Equation number, for the comment line.
    factor : tuple or None
        If the law is ``factor * target = tree``: the symmetric positive definite matrix, which is
        factored without square roots.
    guard : str
        Slot with the determinant above which a factor of two coordinates counts as invertible.
        At or below it the target is 0, and ``status(target)`` is 0 instead of 1.
    """

    target: str
    tree: Tree
    source: str
    factor: Tree | None = None
    guard: str = ""


@dataclass(frozen=True)
class Program:
    """One function: groups of data in, some of them out.

    Parameters
    ----------
    name : str
    groups : tuple of str
        Argument groups, in order.
    assignments : tuple of Assignment
    results : mapping of str to str
        Slot of the resulting group to the target that it becomes.
    about : str
        One line for the source.
    output : str, optional
        The group that comes out; the state by default.
    """

    name: str
    groups: tuple[str, ...]
    assignments: tuple[Assignment, ...]
    results: Mapping[str, str]
    about: str
    output: str = "state"


@dataclass(frozen=True)
class Stepper:
    """Everything that is generated for one system.

    Parameters
    ----------
    system : str
    title : str
    groups : mapping of str to tuple of Slot
        ``context`` (gains and step), ``state``, ``input`` (at the new sample), ``start``.
    sums : mapping of str to str
        Sums over the sensors, by the text of their tree, to the input that stands for them.
    programs : tuple of Program
    guards : tuple of str
        What is assumed so that no division fails, with the reason.
    coordinates : int
        The n of the committed source.
    unknown : str, optional
        What becomes of numbers that are not known.
    """

    system: str
    title: str
    groups: Mapping[str, tuple[Slot, ...]]
    sums: Mapping[str, str]
    programs: tuple[Program, ...]
    guards: tuple[str, ...]
    coordinates: int
    unknown: str = "A NaN in the data reaches every result that depends on it."
