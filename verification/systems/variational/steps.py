"""Largest stable steps of the discrete variational estimator (20) and of its centred form."""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from theory.algebra.lagrange import Recursion
from theory.algebra.noncommuting import Form
from theory.systems.variational.statements.common import LEAPFROG, SCHEME
from verification.answers import Answer
from verification.certificates.make import certificate
from verification.exact.definite import negative_vector
from verification.exact.evaluate import Rows, at, matrices
from verification.exact.thresholds import Threshold, concave_threshold, ends, value_of

from .gains import definite_gains, positive_step

NO_THRESHOLD = (
    "no step below the computed threshold could be certified: the matrices are too ill-scaled"
)


def at_minus_one(scheme: Recursion) -> Form:
    """D(-1) = A2 - A1 + A0: where it stops being positive definite, a solution stops decaying."""
    return scheme.a2 - scheme.a1 + scheme.a0


def _limit(name: str, scheme: Recursion, values: Mapping[str, Any]) -> Answer:
    gains = definite_gains(values)
    threshold = concave_threshold(matrices(at_minus_one(scheme), gains))
    if threshold is None or not (0 < value_of(threshold) < math.inf):
        return Answer(verdict="UNDECIDED", notes=(NO_THRESHOLD,))
    document = certificate(
        "variational",
        name,
        gains,
        [{"kind": "vector", "x": list(threshold.vector)}],
        lower=threshold.lower,
        upper=threshold.upper,
    )
    lower, upper = ends(threshold)
    return Answer(
        value=value_of(threshold),
        exact=threshold.exact.to_data() if threshold.exact else None,
        lower=lower,
        upper=upper,
        verdict="PROVED",
        certificate=document,
    )


def step_limit(values: Mapping[str, Any]) -> Answer:
    """Supremum of the steps h for which (20) is Schur stable.

    Parameters
    ----------
    values : mapping
        ``M``, ``K``, ``C``: exact symmetric positive definite matrices of one size.

    Returns
    -------
    Answer
        With a two-sided certificate.

    Raises
    ------
    InputError
        A gain is not symmetric positive definite.

    References
    ----------
    Sanyal & Eslamiat, Proposition 4.1, (20), and the stability claim after (23).
    """
    return _limit("step_limit", SCHEME, values)


def leapfrog_step_limit(values: Mapping[str, Any]) -> Answer:
    """Supremum of the stable steps of (20) with the dissipation centred at the node.

    Parameters, returns and errors are those of `step_limit`.
    """
    return _limit("leapfrog_step_limit", LEAPFROG, values)


def decide_step(values: Mapping[str, Any]) -> Answer:
    """Decide whether (20) is Schur stable at the step h.

    Parameters
    ----------
    values : mapping
        ``M``, ``K``, ``C`` as in `step_limit`, and ``h``, a positive rational in the time unit of
        the gains.

    Returns
    -------
    Answer
        PROVED or REFUTED with a certificate; margin = step limit - h.

    Raises
    ------
    InputError
        A gain is not symmetric positive definite, or h <= 0.
    """
    h, gains = positive_step(values), definite_gains(values)
    threshold = concave_threshold(matrices(at_minus_one(SCHEME), gains))
    x = _vector(threshold, gains, h)
    case = "REFUTED" if x else "PROVED"
    witness = [{"kind": "vector", "x": list(x)}] if x else []
    document = certificate("variational", "step", {**gains, "h": h}, witness, case=case)
    margin = value_of(threshold) - float(h) if threshold else None
    return Answer(verdict=case, certificate=document, margin=margin)


def _vector(
    threshold: Threshold | None, gains: dict[str, Rows], h: Fraction
) -> tuple[int, ...] | None:
    """A vector that refutes stability at h, or None if h is stable."""
    if threshold and h >= threshold.upper:
        return threshold.vector
    if threshold and h <= threshold.lower:
        return None
    return negative_vector(at(at_minus_one(SCHEME), gains, h))
