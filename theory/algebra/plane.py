"""Bearings in the plane, as identities of vectors: rotation, information, and their rates.

Letters: ``u v`` (unit vectors along the axes), ``f`` (unit vector from a sensor to the target),
``h`` (the same turned by a right angle), ``q`` (position of the sensor), ``p`` (of the target).
Scalars: ``c s`` (cosine and sine of the bearing), ``l`` (distance).
"""

from __future__ import annotations

from collections.abc import Mapping

from .identities import ONE, Identity, Square, hypotheses, identity
from .noncommuting import Form, letters, scalars
from .rewriting import derive

U, V, F, H, G, Q, P = letters("u v f h g q p")
C, S, L = scalars("c s l")

AXES = (U.T * U - ONE, V.T * V - ONE, U.T * V, U * U.T + V * V.T - ONE)
AXES_WORDS = ("u' u", "v' v", "u' v", "v v'")
BEARING = (C * C + S * S - ONE, F - C * U - S * V, H + S * U - C * V)
BEARING_WORDS = ("s**2", "f", "h")
FRAME = (F.T * F - ONE, H.T * H - ONE, F.T * H, F * F.T + H * H.T - ONE)
"""What `turned` proves of f and h, and all that is needed of them from then on."""
FRAME_WORDS = ("f' f", "h' h", "f' h", "h h'")


def _family(
    relations: tuple[Form, ...], words: tuple[str, ...], goals: Mapping[str, Form]
) -> tuple[Identity, ...]:
    known = dict(enumerate(words))
    return tuple(derive(name, goal, relations, known) for name, goal in goals.items())


def turned() -> tuple[Identity, ...]:
    """A bearing and the vector (-sin, cos) are orthonormal.

    Returns
    -------
    tuple of Identity
        Letters ``u v f h``, scalars ``c s``.
    """
    goals = {
        "f'f = 1": F.T * F - ONE,
        "h'h = 1": H.T * H - ONE,
        "f'h = 0": F.T * H,
        "ff' + hh' = I": F * F.T + H * H.T - ONE,
    }
    return _family((*AXES, *BEARING), (*AXES_WORDS, *BEARING_WORDS), goals)


def clockwise() -> tuple[Identity, ...]:
    """(-sin, cos) is as far from the bearing turned clockwise as can be.

    Clockwise is the turn that takes the second axis to the first.

    Returns
    -------
    tuple of Identity
        As `turned`.
    """
    right = U * V.T - V * U.T
    goals = {
        "the second axis turns to the first": right * V - U,
        "h differs from f turned clockwise by 2h": H - right * F - 2 * H,
        "h has length 1": H.T * H - ONE,
    }
    return _family((*AXES, *BEARING), (*AXES_WORDS, *BEARING_WORDS), goals)


def counter_clockwise() -> tuple[Identity, ...]:
    """(-sin, cos) is the bearing turned counter-clockwise; the other turn g gives the same P and q.

    Returns
    -------
    tuple of Identity
        Letters ``u v f h g q``, scalars ``c s``.
    """
    left = V * U.T - U * V.T
    goals = {
        "the first axis turns to the second": left * U - V,
        "h is f turned counter-clockwise": H - left * F,
        "gg' = hh'": G * G.T - H * H.T,
        "(g'q)g = (h'q)h": G * G.T * Q - H * H.T * Q,
    }
    relations = (*AXES, *BEARING, G + left * F)
    return _family(relations, (*AXES_WORDS, *BEARING_WORDS, "g"), goals)


def measured() -> tuple[Identity, ...]:
    """Unit vectors, distances and the measured offset.

    Returns
    -------
    tuple of Identity
        Letters ``u v f h q p``, scalars ``c s l``.
    """
    goals = {
        "l^2 = |p - q|^2": (P - Q).T * (P - Q) - L * L,
        "h'q = h'p": H.T * Q - H.T * P,
        "f has length 1": F.T * F - ONE,
    }
    relations = (*AXES, *BEARING, P - Q - L * F)
    return _family(relations, (*AXES_WORDS, *BEARING_WORDS, "p"), goals)


def information() -> tuple[Identity, ...]:
    """What holds for P = hh' and q = (h'q)h at every instant.

    Returns
    -------
    tuple of Identity
        Letters ``u v f h g q``, scalars ``c s``; here ``g`` is the averaged vector, hh'q.
    """
    info = H * H.T
    goals = {
        "PP = P": info * info - info,
        "Pf = 0": info * F,
        "f is not 0": F.T * F - ONE,
        "trace P = 1": U.T * info * U + V.T * info * V - ONE,
        "2P_11 = 1 - cos of twice the bearing": 2 * (U.T * info * U) - ONE + C * C - S * S,
        "2P_12 = -sin of twice the bearing": 2 * (U.T * info * V) + 2 * (S * C),
        "Pq is what is averaged beside P": G - info * Q,
    }
    relations = (*FRAME[:3], U.T * H + S, V.T * H - C, C * C + S * S - ONE, G - H * H.T * Q)
    words = (*FRAME_WORDS[:3], "u' h", "v' h", "s**2", "g")
    return _family(relations, words, goals)


