"""Numbers with proved bounds, as answers."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from .answers import Answer
from .exact.rationals import above, below, nearest
from .exact.spectra.modes import exact
from .exact.spectra.spectral import Enclosure


def ball(x: Fraction | int) -> Any:
    """A rational as a `flint.arb` of the precision that is set."""
    import flint

    whole = Fraction(x)
    return flint.arb(flint.fmpq(whole.numerator, whole.denominator))


def ends(x: Any) -> tuple[Fraction, Fraction]:
    """Rational bounds on the number that a `flint.arb` encloses."""
    return exact(x.lower()), exact(x.upper())


def enclosure(low: Fraction, high: Fraction, stage: str = "") -> Enclosure:
    """A number between two rationals, in doubles rounded outwards."""
    value = nearest((low + high) / 2)
    return Enclosure(value, below(low), above(high) + 0.0, stage)  # the sum makes -0.0 a 0.0


def single(found: Enclosure, notes: tuple[str, ...] = (), **more: Any) -> Answer:
    """One number with certified bounds as an answer; `more` are further fields of it."""
    remarks = (*notes, found.stage) if found.stage else notes
    return Answer(
        value=found.value,
        lower=found.lower,
        upper=found.upper,
        verdict="PROVED",
        notes=remarks,
        **more,
    )


def listed(found: Sequence[Enclosure], notes: tuple[str, ...] = ()) -> Answer:
    """A list of numbers as an answer, the certified bounds of each in a note."""
    numbers = [entry.value for entry in found]
    remarks = dict.fromkeys((*notes, *(entry.stage for entry in found if entry.stage)))
    if any(entry.lower is None or entry.upper is None for entry in found):
        return Answer(value=numbers, notes=tuple(remarks))
    limits = "; ".join(f"{entry.lower} to {entry.upper}" for entry in found)
    return Answer(value=numbers, verdict="PROVED", notes=(f"certified: {limits}", *remarks))
