"""Gain threshold and rate of sign-based consensus on the user's network."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from sensortrack.networks import Network
from verification.answers import Answer
from verification.certificates.make import CertificateError, certificate
from verification.exact.cuts import CutBracket, decide, margin, threshold
from verification.exact.rationals import above, below, nearest

from .data import disturbance, explicit, parts_note, positive_gain
from .printed import printed_gain

OPEN = "the cuts could not all be excluded within the budget: a bracket is certified, not a value"
UNSHOWN = "found by searching all cuts; too long for a certificate"
NARROW = Fraction(1, 10**6)


def gain_threshold(values: Mapping[str, Any]) -> Answer:
    """Smallest gain at or above which no disturbance drives agents apart.

    Parameters
    ----------
    values : mapping
        ``graph``, a `Network`; ``gamma``, one bound a node, in units of the averaged entry per
        second.

    Returns
    -------
    Answer
        Largest N/k over the cuts, rational, with both sides certified.

    Raises
    ------
    InputError
        A bound is negative.

    References
    ----------
    J. George, Theorem 1: the printed gain is 1 + gamma sqrt(n)/lambda_2.
    """
    network: Network = values["graph"]
    gamma = disturbance(values)
    bracket = threshold(network, gamma)
    inputs = {"graph": graph_data(network, bracket), "gamma": shortest(gamma)}
    printed = printed_gain(network, gamma)
    notes = parts_note(network, "largest threshold")
    return bracket_answer("gain_threshold", bracket, inputs, notes, printed)


def margin_rate_squared(values: Mapping[str, Any]) -> Answer:
    """Square of the rate that every unit of gain above the threshold is worth.

    Parameters
    ----------
    values : mapping
        ``graph``, a `Network`.

    Returns
    -------
    Answer
        Smallest k^2 n/(s(n - s)) over the cuts, rational, with both sides certified.
    """
    network = explicit(values["graph"])
    bracket = margin(network)
    inputs = {"graph": network.to_data()}
    notes = parts_note(network, "smallest rate")
    return bracket_answer("margin_rate_squared", bracket, inputs, notes, None)


def decide_gain(values: Mapping[str, Any]) -> Answer:
    """Decide whether a gain is at or above the threshold.

    Parameters
    ----------
    values : mapping
        ``graph``, ``gamma`` as in `gain_threshold`, and ``beta``, a positive rational.

    Returns
    -------
    Answer
        PROVED or REFUTED with a certificate; margin = beta - threshold.

    Raises
    ------
    InputError
        A bound is negative, or beta is not positive.
    """
    network: Network = values["graph"]
    gamma, beta = disturbance(values), positive_gain(values)
    known = threshold(network, gamma)
    holds, witness = decide(network, gamma, beta, known)
    notes = parts_note(network, "largest threshold")
    distance = None if known.value is None else nearest(beta - known.value)
    if holds is None or witness is None:
        return Answer(verdict="UNDECIDED", margin=distance, notes=(*notes, OPEN))
    case = "PROVED" if holds else "REFUTED"
    inputs = {"graph": graph_data(network, known), "gamma": shortest(gamma), "beta": beta}
    document = certificate("bearing_dac", "gain", inputs, [witness], case=case)
    return Answer(verdict=case, certificate=document, margin=distance, notes=notes)


def bracket_answer(
    name: str,
    bracket: CutBracket,
    inputs: Mapping[str, Any],
    notes: tuple[str, ...],
    printed: float | None,
) -> Answer:
    """Answer of a constant that is bracketed by cuts."""
    low, high = bracket.lower, bracket.upper
    if low is None or high is None or bracket.clear is None:
        return _unshown(bracket, notes, printed)
    witness = [bracket.clear, bracket.reaches]
    try:
        document = certificate("bearing_dac", name, inputs, witness, lower=low, upper=high)
    except CertificateError as error:
        return Answer(verdict="UNDECIDED", printed=printed, notes=(*notes, f"stage: {error}"))
    ends: dict[str, Any] = {"lower": below(low), "upper": above(high), "printed": printed}
    if low == high:
        exact = {"kind": "rational", "value": str(low)}
        return Answer(
            nearest(low), exact, verdict="PROVED", certificate=document, notes=notes, **ends
        )
    if high - low <= NARROW * high:
        middle = nearest((low + high) / 2)
        return Answer(middle, verdict="PROVED", certificate=document, notes=notes, **ends)
    return Answer(verdict="UNDECIDED", certificate=document, notes=(*notes, OPEN), **ends)


def _unshown(bracket: CutBracket, notes: tuple[str, ...], printed: float | None) -> Answer:
    """A value that a search found without leaving a witness, or one end only."""
    if bracket.value is not None:
        value = nearest(bracket.value)
        return Answer(value, verdict="SUPPORTED", printed=printed, notes=(*notes, UNSHOWN))
    low = None if bracket.lower is None else below(bracket.lower)
    high = None if bracket.upper is None else above(bracket.upper)
    notes = (*notes, OPEN)
    return Answer(lower=low, upper=high, verdict="UNDECIDED", printed=printed, notes=notes)


def graph_data(network: Network, bracket: CutBracket) -> dict[str, Any]:
    """The certificate's graph: by factors where the witness is about factors."""
    return (network if bracket.product else explicit(network)).to_data()


def shortest(gamma: tuple[Fraction, ...]) -> Fraction | list[Fraction]:
    """One number if all nodes have the same bound."""
    return gamma[0] if len(set(gamma)) == 1 else list(gamma)
