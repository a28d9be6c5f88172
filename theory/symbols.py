"""What systems are made of: signals, parameters, laws and guards."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from .expressions import Tree, calls, parse
from .kinds import FormulaError, Size

FRAMES: Mapping[str, str] = {
    "": "no frame: the same for every observer",
    "inertial": "components along the axes of one inertial frame",
    "sensors": "one entry for each sensor",
}

DOMAINS: Mapping[str, str] = {
    "positive": "a number above 0",
    "nonnegative": "a number of at least 0",
    "symmetric positive definite": "equal to its transpose, x'Ax > 0 for x not 0",
    "weights": "positive numbers, one a sensor, of sum 1",
    "incidence": "one column a link, -1 at its tail and 1 at its head, of a connected graph",
    "Laplacian": "degrees on the diagonal, -1 for each link, of a connected graph",
    "ones": "every entry is 1",
    "constant": "known numbers, the same at all times",
}


def need(condition: bool, whose: str, message: str) -> None:
    """Raise ValueError with the name of what is malformed, unless the condition holds."""
    if not condition:
        raise ValueError(f"{whose}: {message}")


def _is_size(size: object) -> bool:
    return size.isidentifier() if isinstance(size, str) else type(size) is int and size > 0


def _check_symbol(name: str, shape: tuple[Size, ...], frame: str, meaning: str) -> None:
    need(name.isidentifier(), repr(name), "an identifier is needed as a name")
    good = type(shape) is tuple and len(shape) <= 2 and all(map(_is_size, shape))
    need(good, name, f"shape is {shape!r}; a tuple of up to two sizes is needed")
    need(frame in FRAMES, name, f"frame is {frame!r}; one of {[*FRAMES]} is needed")
    need(bool(meaning.strip()), name, "a meaning is needed")


@dataclass(frozen=True)
class Signal:
    """A quantity that changes with time.

    Parameters
    ----------
    name : str
        Identifier, as used in laws.
    shape : tuple of (int or str)
        ``()`` for a scalar, ``(3,)`` for a vector, ``("n", "m")`` for a matrix.
    unit : str
        Like ``"m/s"``; ``"1"`` for pure numbers.
    frame : str
        A key of `FRAMES`.
    meaning : str
        In our words.

    Raises
    ------
    ValueError
        A field is malformed.
    """

    name: str
    shape: tuple[Size, ...]
    unit: str
    frame: str
    meaning: str

    def __post_init__(self) -> None:
        _check_symbol(self.name, self.shape, self.frame, self.meaning)


@dataclass(frozen=True)
class Parameter:
    """A quantity that is chosen or given once.

    Parameters
    ----------
    name, shape, unit
        As in `Signal`.
    domain : str
        A key of `DOMAINS`.
    meaning : str
        In our words.

    Raises
    ------
    ValueError
        A field is malformed.
    """

    name: str
    shape: tuple[Size, ...]
    unit: str
    domain: str
    meaning: str

    def __post_init__(self) -> None:
        _check_symbol(self.name, self.shape, "", self.meaning)
        found = f"domain is {self.domain!r}"
        need(self.domain in DOMAINS, self.name, f"{found}; one of {[*DOMAINS]} is needed")


@dataclass(frozen=True)
class Law:
    """An equation that the symbols obey.

    Parameters
    ----------
    left, right : str
        Formulas in the language of `theory.expressions`.
    equation : str
        Number in the paper, or where it stands.

    Raises
    ------
    FormulaError
        A side cannot be read, or the law mixes derivatives and samples.
    """

    left: str
    right: str
    equation: str

    def __post_init__(self) -> None:
        mixed = "d" in calls(self.tree) and not calls(self.tree).isdisjoint({"next", "previous"})
        if mixed:
            raise FormulaError(f"{self.equation}: continuous and discrete time in one law")

    @property
    def tree(self) -> Tree:
        """Both sides as one comparison."""
        return ("==", parse(self.left), parse(self.right))


@dataclass(frozen=True)
class Guard:
    """A condition without which the laws have no meaning or no answer.

    Parameters
    ----------
    name : str
        Identifier.
    condition : str
        A comparison in the language of `theory.expressions`.
    meaning : str
        What goes wrong without it, in our words.

    Raises
    ------
    ValueError
        The name is no identifier, or the condition cannot be read.
    """

    name: str
    condition: str
    meaning: str

    def __post_init__(self) -> None:
        need(self.name.isidentifier(), repr(self.name), "an identifier is needed as a name")
        need(bool(self.meaning.strip()), self.name, "a meaning is needed")
        parse(self.condition)

    @property
    def tree(self) -> Tree:
        """The condition as a comparison."""
        return parse(self.condition)
