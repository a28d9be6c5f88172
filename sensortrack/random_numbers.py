"""Random numbers that are a function of a key and a counter: any draw can be made again by itself.

Whoever draws names the number it wants (seed and stream in the key; run, update, place in the
counter), so that the numbers of one run do not depend on how many runs there are, in which order
they are worked on, or in which language. The words are those of `numpy.random.Philox`.

References
----------
J. Salmon, M. Moraes, R. Dror, D. Shaw, *Parallel Random Numbers: As Easy as 1, 2, 3* (2011),
Philox4x64 with ten rounds.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sensortrack.errors import InputError

Words = NDArray[np.uint64]
Floats = NDArray[np.float64]
MASK = 2**64 - 1
MULTIPLIERS = (0xD2E7470EE14C6C93, 0xCA5A826395121157)
WEYL = (0x9E3779B97F4A7C15, 0xBB67AE8584CAA73B)
ROUNDS = 10
STREAMS = {"perturbation": 0, "batch": 1}
"""Second word of the key: what the numbers are for."""

Counter = tuple[int, int, int, int]


def philox(counter: Counter, key: tuple[int, int]) -> Counter:
    """Four words of 64 bits.

    Parameters
    ----------
    counter : four int
        Each from 0 to 2^64 - 1.
    key : two int
        Likewise.
    """
    a, b, c, d = counter
    left, right = key
    for _ in range(ROUNDS):
        one, other = MULTIPLIERS[0] * a, MULTIPLIERS[1] * c
        a, b, c, d = (
            (other >> 64) ^ b ^ left,
            other & MASK,
            (one >> 64) ^ d ^ right,
            one & MASK,
        )
        left, right = (left + WEYL[0]) & MASK, (right + WEYL[1]) & MASK
    return a, b, c, d


def words(counter: Counter, key: tuple[int, int], count: int) -> Words:
    """The words of this counter and of those after it, `philox` block by block.

    Parameters
    ----------
    counter : four int
        The first; the next ones add to its first number, and carry.
    key : two int
    count : int
        Words.

    Returns
    -------
    array of uint64, shape (count,)
    """
    # NumPy counts up before it makes a block
    first = sum(word << (64 * k) for k, word in enumerate(counter))
    before = (first - 1) % 2**256
    whole = sum(word << (64 * k) for k, word in enumerate(key))
    found: Words = np.random.Philox(counter=before, key=whole).random_raw(count)
    return found


def signs(counter: Counter, key: tuple[int, int], count: int) -> list[int]:
    """Independent signs, +1 or -1 with the same probability: bits of words, the lowest first."""
    found: list[int] = []
    low, *rest = counter
    while len(found) < count:
        for word in philox((low, rest[0], rest[1], rest[2]), key):
            wanted = min(64, count - len(found))
            found += [1 if word >> bit & 1 else -1 for bit in range(wanted)]
        low += 1
    return found


def whole(name: str, value: object, least: int = 0, most: int = MASK) -> int:
    """A whole number: a seed, or what a counter counts.

    Raises
    ------
    InputError
        With this name: it is not a whole number, or not from `least` to `most`.
    """
    found = least - 1
    if isinstance(value, int | np.integer) and not isinstance(value, bool):
        found = int(value)
    if not least <= found <= most:
        up_to = f"2^{most.bit_length()} - 1" if most & (most + 1) == 0 else str(most)
        raise InputError(name, f"{value}", f"a whole number from {least} to {up_to} is needed")
    return found
