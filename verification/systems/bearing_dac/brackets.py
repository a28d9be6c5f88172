"""From a bracket of a constant to the answer that a user gets."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from sensortrack.networks import Network
from verification.answers import Answer
from verification.certificates.make import CertificateError, certificate
from verification.exact.cuts.extreme import CutBracket
from verification.exact.rationals import above, below, nearest

SYSTEM = "bearing_dac"
USABLE = Fraction(1, 10**6)
"""Relative width of a certified bracket above which it gives no value."""

TOO_LONG = (
    "the worst of all cuts, but showing so is longer than the certificate checker's budget: "
    "computed, not certified"
)
OPEN = "the bounds that could be proved are too far apart for a value"
BY_INTEGERS = (
    "the bounds were computed in exact integers, but a certificate would be longer than the "
    "checker reads"
)
FILE_EDGES = 3_000_000
"""Most edges of a network that a certificate can hold."""

NO_WITNESS = "no bound from the other side could be proved for a network of this size"


def too_long(network: Network) -> bool:
    """Whether not even the edges of a network fit into a certificate."""
    return not network.factors and network.m > FILE_EDGES


def answer(
    name: str,
    inputs: Mapping[str, Any],
    found: CutBracket,
    ends: tuple[Fraction | None, Fraction | None],
    value: float | None,
    exact: dict[str, Any] | None,
    notes: Sequence[str] = (),
    printed: float | None = None,
) -> Answer:
    """Answer with as much as could be shown.

    Parameters
    ----------
    name : str
        The quantity, which is also the statement's name.
    inputs : mapping
        The certificate's data.
    found : CutBracket
        Witnesses; those for the lower end of a ``margin_rate_squared`` come from `clear`.
    ends : tuple of Fraction or None
        Lower and upper end that the certificate states.
    value : float or None
        The constant, where it is known.
    exact : dict or None
        The same as the ``exact`` field.
    notes : sequence of str, optional
    printed : float, optional

    Returns
    -------
    Answer
    """
    lower, upper = ends
    document, reasons = None, list(notes)
    if found.clear is not None and lower is not None and upper is not None:
        try:
            witness = [found.clear, found.reaches]
            document = certificate(SYSTEM, name, inputs, witness, lower=lower, upper=upper)
        except CertificateError as error:
            reasons.append(f"no certificate: {error}")
    low = None if lower is None else below(lower)
    high = None if upper is None else above(upper) or 0.0  # no negative zero
    narrow = lower is not None and upper is not None and upper - lower <= USABLE * upper
    if document is not None and lower is not None and upper is not None and narrow:
        middle = nearest((lower + upper) / 2)
        shown = middle if value is None else value
        verdict = "PROVED"
    elif value is not None:
        shown, low, high, verdict = value, None, None, "SUPPORTED"
        reasons.append(TOO_LONG)
    else:
        shown, exact, verdict = None, None, "UNDECIDED"
        both = lower is not None and upper is not None
        reasons.append(OPEN if found.clear is not None else BY_INTEGERS if both else NO_WITNESS)
    proved = "certified" if document is not None else "by exact integers, without certificate"
    return Answer(
        shown, exact, low, high, printed, verdict, document, None, tuple(reasons), proved=proved
    )
