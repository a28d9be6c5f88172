"""Positions from an angle and a distance, their errors and covariances, as identities of vectors.

The angle psi counts from the second axis, so that a target at the distance rho of a sensor is at
rho (sin psi, cos psi) from it.

Letters: ``u v`` (unit vectors along the axes), ``e`` (from the sensor to the target), ``n`` (the
direction in which e moves as psi grows), ``s`` (sensor), ``r`` (target), ``p`` (computed position).
Scalars: ``rho`` (distance), ``S C`` (sine and cosine of psi), ``a b`` (cosine and sine of the error
of the angle), ``d`` (error of the distance over the distance).
"""

from __future__ import annotations

from collections.abc import Mapping

from .identities import ONE, Identity, Square
from .noncommuting import Form, letters, scalars
from .rewriting import derive

U, V, E, N, S, R, P = letters("u v e n s r p")
RHO, SIN, COS, A, B, D = scalars("rho S C a b d")

AXES = (U.T * U - ONE, V.T * V - ONE, U.T * V, SIN * SIN + COS * COS - ONE)
AXES_WORDS = ("u' u", "v' v", "u' v", "C**2")
FRAME = (E.T * E - ONE, N.T * N - ONE, E.T * N, A * A + B * B - ONE)
FRAME_WORDS = ("e' e", "n' n", "e' n", "b**2")


def _family(
    relations: tuple[Form, ...], words: tuple[str, ...], goals: Mapping[str, Form]
) -> tuple[Identity, ...]:
    known = dict(enumerate(words))
    return tuple(derive(name, goal, relations, known) for name, goal in goals.items())


def inverse() -> tuple[Identity, ...]:
    """An exact distance and an exact angle, in any quadrant, give the position.

    Returns
    -------
    tuple of Identity
        Letters ``u v s r p``, scalars ``rho S C``.
    """
    offset = RHO * (SIN * U + COS * V)
    goals = {
        "p = r": P - R,
        "rho^2 = |r - s|^2": (R - S).T * (R - S) - RHO * RHO,
        "rho sin psi is the first entry of r - s": U.T * R - U.T * S - RHO * SIN,
        "rho cos psi is the second": V.T * R - V.T * S - RHO * COS,
    }
    relations = (*AXES, R - S - offset, P - S - offset)
    return _family(relations, (*AXES_WORDS, "r", "p"), goals)


def error() -> tuple[Identity, ...]:
    """The error of the position: distance times a turned vector that depends on the noise alone.

    Returns
    -------
    tuple of Identity
        Letters ``e n s r p``, scalars ``rho a b d``.
    """
    stretched = A + D * A
    radial, tangential = stretched - ONE, B + D * B
    goals = {
        "p - r = rho (((1 + d) a - 1) e + (1 + d) b n)": (
            P - R - RHO * (radial * E + tangential * N)
        ),
        "|p - r|^2 = rho^2 ((1 + d)^2 + 1 - 2 (1 + d) a)": (
            (P - R).T * (P - R) - RHO * RHO * (ONE + (ONE + D) * (ONE + D) - 2 * stretched)
        ),
    }
    read = P - S - RHO * (ONE + D) * (A * E + B * N)
    return _family((*FRAME, R - S - RHO * E, read), (*FRAME_WORDS, "r", "p"), goals)


def fourth_moment() -> tuple[Identity, ...]:
    """The error is at most rho (1 + p), p being the measured distance over the true one.

    Returns
    -------
    tuple of Identity
        Scalars ``rho``, ``p``, ``c`` = 1 + the cosine of the angle error.
    """
    p, c = scalars("p c")
    square = p * p + ONE - 2 * (p * (c - ONE))
    goal = RHO * RHO * ((ONE + p) * (ONE + p) - square)
    least = [Square(2 * (RHO * RHO * p * c), ONE, ONE)]
    return (derive("|p - r|^2 <= rho^2 (1 + p)^2", goal, (), {}, least),)


