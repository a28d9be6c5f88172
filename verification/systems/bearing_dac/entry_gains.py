"""A gain for each of the two kinds of signals that bearing sensors average.

The bearing of a target that moves at most at the speed v and comes no nearer than rho turns at most
at the rate v/rho. The entries of h h' then move at most at v/rho, those of h h's at most at
|s| v/rho, s being the sensor's position: the first need a gain that does not depend on where the
origin lies, the second one that does.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError
from sensortrack.networks import Network
from verification.answers import Answer
from verification.certificates.make import CertificateError, certificate
from verification.exact.cuts.cut_components import flat
from verification.exact.cuts.extreme import CutBracket, threshold
from verification.exact.rationals import above, below, nearest

from .brackets import NO_WITNESS, OPEN, SYSTEM, USABLE
from .disturbances import angular_rate
from .network_inputs import Numbers, component_notes, network_of, node_data

ROOT_BITS = 64
"""Binary digits of a distance that is no rational, beyond its leading one."""

ORIGIN = "the gain of q depends on the origin: it is smallest near the sensors' middle"


def entry_gains(values: Mapping[str, Any]) -> Answer:
    """Smallest gains that keep agreement on the entries of P, and on those of q.

    Parameters
    ----------
    values : mapping
        ``graph``: Network; ``v_max``: rational, m/s, at least 0; ``rho_min``: rational, m,
        positive; ``positions``: tuple of two rationals a node, m.

    Returns
    -------
    Answer
        [beta_P, beta_q], the thresholds for gamma_i = v_max/rho_min and for gamma_i = |s_i|
        v_max/rho_min, with a certificate where both are short enough.

    Raises
    ------
    InputError
        The network has no edge, a number is out of its range, or there is not one position a node.

    References
    ----------
    George, equations (2) to (5) and Assumption 2.
    """
    network = flat(network_of(values))
    rate, positions = angular_rate(values), values["positions"]
    if len(positions) != network.n:
        needed = f"{network.n} are needed, one a node in the order of the graph"
        raise InputError("positions", f"{len(positions)} points", needed)
    high = tuple(rate * distance_above(x * x + y * y) for x, y in positions)
    same = (rate,) * network.n
    found = threshold(network, same), threshold(network, high)
    notes = [*component_notes(network, "the largest threshold counts"), ORIGIN]
    document, reason = _certificate(network, (same, high), found)
    lowers = [one.lower for one in found]
    uppers = [one.upper for one in found]
    if reason:
        notes.append(reason)
    if document is None:
        known = [one.value for one in found]
        if None in known:
            return Answer(verdict="UNDECIDED", notes=tuple(notes))
        return Answer(value=[nearest(x) for x in known if x is not None], notes=tuple(notes))
    low = [below(x * (1 - _slack(k))) for k, x in enumerate(lowers) if x is not None]
    top = [above(x) for x in uppers if x is not None]
    middle = [(a + b) / 2 for a, b in zip(low, top, strict=True)]
    if any(b - a > float(USABLE) * b for a, b in zip(low, top, strict=True)):
        return Answer(None, None, low, top, None, "UNDECIDED", document, None, (*notes, OPEN))
    shown = [nearest(x) if x is not None else y for x, y in zip(lowers, middle, strict=True)]
    return Answer(shown, None, low, top, None, "PROVED", document, None, tuple(notes))


def distance_above(square: Fraction) -> Fraction:
    """The square root if it is rational, else a rational at most a part in 2^ROOT_BITS above."""
    top, bottom = math.isqrt(square.numerator), math.isqrt(square.denominator)
    if top**2 == square.numerator and bottom**2 == square.denominator:
        return Fraction(top, bottom)
    size = square.numerator.bit_length() - square.denominator.bit_length()
    shift = Fraction(2) ** (ROOT_BITS + 1 - size // 2)
    return Fraction(math.isqrt(math.floor(square * shift**2)) + 1) / shift


def _slack(entry: int) -> Fraction:
    """By how much rounded distances may have raised a threshold, relatively."""
    return Fraction(entry, 2 ** (ROOT_BITS - 2))


def _certificate(
    network: Network, gamma: tuple[Numbers, Numbers], found: tuple[CutBracket, CutBracket]
) -> tuple[dict[str, Any] | None, str]:
    if any(one.clear is None for one in found):
        return None, NO_WITNESS
    inputs: dict[str, Any] = {"graph": network.to_data()}
    witness: list[Any] = []
    for entry, bounds, one in zip("Pq", gamma, found, strict=True):
        inputs |= {f"gamma_{entry}": node_data(bounds)}
        inputs |= {f"lower_{entry}": one.lower, f"upper_{entry}": one.upper}
        witness += [one.clear, one.reaches]
    try:
        return certificate(SYSTEM, "entry_gains", inputs, witness), ""
    except CertificateError as error:
        return None, f"no certificate: {error}"
