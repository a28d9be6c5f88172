"""What `bound` and `certify` offer about cyclic SPSA."""

from __future__ import annotations

from verification.answers import Condition, Quantity

from . import own_questions
from .block_inputs import ALPHA, BLOCK
from .errors.best_step import best_step
from .errors.random_walks import WALK, random_walk_mse
from .errors.stationary import BEST, MEAN, MEAN_SQUARE, stationary_mean, stationary_mse
from .network.measurement_moments import MEASUREMENT, measurement_moments
from .printed.beside import limit_beside_printed
from .printed.bounds import ERROR, INTERVAL, corrected_bound, printed_bound, printed_interval
from .stability.almost_sure import almost_sure_limit, lyapunov_exponent
from .stability.cycles import CYCLE, blocks_step_limit
from .stability.radius import spectral_radius
from .stability.steps import decide_step

QUANTITIES: tuple[Quantity, ...] = (
    Quantity(
        "step_limit",
        "supremum of alpha with mean-square stability",
        BLOCK,
        limit_beside_printed,
        True,
    ),
    Quantity(
        "blocks_step_limit",
        "the same for a cycle of blocks of whole targets",
        CYCLE,
        blocks_step_limit,
        True,
    ),
    Quantity(
        "spectral_radius",
        "of the second-moment operator of one update",
        (*BLOCK, ALPHA),
        spectral_radius,
        False,
    ),
    Quantity(
        "lyapunov_exponent",
        "limit of ln|error|/updates of one coordinate, Gaussian noise",
        (*BLOCK, ALPHA),
        lyapunov_exponent,
        False,
    ),
    Quantity(
        "almost_sure_limit",
        "supremum of alpha with the error of one coordinate dying out with probability 1",
        BLOCK,
        almost_sure_limit,
        False,
    ),
    Quantity(
        "printed_interval",
        "the set of steps that Theorem 1 prints",
        INTERVAL,
        printed_interval,
        False,
    ),
    Quantity(
        "printed_bound",
        "bound (21) on the root-mean-square error, as printed",
        ERROR,
        printed_bound,
        False,
    ),
    Quantity(
        "corrected_bound",
        "the bound that the proof of Theorem 1 gives once repaired",
        ERROR,
        corrected_bound,
        False,
    ),
    Quantity(
        "stationary_mean",
        "where the mean error right after an update settles",
        MEAN,
        stationary_mean,
        False,
    ),
    Quantity(
        "stationary_mse",
        "where the mean square of that error settles",
        MEAN_SQUARE,
        stationary_mse,
        True,
    ),
    Quantity(
        "best_step",
        "[alpha, root-mean-square error] where that mean square is least",
        BEST,
        best_step,
        False,
    ),
    Quantity(
        "random_walk_mse",
        "where the mean square error settles if the target makes random steps",
        WALK,
        random_walk_mse,
        False,
    ),
    Quantity(
        "measurement_moments",
        "[mean radial error, radial variance, tangential variance] of (13) at range 1",
        MEASUREMENT,
        measurement_moments,
        False,
    ),
    *own_questions.QUANTITIES,
)

CONDITIONS: tuple[Condition, ...] = (
    Condition(
        "step",
        "second moments of the error tend to zero at the step alpha",
        (*BLOCK, ALPHA),
        decide_step,
    ),
    *own_questions.CONDITIONS,
)
