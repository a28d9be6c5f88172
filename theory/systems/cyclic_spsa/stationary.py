"""Where the error settles: its mean and second moment, derived from one update.

One update is a+ = M a + m - c with the random matrix M and the noise m = (1 - M) chi, c = 2k eta
being the target's next move. The mean therefore settles at the solution of H abar = -c/alpha, and
the covariance C = E (a - abar)(a - abar)' at that of

    C = L(C) + L(abar abar') - E M abar abar' E M' + E m m',

L(P) = E MPM': nothing mixes with m in the mean, because every law of the noise that is symmetric
makes its odd moments zero. If chi is independent of M, as for Gaussian noise or with one instant,
E m m' = E (1 - M) Z (1 - M)' with Z = E chi chi'; otherwise the fourth moments of the noise add g
times the identity, see `excess`.

With K(Q) = tr(Q) I + tr(QN) I + 2Q - 2 diag(Q) and Habar = -c/alpha, and divided by alpha,

    HC + CH - alpha K(HCH) = R0/alpha + alpha R2,   R0 = K(cc') - cc',   R2 = K(HZH) + g I.

For a stable step and R >= 0 on the right the solution is the sum over j >= 0 of alpha^j (pull^-1
kick)^j pull^-1 R, every term >= 0, with pull(P) = HP + PH and kick(P) = K(HPH).
"""

from __future__ import annotations

from fractions import Fraction

from ...algebra.moments.laws import SymmetricLaw
from ...algebra.noncommuting import Form, letters
from .error import RANDOM, SYMMETRIC, error_step, read, second_moment

P, Q, H = letters("P Q H", SYMMETRIC)


def mean_step(instants: int = 2) -> Form:
    """E M, the identity being the empty word."""
    return RANDOM.mean(error_step(instants).step).substitute({"I": read("1")})


def own_noise(instants: int) -> bool:
    """Whether what is left of an update at a = 0 is (1 - M) chi."""
    found = error_step(instants)
    (chi,) = letters("chi")
    return _ordered(found.offset) == _ordered((read("1") - found.step) * chi)


def _ordered(form: Form) -> Form:
    """The same form with x'Hy, a number, always written with its two ends in one order."""
    terms: dict[object, Fraction] = {}
    for (factors, (head, *ends)), a in form.terms.items():
        x, middle, y = ends
        left, right = sorted((x.rstrip("'"), y))
        key = (factors, (head, f"{left}'", middle, right))
        terms[key] = terms.get(key, Fraction(0)) + a
    return Form({key: a for key, a in terms.items() if a}, form.symmetric)  # type: ignore[misc]


def kick_of_noise() -> Form:
    """E (1 - M) P (1 - M)' over alpha^2, in Q = HPH."""
    found = RANDOM.second_moment(read("1") - error_step(2).step, P)
    return found.coefficient("alpha", 2)


def kick_of_mean() -> Form:
    """L(P) - E M P E M' over alpha^2, in Q = HPH."""
    mean = mean_step()
    spread = second_moment() - mean * P * mean.T
    return spread.coefficient("alpha", 2) + (H * P * H - Q)


def excess(law: SymmetricLaw) -> Fraction:
    """g beta^2 over the sum of the B_ii^2, where the entries of e are of this law.

    nu'H chi has the random part (xi'H xi - xi_before'H xi_before)/(4 beta), whose variance is
    Var(xi'H xi)/(8 beta^2). With xi = Xi^(1/2) e and B = Xi^(1/2) H Xi^(1/2), xi'H xi = e'Be has
    the variance 2 tr B^2 + (E e^4 - 3) sum of B_ii^2; the Gaussian law has no second term.

    Parameters
    ----------
    law : SymmetricLaw
        Of variance 1.
    """
    return law.excess / 8
