"""Theorem 2 as data: what it promises as printed for the sensor that measures targets.

The weights of the cost are K/(n sigma^2); ``high`` and ``low`` are the largest and the smallest
sigma^2, ``ratio`` is the largest tr Xi/sigma^2, and ``level`` the printed sum of
M_4/sigma_t^4 + M_4/sigma_(t-1)^4 - 2 over the targets. With c1 = c3 = c_v = 0 left out.

References
----------
V. Erofeeva, O. Granichin, Theorem 2 and appendix A.
"""

from __future__ import annotations

from .bounds import GIVEN, PRINTED, Bound, Definition

GIVEN_2: dict[str, str] = {
    **{name: GIVEN[name] for name in ("d", "k", "root_d", "root_k", "alpha", "beta", "delta")},
    "K": "F",
    "n": "1",
    "high": "L^2",
    "low": "L^2",
    "ratio": "1",
    "level": "1",
}
"""Unit of each number that Theorem 2 speaks of, as in `bounds.GIVEN`."""


def _as_printed(name: str) -> Definition:
    """A line that Theorem 2 shares with Theorem 1."""
    return next(line for line in PRINTED.definitions if line.name == name)


MU = Definition("mu", "K/(2*n*high)", "F/L^2")
LIPSCHITZ = Definition("M", "K/(2*n*low)", "F/L^2")
C2 = Definition("c2", "K/(2*n)*ratio", "F^2/L^2")
C4 = Definition("c4", "K/(2*n)*level", "F^2")
GAMMA = Definition("gamma", "3*d**2*M**2", "F^2/L^4")
REACH = "M**2*(delta + 2*beta*root_d)**2"
L_BAR = f"6*d*alpha/beta*c4 + 6*d**2*(c2 + {REACH} + 2*delta*lag)"
"""As printed: alpha is missing before 6 d^2, whose bracket is closed after the drift."""
NESTED = f"6*d*alpha/beta*c4 + 6*alpha*d**2*(c2 + {REACH}) + 2*delta*lag"
"""As in Theorem 1."""

PRINTED_2 = Bound(
    limit=(MU, LIPSCHITZ, GAMMA, _as_printed("limit")),
    lines=(
        _as_printed("m"),
        _as_printed("b"),
        C2,
        C4,
        _as_printed("lag"),
        Definition("l_bar", L_BAR, "F"),
        _as_printed("l"),
        _as_printed("q"),
    ),
    value=_as_printed("bound"),
)
"""The bound of Theorem 2, word for word, without the arbitrary epsilon."""