def rates() -> tuple[Identity, ...]:
    """How fast P and q change while the target moves.

    Returns
    -------
    tuple of Identity
        Letters ``f h q``, ``t`` (velocity of the target), ``i D g`` (rates of h, P and q), ``a b``
        (any unit vectors), scalars ``l w`` (distance, angular speed).
    """
    t, i, a, b = letters("t i a b")
    (d,) = letters("D", ("D",))
    (w,) = scalars("w")
    relations = (
        *FRAME,
        L * w - H.T * t,
        i + w * F,
        d - i * H.T - H * i.T,
        G - H * (i.T * Q) - i * (H.T * Q),
        a.T * a - ONE,
        b.T * b - ONE,
    )
    words = dict(enumerate((*FRAME_WORDS, "l w", "i", "D", "g", "a' a", "b' b")))
    goals: dict[str, tuple[Form, tuple[Square, ...]]] = {
        "the rate of q is that of P, times the position": (G - d * Q, ()),
        "DD = w^2 I": (d * d - w * w, ()),
        "|rate of q| = |w| |position|": (G.T * G - w * w * (Q.T * Q), ()),
        "no entry of D exceeds |w|": (
            w * w - b.T * d * a * a.T * d * b,
            (Square(ONE, d * b - a * a.T * d * b, ONE),),
        ),
    }
    found = [
        derive(name, goal, relations, words, squares) for name, (goal, squares) in goals.items()
    ]
    _, _, _, complete, turning, *_ = hypotheses(relations)
    slow = identity(
        "the angular speed is at most speed over distance",
        t.T * t - L * L * w * w,
        relations,
        complete.between(t.T, t).times(-1) - turning.times(L * w) - turning.T.before(H.T * t),
        [Square(ONE, F.T * t, ONE)],
    )
    return (*found, slow)


def fastest() -> tuple[Identity, ...]:
    """Where the bounds on the rates are attained: for one entry of P, and for one of q.

    The target moves at right angles to the line of sight. If that is an axis, an entry of P has the
    rate w; if its angle is half of that of the sensor's position, S in size, an entry of q has
    the rate wS.

    Returns
    -------
    tuple of Identity
        Letters ``u v f h q``, ``D`` (rate of P), scalars ``c s w S``.
    """
    (d,) = letters("D", ("D",))
    w, size = scalars("w S")
    back = (U - C * F + S * H, V - S * F - C * H, C * C + S * S - ONE)
    twice = C * F + S * H  # a bearing's angle beyond f
    relations = (*FRAME[:3], *back, d + w * (F * H.T + H * F.T), Q - size * twice)
    words = (*FRAME_WORDS[:3], "u", "v", "s**2", "D", "q")
    goals = {
        "along f and h, P changes at the rate w": F.T * d * H + w,
        "the first entry of q rests": U.T * d * Q,
        "the second entry of q changes at the rate wS": V.T * d * Q + w * size,
        "S is the sensor's distance from the origin": Q.T * Q - size * size,
    }
    return _family(relations, words, goals)


def unbounded() -> tuple[Identity, ...]:
    """A target that passes a sensor closely enough exceeds every bound on the rates.

    Returns
    -------
    tuple of Identity
        Letters ``f h``, ``D`` (rate of P), scalars ``l w k`` (distance, angular speed, speed), ``g
        d`` (a bound, and what is left of the speed beyond bound times distance).
    """
    (d,) = letters("D", ("D",))
    w, speed, bound, more = scalars("w k g d")
    relations = (
        *FRAME,
        d + w * (F * H.T + H * F.T),
        L * w - speed,
        speed - bound * L - more,
    )
    words = (*FRAME_WORDS, "D", "l w", "k")
    goals = {"distance times (rate - bound) is d": -(L * (F.T * d * H)) - L * bound - more}
    return _family(relations, words, goals)


def rate_factors() -> tuple[Form, Form]:
    """What the squared angular speed is multiplied by to bound the squared rates of P and of q.

    Returns
    -------
    Form
        For an entry of P: DD less this times w^2 is zero in `rates`.
    Form
        For an entry of q, in the position ``q`` of the sensor: likewise for g'g.
    """
    goals = {entry.name: entry.goal for entry in rates()}
    names = ("DD = w^2 I", "|rate of q| = |w| |position|")
    for_p, for_q = (-goals[name].coefficient("w", 2) for name in names)
    return for_p, for_q
