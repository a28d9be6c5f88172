"""What certificates about the cycle and its blocks, (15) to (19), prove."""

from __future__ import annotations

from ....statements import Case, Statement
from .. import cycle_identities
from ..universal import Universal
from . import steps

WHOLE = dict.fromkeys(("k", "T", "S", "u", "b", "c", "e", "l", "q", "s", "t"), "real") | {
    **dict.fromkeys("vwopzd", "nonnegative"),
    "k": "positive",
    "a": "nonnegative",
}
"""Symbols of `cycle_identities`; the words say which of them are whole numbers."""
BASES = WHOLE | {"c": "nonnegative"}
HALVES = dict.fromkeys("taxy", "real")

CYCLE: tuple[Universal, ...] = (
    Universal(
        "section_3_active_index",
        "for whole T, u = v + 1 and k = u + 1 + w, so for each pair u of a cycle but the last, of "
        "k >= 2: with its second instant t = 2k(T-1) + 2u, t - 1 leaves 2v + 1 when divided by 2k, "
        "with the half v, and t leaves 2u, with the half u; and u - v = 1, so that the printed "
        "indices of the two instants differ",
        cycle_identities.printed_index(),
        WHOLE,
        verdict="REFUTED",
    ),
    Universal(
        "section_3_active_index_repair",
        "for whole T, u = v + 1 and k = u + w, at the first (o = 0) and the second (o = 1) instant "
        "t = 2k(T-1) + 2u - 1 + o of a pair: t - 1 leaves 2v + o when divided by 2k, whose half, "
        "rounded down, is v = u - 1; so ((t - 1) mod 2k) div 2 + 1 is u at both",
        cycle_identities.index(),
        WHOLE,
    ),
    Universal(
        "section_3_shift_repair",
        "for block u = v + 1 of k = u + w, updated at t = 2k(T-1) + 2u: the end e = 2kT of the "
        "cycle is 2(k - u) later, which is at least 0 and at most 2k - 2",
        cycle_identities.lags(),
        WHOLE,
    ),
    Universal(
        "algorithm_1_clock_repair",
        "with t = 2k(T-1) + 2u for the pair u <= k of cycle T: the instant s of pair b >= 1 in a "
        "later cycle S = T + 1 + a is at least 2 later, and so is the instant q of a later pair c "
        "= u + 1 + d of the same cycle; so no two pairs share an instant",
        cycle_identities.clock(),
        WHOLE,
    ),
    Universal(
        "algorithm_1_base_point",
        "with cycles counted from 0, so that pair u of cycle T ends at 2kT + 2u, for k = c + 2 "
        "blocks and T = d + 2: block u was last updated at l = 2k(T-1) + 2u, which is at least 2T "
        "+ 2; the estimate of 2T is older than that",
        cycle_identities.printed_base(),
        BASES,
        verdict="REFUTED",
    ),
    Universal(
        "algorithm_1_base_point_repair",
        "pair u = v + 1 of k = u + w in cycle T ends at t = 2k(T-1) + 2u, and block u was last "
        "updated at l = t - 2k: neither t - 2 nor the start 2k(T-1) of the cycle is before l, and "
        "the start is not after t - 2; so both estimates hold the newest value of the block",
        cycle_identities.base(),
        WHOLE,
    ),
    Universal(
        "algorithm_1_previous",
        "estimates are assigned at even instants t = 2a; (t - 1)/2 is a half above the whole "
        "number a - 1, so t - 1 is no such instant",
        cycle_identities.parity()[:1],
        HALVES,
        verdict="REFUTED",
    ),
    Universal(
        "algorithm_1_previous_repair",
        "estimates are assigned at even instants t = 2a, and (t - 2)/2 is the whole number a - 1: "
        "t - 2 is the instant before at which one is assigned, or 0 of the initial guess",
        cycle_identities.parity()[1:],
        HALVES,
    ),
)


def _refuted(name: str, words: str, show: tuple[str, ...], inputs: dict[str, str]) -> Statement:
    return Statement("cyclic_spsa", name, {"REFUTED": Case("REFUTED", words, show)}, inputs)


def _small(*names: str) -> tuple[str, ...]:
    """They are whole: 1, 2, 3 or 4."""
    return tuple("*".join(f"({name} - {k})" for k in (1, 2, 3, 4)) + " == 0" for name in names)


def _clock() -> Statement:
    return _refuted(
        "algorithm_1_clock",
        "pair u of cycle T and pair v of the later cycle S, both among the k pairs of a cycle, "
        "have the same printed instant, 2T + 2u = 2S + 2v; all are whole numbers from 1 to 4",
        (*_small(*"kTSuv"), "S > T", "u <= k", "v <= k", "2*T + 2*u == 2*S + 2*v"),
        dict.fromkeys(("k", "T", "S", "u", "v"), "number"),
    )


def _shift() -> Statement:
    return _refuted(
        "section_3_shift",
        "block u of k, updated at 2k(T-1) + 2u, is 2kT - (2k(T-1) + 2u) = l instants old at the "
        "end of cycle T, and u shifts by 2k - 2 go back u(2k - 2), another number; k, T and u are "
        "whole numbers from 1 to 4",
        (*_small(*"kTu"), "u <= k", "2*k*T - (2*k*(T - 1) + 2*u) == l", "u*(2*k - 2) != l"),
        dict.fromkeys(("k", "T", "u", "l"), "number"),
    )


UNIVERSAL: tuple[Universal, ...] = (*CYCLE, *steps.UNIVERSAL)
STATEMENTS: tuple[Statement, ...] = (
    *(entry.statement for entry in CYCLE),
    _clock(),
    _shift(),
    *steps.STATEMENTS,
)
