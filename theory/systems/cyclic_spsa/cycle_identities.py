"""Instants, remainders and lags of the cycle as identities of whole numbers, for any k, T and u.

Scalars: ``k`` (blocks), ``T`` (cycle), ``u`` (block), ``t`` (instant); ``v`` = u - 1 and ``w`` =
k - u, which are at least 0; ``o`` = 0 at the first instant of a pair and 1 at the second, ``p`` =
1 - o. Where cycles count from 0, ``T`` = 0, 1, ...
"""

from __future__ import annotations

from collections.abc import Mapping

from ...algebra.identities import ONE, Identity, Square
from ...algebra.noncommuting import Form, scalars
from ...algebra.rewriting import derive

K, T, BLOCK, INSTANT, V, W, SECOND, P = scalars("k T u t v w o p")
BEFORE, BEHIND = BLOCK - V - ONE, K - BLOCK - W
"""u = v + 1 and k = u + w."""
PAIR = SECOND + P - ONE
END = 2 * (K * T) - 2 * K
"""End of the cycle before the T-th, 2k (T - 1)."""

Goal = tuple[Form, Form | None]
"""A form that is zero, or one that is at least zero because it equals another one that is."""


def _family(relations: Mapping[str, Form], goals: Mapping[str, Goal]) -> tuple[Identity, ...]:
    given, words = tuple(relations.values()), dict(enumerate(relations))
    return tuple(
        derive(name, goal, given, words, [Square(least, ONE, ONE)] if least else ())
        for name, (goal, least) in goals.items()
    )


def printed_index() -> tuple[Identity, ...]:
    """As printed, the two instants of a pair have different active indices.

    Returns
    -------
    tuple of Identity
        Scalars ``k T u t v w``; here k = u + 1 + w, and ``t`` is the second instant.
    """
    relations = {"u": BEFORE, "k": K - BLOCK - ONE - W, "t": INSTANT - END - 2 * BLOCK}
    first, second = 2 * V + ONE, 2 * BLOCK
    goals: dict[str, Goal] = {
        "t - 1 = 2k (T - 1) + 2v + 1": (INSTANT - ONE - END - first, None),
        "2v + 1 < 2k": (2 * K - ONE - first, 2 * W + 2 * ONE),
        "t = 2k (T - 1) + 2u": (INSTANT - END - second, None),
        "2u < 2k": (2 * K - ONE - second, 2 * W + ONE),
        "the halves, rounded down, differ by 1": (BLOCK - V - ONE, None),
    }
    return _family(relations, goals)


def index() -> tuple[Identity, ...]:
    """((t - 1) mod 2k) div 2 + 1 is u at both instants of a pair.

    Returns
    -------
    tuple of Identity
        Scalars ``k T u t v w o p``.
    """
    moment = INSTANT - END - 2 * BLOCK + P
    relations = {"u": BEFORE, "k": BEHIND, "p": PAIR, "t": moment}
    rest = 2 * V + SECOND
    goals: dict[str, Goal] = {
        "t - 1 = 2k (T - 1) + 2v + o": (INSTANT - ONE - END - rest, None),
        "2v + o >= 0": (rest, rest),
        "2v + o < 2k": (2 * K - ONE - rest, 2 * W + P),
        "its half, rounded down, and 1 make u": (V + ONE - BLOCK, None),
    }
    return _family(relations, goals)


def lags() -> tuple[Identity, ...]:
    """At the end of a cycle, block u was last updated 2(k - u) instants before.

    Returns
    -------
    tuple of Identity
        Scalars ``k T u t v w``; ``t`` is the instant of the update, ``e`` the end of the cycle.
    """
    (end,) = scalars("e")
    relations = {
        "u": BEFORE,
        "k": BEHIND,
        "t": INSTANT - END - 2 * BLOCK,
        "e": end - 2 * (K * T),
    }
    goals: dict[str, Goal] = {
        "e - t = 2 (k - u)": (end - INSTANT - 2 * K + 2 * BLOCK, None),
        "not after the end": (end - INSTANT, 2 * W),
        "within the cycle": (2 * K - 2 * ONE - end + INSTANT, 2 * V),
    }
    return _family(relations, goals)