def unbounded() -> tuple[Identity, ...]:
    """For every bound there is a distance at which the fourth power of the error exceeds it.

    Returns
    -------
    tuple of Identity
        Scalars ``B`` (the bound is its square), ``c`` (squared error at the distance 1), ``q`` (the
        squared distance).
    """
    bound, c, q = scalars("B c q")
    relations = (q * c - bound - ONE,)
    goal = q * q * c * c - bound * bound - 2 * bound - ONE
    return (derive("(q c)^2 = B^2 + 2B + 1", goal, relations, {0: "c q"}),)


def mean_position() -> tuple[Identity, ...]:
    """Divided by the mean cosine of the angle error, the computed position is right in the mean.

    For independent laws of finitely many outcomes: of the angle error with probabilities w,
    cosines k and sines l, of which l has the mean zero; of the distance with probabilities v and
    values z, whose mean is rho.

    Returns
    -------
    tuple of Identity
        Letters ``e n s r``, ``w k l o`` (o holds ones), ``v z t`` (t holds ones); scalars ``rho``,
        ``g`` (mean cosine), ``q`` (1/g).
    """
    w, k, l_, o, v, z, t = letters("w k l o v z t")
    g, q = scalars("g q")
    relations = (
        o.T * w - ONE,
        t.T * v - ONE,
        k.T * w - g,
        l_.T * w,
        z.T * v - RHO,
        g * q - ONE,
        R - S - RHO * E,
    )
    words = ("o' w", "t' v", "k' w", "l' w", "z' v", "g q", "r")
    polar = (E * k.T * w + N * l_.T * w) * (z.T * v)
    start = S * (o.T * w) * (t.T * v)
    goals = {
        "the mean of s + q z (cos, sin) is r": start + q * polar - R,
        "without q it is off by (1 - g) rho, towards the sensor": (
            start + polar - R + RHO * (ONE - g) * E
        ),
    }
    return _family(relations, words, goals)


def covariance() -> tuple[Identity, ...]:
    """To first order, the distance errs along the line of sight and the angle across it.

    Returns
    -------
    tuple of Identity
        Letters ``u v e n``, ``J`` (derivative of the position), ``X`` (covariance to first order),
        ``Y`` (the printed one), ``Q`` (the matrix [sin, -cos; cos, sin], which is [e, -n]); scalars
        ``rho``, ``f k`` (standard deviations of the angle and of the relative distance).
    """
    j, x, y, q = letters("J X Y Q", ("X", "Y"))
    f, k = scalars("f k")
    across, along = RHO * RHO * f * f, RHO * RHO * k * k
    uu, vv = U * U.T, V * V.T
    relations = (
        *AXES[:3],
        *FRAME[:3],
        j - RHO * (N * U.T) - E * V.T,
        x - j * (f * f * uu + along * vv) * j.T,
        q - E * U.T + N * V.T,
        y - q * (across * uu + along * vv) * q.T,
    )
    words = (*AXES_WORDS[:3], *FRAME_WORDS[:3], "J", "X", "Q", "Y")
    goals = {
        "X = Q diag((rho k)^2, (rho f)^2) Q'": x - q * (along * uu + across * vv) * q.T,
        "along the line of sight X is (rho k)^2": E.T * x * E - along,
        "the printed one is (rho f)^2 there": E.T * y * E - across,
        "both have the same trace": E.T * x * E + N.T * x * N - across - along,
        "which is the printed one": E.T * y * E + N.T * y * N - across - along,
    }
    return _family(relations, words, goals)


def rotation() -> tuple[Identity, ...]:
    """[sin, -cos; cos, sin] turns by a right angle less psi, from the first axis to the second.

    Returns
    -------
    tuple of Identity
        Letters ``u v``, ``Q``, ``i`` (the identity, uu' + vv'); scalars ``S C``.
    """
    q, i = letters("Q i", ("i",))
    quarter = V * U.T - U * V.T
    relations = (*AXES, i - U * U.T - V * V.T, q - SIN * i - COS * quarter)
    words = (*AXES_WORDS, "i", "Q")
    goals = {
        "Q'Q = 1": q.T * q - i,
        "the first axis goes to the line of sight": q * U - SIN * U - COS * V,
        "its determinant is 1": (U.T * q * U) * (V.T * q * V) - (U.T * q * V) * (V.T * q * U) - ONE,
    }
    return _family(relations, words, goals)
