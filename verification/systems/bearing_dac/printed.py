"""The printed constants of Theorem 1, evaluated for the user's network, and lambda_2 itself."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from sensortrack.networks import Network
from verification.answers import Answer
from verification.certificates.make import certificate
from verification.exact.rationals import above, below, nearest
from verification.exact.spectral_gap import (
    LARGEST,
    NoBracketError,
    connectivity_bracket,
    exact_connectivity,
)

from .data import components, connectivity, disturbance, explicit, norm, parts_note

LARGEST_GAMMA = "the printed formula takes one gamma; the largest of the given bounds is used"
NOT_PROJECTED = "the printed formula takes the norm of x(t0) as given; its mean is not zero"
BY_FACTORS = (
    "the smallest lambda_2 of the factors, each proved; there is no certificate file for it"
)


def printed_gain(network: Network, gamma: Sequence[Fraction]) -> float | None:
    """1 + gamma sqrt(n)/lambda_2, largest over the components; None if lambda_2 is not found."""
    try:
        return max(
            1 + float(max(gamma[i] for i in nodes)) * math.sqrt(part.n) / connectivity(part).value
            for part, nodes in components(network)
        )
    except NoBracketError:
        return None


def printed_threshold(values: Mapping[str, Any]) -> Answer:
    """The printed gain 1 + gamma sqrt(n)/lambda_2.

    Parameters
    ----------
    values : mapping
        ``graph``, a `Network`; ``gamma``, one bound a node.

    Returns
    -------
    Answer

    Raises
    ------
    InputError
        A bound is negative.

    References
    ----------
    J. George, Theorem 1.
    """
    network: Network = values["graph"]
    gamma = disturbance(values)
    value = printed_gain(network, gamma)
    notes = parts_note(network, "largest gain")
    notes += (LARGEST_GAMMA,) if len(set(gamma)) > 1 else ()
    verdict = "UNDECIDED" if value is None else "SUPPORTED"
    return Answer(value, printed=value, verdict=verdict, notes=notes)


def printed_settling_time(values: Mapping[str, Any]) -> Answer:
    """The printed time |x(t0)|/lambda_2.

    Parameters
    ----------
    values : mapping
        ``graph``, a `Network`; ``x0``, one number a node.

    Returns
    -------
    Answer

    References
    ----------
    J. George, Theorem 1.
    """
    network, x0 = values["graph"], values["x0"]
    notes = parts_note(network, "largest time")
    notes += (NOT_PROJECTED,) if sum(x0) else ()
    try:
        value = max(
            norm([x0[i] for i in nodes]) / connectivity(part).value
            for part, nodes in components(network)
        )
    except NoBracketError as error:
        return Answer(verdict="UNDECIDED", notes=(*notes, str(error)))
    return Answer(value, printed=value, verdict="SUPPORTED", notes=notes)


def algebraic_connectivity(values: Mapping[str, Any]) -> Answer:
    """lambda_2, the second smallest eigenvalue of the Laplacian.

    Parameters
    ----------
    values : mapping
        ``graph``, a `Network`.

    Returns
    -------
    Answer
        With a two-sided certificate up to 200 nodes; 0 for a disconnected network.

    References
    ----------
    M. Fiedler, "Algebraic connectivity of graphs", 1973.
    """
    network: Network = values["graph"]
    if network.n > LARGEST and network.is_connected():
        return _large(network)
    plain = explicit(network)
    gap = connectivity_bracket(plain) if plain.n <= LARGEST else _split(plain)
    vector = {"kind": "vector", "x": list(gap.vector)}
    inputs = {"graph": plain.to_data()}
    ask = ("bearing_dac", "algebraic_connectivity", inputs, [vector])
    if gap.upper == 0:
        document = certificate(*ask, case="PROVED 0", lower="0", upper="0")
        exact = {"kind": "rational", "value": "0"}
        notes = (f"the network has {len(plain.components())} components, so lambda_2 is 0",)
        return Answer(0.0, exact, 0.0, 0.0, verdict="PROVED", certificate=document, notes=notes)
    document = certificate(*ask, lower=gap.lower, upper=gap.upper)
    number = exact_connectivity(plain, gap)
    return Answer(
        value=number.nearest if number else nearest((gap.lower + gap.upper) / 2),
        exact=number.to_data() if number else None,
        lower=below(gap.lower),
        upper=above(gap.upper),
        verdict="PROVED",
        certificate=document,
    )


def _split(network: Network) -> Any:
    """Bracket of a disconnected network of any size: both ends are 0."""
    from verification.exact.spectral_gap import Gap

    part, n = set(network.components()[0]), network.n
    vector = tuple(n - len(part) if i in part else -len(part) for i in range(n))
    return Gap(Fraction(0), Fraction(0), vector)


def _large(network: Network) -> Answer:
    """More nodes than a certificate is made for: by factors, or in floating point."""
    try:
        gap = connectivity_bracket(network)
    except NoBracketError as error:
        try:
            found = connectivity(network)
        except NoBracketError:
            return Answer(verdict="UNDECIDED", notes=(str(error),))
        return Answer(found.value, verdict="SUPPORTED", notes=found.notes or (str(error),))
    number = exact_connectivity(network, gap)
    return Answer(
        value=number.nearest if number else nearest((gap.lower + gap.upper) / 2),
        exact=number.to_data() if number else None,
        lower=below(gap.lower),
        upper=above(gap.upper),
        verdict="PROVED",
        notes=(BY_FACTORS,),
    )
