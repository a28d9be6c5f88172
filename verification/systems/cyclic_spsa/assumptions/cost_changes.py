"""How a quadratic cost changes from one sample to the next, in the mean square.

The cost of a block is f_t(x) = (x - theta_t - xi_t)'H(x - theta_t - xi_t)/2. At x = theta_(t-1) + y
it changes by q - y'Hp with p = eta + xi_t - xi_(t-1).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from verification.exact.evaluate import Rows, add, dot, identity, multiply, quadratic, scaled, trace
from verification.exact.semidefinite import Split, split
from verification.exact.solving import solved

from ..block_inputs import Block


@dataclass(frozen=True)
class Change:
    """E(f_t(x) - f_(t-1)(x))^2 = y'Qy - 2 b'y + e at x = theta_(t-1) + y.

    Parameters
    ----------
    form : Rows
        Q.
    slope : tuple of Fraction
        b.
    level : Fraction
        e.
    printed : Fraction
        E(f_t(theta_t) - f_(t-1)(theta_(t-1)))^2, what Assumption 5 bounds as printed.
    """

    form: Rows
    slope: tuple[Fraction, ...]
    level: Fraction
    printed: Fraction


def change_of(block: Block, kurtosis: Fraction) -> Change:
    """How much the cost changes from one sample to the next, in the mean square.

    Parameters
    ----------
    block : Block
    kurtosis : Fraction
        Excess kurtosis of the noise's coordinates.
    """
    hessian, noise, eta = block.hessian, block.noise, block.drift
    pull = quadratic(eta, hessian)
    spread = _spread(block, kurtosis)
    drifts = tuple(tuple(a * b for b in eta) for a in eta)
    form = multiply(multiply(hessian, add(scaled(2, noise), drifts)), hessian)
    pulled = _times(hessian, eta)
    side = tuple(a + b * pull / 2 for a, b in zip(_times(noise, pulled), eta, strict=True))
    level = (pull**2 + 4 * quadratic(pulled, noise) + 2 * spread) / 4
    return Change(form, _times(hessian, side), level, spread / 2)


def _spread(block: Block, kurtosis: Fraction) -> Fraction:
    """Variance of xi'H xi."""
    product = multiply(block.hessian, block.noise)
    squares = sum((row[i] ** 2 for i, row in enumerate(product)), Fraction(0))
    return 2 * trace(multiply(product, product)) + kurtosis * squares


def _times(rows: Rows, x: Sequence[Fraction]) -> tuple[Fraction, ...]:
    return tuple(dot(row, x) for row in rows)


def offset(change: Change, c3: Fraction) -> tuple[Fraction | None, tuple[Fraction, ...], Split]:
    """The least c4 beside a c3, and where it is needed.

    Returns
    -------
    c4 : Fraction or None
        None where no c4 is enough.
    tuple of Fraction
        z with (c3 I - Q) z = b; a direction in which the change grows too fast where c4 is None.
    Split
        Of c3 I - Q.
    """
    rest = add(scaled(c3, identity(len(change.form))), change.form, -1)
    parts, slope = split(rest), change.slope
    if parts.vector is not None:
        return None, parts.vector, parts
    along = next((z for z in parts.kernel if dot(z, slope)), None)
    if along is not None:
        return None, along, parts
    small = [[rest[i][j] for j in parts.rows] for i in parts.rows]
    found = solved(small, [slope[i] for i in parts.rows]) if small else ()
    place = dict(zip(parts.rows, found or (), strict=True))
    z = tuple(place.get(i, Fraction(0)) for i in range(len(slope)))
    return change.level + dot(slope, z), z, parts


def gradient_power(block: Block) -> Fraction:
    """E|grad f(theta)|^2 = tr(H Xi H)."""
    return trace(multiply(multiply(block.hessian, block.noise), block.hessian))


def excess(change: Change, c3: Fraction, c4: Fraction, y: Sequence[Fraction]) -> Fraction:
    """By how much the mean square of the change is above c3 |y|^2 + c4."""
    mean = quadratic(y, change.form) - 2 * dot(change.slope, y) + change.level
    return mean - c3 * dot(y, y) - c4


def beyond(change: Change, c4: Fraction, z: Sequence[Fraction]) -> tuple[Fraction, ...]:
    """A multiple of z at which c4 is not enough; (c3 I - Q) z = 0 and b'z is not 0."""
    need = max(c4 - change.level + 1, Fraction(1))
    factor = -need / (2 * dot(change.slope, z))
    return tuple(factor * x for x in z)