def clock() -> tuple[Identity, ...]:
    """2k (T - 1) + 2u grows by at least 2 from each pair to each later one.

    Returns
    -------
    tuple of Identity
        Scalars ``k T u t w``; ``S = T + 1 + a``, ``b = z + 1`` and ``s`` are a later cycle, a block
        of it and its instant; ``c = u + 1 + d`` and ``q`` are a later block of the same cycle and
        its instant.
    """
    later, block, instant, more, z = scalars("S b s a z")
    next_block, moment, further = scalars("c q d")
    relations = {
        "t": INSTANT - END - 2 * BLOCK,
        "s": instant - 2 * (K * later) + 2 * K - 2 * block,
        "q": moment - END - 2 * next_block,
        "S": later - T - ONE - more,
        "b": block - z - ONE,
        "c": next_block - BLOCK - ONE - further,
        "k": BEHIND,
    }
    goals: dict[str, Goal] = {
        "a later cycle": (instant - INSTANT - 2 * ONE, 2 * (K * more) + 2 * z + 2 * W),
        "a later block of the cycle": (moment - INSTANT - 2 * ONE, 2 * further),
    }
    return _family(relations, goals)


def printed_base() -> tuple[Identity, ...]:
    """From the third cycle on the base 2T is older than the last update, for two blocks or more.

    Returns
    -------
    tuple of Identity
        Scalars ``k T u v``, ``T`` from 0; ``c = k - 2``, ``d = T - 2``; ``l`` is the instant of the
        last update.
    """
    last, blocks, cycles = scalars("l c d")
    relations = {
        "l": last - 2 * (K * T) + 2 * K - 2 * BLOCK,
        "u": BEFORE,
        "k": K - 2 * ONE - blocks,
        "T": T - 2 * ONE - cycles,
    }
    lead = 2 * (blocks * cycles) + 2 * blocks + 2 * cycles + 2 * V
    goals: dict[str, Goal] = {"l >= 2T + 2": (last - 2 * T - 2 * ONE, lead)}
    return _family(relations, goals)


def base() -> tuple[Identity, ...]:
    """The estimate of t - 2, and that of the cycle's start, hold the block's last update.

    Returns
    -------
    tuple of Identity
        Scalars ``k T u t v w``; ``l`` is the instant of the last update.
    """
    (last,) = scalars("l")
    relations = {
        "t": INSTANT - END - 2 * BLOCK,
        "l": last - END + 2 * K - 2 * BLOCK,
        "k": BEHIND,
        "u": BEFORE,
    }
    goals: dict[str, Goal] = {
        "t - 2 is not before the last update": (INSTANT - 2 * ONE - last, 2 * V + 2 * W),
        "nor is the start of the cycle": (END - last, 2 * W),
        "the start of the cycle is not after t - 2": (INSTANT - 2 * ONE - END, 2 * V),
    }
    return _family(relations, goals)


def parity() -> tuple[Identity, ...]:
    """t - 1 is half way between two instants at which estimates are assigned, t - 2 is one.

    Returns
    -------
    tuple of Identity
        Scalars ``t``; ``a`` = t/2, ``x`` = (t - 1)/2, ``y`` = (t - 2)/2.
    """
    half, odd, even = scalars("a x y")
    relations = {
        "t": INSTANT - 2 * half,
        "x": 2 * odd - INSTANT + ONE,
        "y": 2 * even - INSTANT + 2 * ONE,
    }
    goals: dict[str, Goal] = {
        "(t - 1)/2 is above t/2 - 1 by a half": (2 * odd - 2 * half + ONE, None),
        "(t - 2)/2 = t/2 - 1": (2 * even - 2 * half + 2 * ONE, None),
    }
    return _family(relations, goals)
