"""Spectral radius and energy growth of one step of (20), abscissa of (13), with certified bounds.

One step takes (x_k, u_k) to (x_{k+1}, u_{k+1}), where x_{k+1} = x_k + h u_k is what u_k means, and
u_{k+1} follows from the discrete Lagrange-d'Alembert equation at node k+1. It is kept as a pencil
E z+ = F z, so that M + hC is not inverted where that can be avoided.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from theory.algebra.block_matrices import coefficients
from theory.algebra.noncommuting import letters, scalars
from theory.systems.variational.block_form import ENERGY, LEFT, NOW, RIGHT
from theory.systems.variational.statements.common import EQUATION
from verification.answers import Answer
from verification.exact.evaluate import Rows, assembled
from verification.exact.spectra.abscissa import pencil_abscissa
from verification.exact.spectra.rayleigh import image_ratio
from verification.exact.spectra.spectral import Enclosure, pencil_radius

from .gains import definite_gains, positive_step

NARROW, USABLE = 1e-10, 1e-6
"""Relative widths above which a bracket is remarked on, and above which it gives no value."""

(STEP,) = scalars("h")
U, ACCELERATION, SPEED = letters("u a p")
CONTINUOUS = (
    SPEED - U,
    -EQUATION.substitute({"v": U - STEP * ACCELERATION}).coefficient("h", 1),
)
"""x' = p = u, and (20) at a vanishing step, in x, u and a = u': Ma + Cu + Kx = 0, (13)."""
CONTINUOUS_LEFT = coefficients(CONTINUOUS, ("p", "a"))
CONTINUOUS_RIGHT = -coefficients(CONTINUOUS, NOW)


def step_pencil(gains: Mapping[str, Rows], h: Fraction) -> tuple[Rows, Rows]:
    """E and F of one step E z+ = F z of (20), z = (x, u).

    Parameters
    ----------
    gains : mapping of str to Rows
        ``M``, ``K``, ``C``, n by n.
    h : Fraction
        Step, in the time unit of the gains.

    Returns
    -------
    E, F : Rows
        2n by 2n; E is not singular if M + hC is not.
    """
    return assembled(LEFT, gains, h), assembled(RIGHT, gains, h)


def energy_matrix(gains: Mapping[str, Rows]) -> Rows:
    """The matrix of the energy-like term (14) as a quadratic form in z = (x, u)."""
    return assembled(ENERGY, gains, Fraction(1))


def spectral_radius(values: Mapping[str, Any]) -> Answer:
    """Spectral radius of one step of (20).

    Parameters
    ----------
    values : mapping
        ``M``, ``K``, ``C``: exact symmetric positive definite matrices of one size; ``h``: a
        positive rational in the time unit of the gains.

    Returns
    -------
    Answer
        Certified bounds of relative width 1e-10 at most unless a note says otherwise.

    Raises
    ------
    InputError
        A gain is not symmetric positive definite, or h <= 0.
    """
    h, gains = positive_step(values), definite_gains(values)
    return _answer(pencil_radius(*step_pencil(gains, h)))


def energy_ratio(values: Mapping[str, Any]) -> Answer:
    """Largest factor by which the energy-like term (14) grows in one step of (20).

    Parameters, returns and errors are those of `spectral_radius`; the bounds' relative width is
    1e-12 at most unless a note says otherwise.
    """
    h, gains = positive_step(values), definite_gains(values)
    return _answer(image_ratio(*step_pencil(gains, h), energy_matrix(gains)))


def abscissa(values: Mapping[str, Any]) -> Answer:
    """Largest real part of an eigenvalue of the continuous estimator (12).

    Parameters
    ----------
    values : mapping
        ``M``, ``K``, ``C``: exact symmetric positive definite matrices of one size.

    Returns
    -------
    Answer
        In 1/s, negative. Certified bounds of relative width 1e-10 at most unless a note says
        otherwise.

    Raises
    ------
    InputError
        A gain is not symmetric positive definite.
    """
    gains = definite_gains(values)
    ends = (assembled(side, gains, Fraction(1)) for side in (CONTINUOUS_LEFT, CONTINUOUS_RIGHT))
    return _answer(pencil_abscissa(*ends))


def _answer(found: Enclosure) -> Answer:
    if found.lower is None or found.upper is None:
        return Answer(value=found.value, notes=(found.stage,))
    usable = found.width <= USABLE
    return Answer(
        value=found.value if usable else None,
        lower=found.lower,
        upper=found.upper,
        verdict="PROVED" if usable else "UNDECIDED",
        notes=(found.stage,) if found.width > NARROW else (),
    )
