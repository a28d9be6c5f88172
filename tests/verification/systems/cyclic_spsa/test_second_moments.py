"""Second moments by elimination and enclosed from floating point: one answer, proved both ways."""

from fractions import Fraction

import flint
import numpy as np
import pytest

from verification.systems.cyclic_spsa.block_inputs import Block
from verification.systems.cyclic_spsa.errors.direct_moments import DirectMoments
from verification.systems.cyclic_spsa.errors.enclosed_moments import BallMoments
from verification.systems.cyclic_spsa.errors.second_moments import BITS, moments_of
from verification.systems.cyclic_spsa.errors.settling import Settling, mean_square, slope
from verification.systems.cyclic_spsa.errors.solutions import TooClose
from verification.systems.cyclic_spsa.stability.moments import fmpq


def block(d, seed=0, diagonal=False, instants=2):
    rng = np.random.default_rng(seed)
    half, other = rng.integers(-5, 6, (2, d, 2 * d))
    hessian, noise = half @ half.T + np.eye(d, dtype=int), other @ other.T
    if diagonal:
        hessian = np.diag(np.diag(hessian))
    rows = [
        tuple(tuple(Fraction(int(x)) for x in row) for row in part) for part in (hessian, noise)
    ]
    drift = tuple(Fraction(int(x), 7) for x in rng.integers(-5, 6, d))
    return Block(rows[0], "H", rows[1], drift, Fraction(9), instants, 2)


def step(of, part=Fraction(1, 3)):
    """A stable step: this part of a bound from the trace."""
    trace = sum(of.hessian[i][i] for i in range(of.size))
    return part / trace / (1 + sum(of.noise[i][i] for i in range(of.size)) / of.beta**2)


@pytest.mark.parametrize("d", [1, 2, 4])
@pytest.mark.parametrize("law", ["gaussian", "two_point"])
def test_balls_hold_the_exact_numbers(d, law):
    of = block(d, seed=d)
    alpha, settling = step(of), Settling(of, law)
    with flint.ctx.workprec(BITS):
        exact = DirectMoments(of, alpha)
        for other in (DirectMoments(of, alpha, exact=False), BallMoments(of, alpha)):
            for number in (mean_square, slope):
                ball = flint.arb(number(settling, other))
                wanted = flint.arb(number(settling, exact))
                assert ball.overlaps(wanted)
                assert ball.rad() < abs(ball.mid()) * 1e-30


def test_diagonal_closed_form_is_the_elimination_of_all_entries():
    of = block(4, diagonal=True)
    alpha = step(of)
    moments, side = DirectMoments(of, alpha), fmpq(of.noise)
    found = moments.solved(side).matrix
    assert found == moments._full(side)
    operators, size = moments.operators, flint.fmpq(alpha.numerator, alpha.denominator)
    assert operators.pull(found) - operators.kick(found) * size == side


@pytest.mark.parametrize("instants", [1, 2])
@pytest.mark.parametrize("law", ["gaussian", "two_point"])
def test_slope_is_the_derivative(instants, law):
    of = block(2, seed=5, instants=instants)
    settling, alpha, part = Settling(of, law), step(of), Fraction(1, 10**15)
    with flint.ctx.workprec(BITS):
        before, after = (
            flint.arb(mean_square(settling, DirectMoments(of, alpha * (1 + sign * part))))
            for sign in (-1, 1)
        )
        width = flint.arb(flint.fmpq(2 * (alpha * part).numerator, (alpha * part).denominator))
        wanted = float((after - before) / width)
        assert float(flint.arb(slope(settling, DirectMoments(of, alpha)))) == pytest.approx(
            wanted, rel=1e-12
        )


@pytest.mark.parametrize("d", [2, 5])
def test_both_ways_agree_on_what_is_stable(d):
    of = block(d, seed=1)
    low, high = step(of), Fraction(2 * d) / sum(of.hessian[i][i] for i in range(d))
    for _ in range(25):
        alpha = (low + high) / 2
        exact, balls = DirectMoments(of, alpha).stable, BallMoments(of, alpha)
        with flint.ctx.workprec(BITS):
            assert balls.stable == exact
        low, high = (alpha, high) if exact else (low, alpha)


def test_krylov_takes_over_where_the_multiplication_is_by_zero():
    # alpha times the largest eigenvalue is 1: h + h - 2 alpha h h vanishes for it
    line = (Fraction(3, 5), Fraction(4, 5), Fraction(0))
    hessian = tuple(
        tuple(Fraction(9, 10) * x * y + Fraction(i == j, 10) for j, y in enumerate(line))
        for i, x in enumerate(line)
    )
    nothing = ((Fraction(0),) * 3,) * 3
    of = Block(hessian, "H", nothing, (Fraction(1, 7),) * 3, Fraction(9), 2, 1)
    settling = Settling(of)
    with flint.ctx.workprec(BITS):
        exact, balls = (kind(of, Fraction(1)) for kind in (DirectMoments, BallMoments))
        assert exact.stable
        assert balls.stable
        found = flint.arb(mean_square(settling, balls))
        assert found.overlaps(flint.arb(mean_square(settling, exact)))
        assert found.rad() < 1e-20 * abs(found.mid())


def test_balls_leave_open_what_is_at_the_limit():
    one = ((Fraction(1), Fraction(9, 10)), (Fraction(9, 10), Fraction(1)))
    none = ((Fraction(0),) * 2,) * 2
    of = Block(one, "H", none, (Fraction(0),) * 2, Fraction(1), 1, 1)
    limit = Fraction(10, 19)
    assert not DirectMoments(of, limit).stable
    with flint.ctx.workprec(BITS), pytest.raises(TooClose):
        _ = BallMoments(of, limit).stable


def test_way_depends_on_size_and_shape():
    alpha = Fraction(1, 10**6)
    assert isinstance(moments_of(block(13), alpha), BallMoments)
    assert isinstance(moments_of(block(13, diagonal=True), alpha), DirectMoments)
    assert isinstance(moments_of(block(3), alpha), DirectMoments)
