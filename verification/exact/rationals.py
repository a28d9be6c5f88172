"""Exact numbers: read them from text, write them as text, and bound them by doubles."""

from __future__ import annotations

import math
import re
from fractions import Fraction

from sensortrack.errors import InputError

MAX_DIGITS = 1000
MAX_EXPONENT = 400
_DECIMAL = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")
_RATIO = re.compile(r"[+-]?\d+\s*/\s*\d+")


def parse_exact(value: object, name: str) -> Fraction:
    """Read one exact number.

    Parameters
    ----------
    value : int, str, Fraction or float
        A decimal text is exactly that decimal, so a tenth is 1/10; a float is the exact dyadic
        number that it holds.
    name : str
        The input's name, for the error.

    Returns
    -------
    Fraction

    Raises
    ------
    InputError
        `value` is no finite number, or has more than a thousand digits or an exponent beyond 400.
    """
    if isinstance(value, bool) or value is None:
        raise InputError(name, f"{value!r}", "a number is needed")
    if isinstance(value, (int, Fraction)):
        return Fraction(value)
    if isinstance(value, float):
        if not math.isfinite(value):
            raise InputError(name, f"{value}", "a finite number is needed")
        return Fraction(value)
    text = str(value).strip()
    if len(text) > MAX_DIGITS:
        raise InputError(name, f"a number of {len(text)} characters", f"at most {MAX_DIGITS}")
    if _RATIO.fullmatch(text):
        above, below = text.split("/")
        if int(below) == 0:
            raise InputError(name, f"{text!r}", "a denominator other than 0 is needed")
        return Fraction(int(above), int(below))
    if not _DECIMAL.fullmatch(text):
        raise InputError(name, f"{text!r}", 'a finite number is needed, like 0.1 or "1/3"')
    exponent = re.split("[eE]", text)[1:]
    if exponent and abs(int(exponent[0])) > MAX_EXPONENT:
        raise InputError(name, f"{text!r}", f"an exponent of at most {MAX_EXPONENT} is needed")
    return Fraction(text)


def text(value: Fraction) -> str:
    """Write a rational as ``"3"`` or ``"1/3"``."""
    return str(value)


def nearest(value: Fraction) -> float:
    """The double nearest to `value`, infinite beyond the largest double."""
    try:
        return value.numerator / value.denominator
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def below(value: Fraction) -> float:
    """The largest double that is at most `value`."""
    guess = nearest(value)
    if math.isinf(guess):
        return guess if guess < 0 else math.nextafter(math.inf, 0.0)
    return guess if Fraction(guess) <= value else math.nextafter(guess, -math.inf)


def above(value: Fraction) -> float:
    """The smallest double that is at least `value`."""
    return 0.0 - below(-value)


def root(value: Fraction, bits: int = 200) -> Fraction:
    """Square root of a positive rational, with a relative error below 2^-bits."""
    up = max(0, 2 * bits + value.denominator.bit_length() - value.numerator.bit_length() + 2)
    shift = up + up % 2
    whole = math.isqrt((value.numerator << shift) // value.denominator)
    return Fraction(whole, 1 << (shift // 2))
