"""Constants of Assumptions 1 to 5 where each sample has any of several quadratic costs.

If the Hessian can change from one sample to the next, the change of the cost grows like the fourth
power of the distance in the mean square, and no c3 and c4 are enough: weights in (20) that are
updated break Assumption 5.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import permutations
from typing import Any

from sensortrack.errors import InputError
from verification.answers import Answer, Input
from verification.certificates.make import certificate
from verification.exact.evaluate import add, dot, identity, multiply, quadratic, trace
from verification.exact.rationals import above, below
from verification.exact.semidefinite import split

from ..block_inputs import Block
from .constants import (
    MOVED,
    NAMES,
    cost_of,
    drift_bounds,
    largest_ratio,
    matrix_item,
    semidefinite_items,
)
from .cost_changes import gradient_power
from .quadratic_costs import refuted

COSTS = Input(
    "costs",
    "matrices",
    "instead of h or H: Hessians, any of which a sample may have",
    optional=True,
)
UNLIKE = (
    "no c3 and c4 are enough: from one Hessian to another, the mean square of the change grows "
    "like the fourth power of |x - theta|"
)
OVER_ALL = "mu, M and c2 are the worst of all Hessians of the list"
ZERO = Fraction(0)


def of_costs(values: Mapping[str, Any]) -> Answer:
    """[mu, M, c2, c3, c4, delta] where each sample has any cost of the list.

    Raises
    ------
    InputError
        As `blocks_of`, or c3 is given.
    """
    if values["c3"] is not None:
        raise InputError("c3", "given beside a list of costs", "one cost is needed for it")
    blocks, _ = blocks_of(values)
    eye = identity(blocks[0].size)
    tops = [largest_ratio(block.hessian, eye) for block in blocks]
    bottoms = [largest_ratio(eye, block.hessian) for block in blocks]
    power = max(map(gradient_power, blocks))
    least, most = drift_bounds(blocks[0])
    lower = [
        *(below(1 / max(x[1] for x in bottoms)), below(max(x[0] for x in tops)), below(power)),
        *(math.inf, math.inf, below(least) + 0.0),
    ]
    upper = [
        *(above(1 / max(x[0] for x in bottoms)), above(max(x[1] for x in tops)), above(power)),
        *(math.inf, math.inf, above(most) + 0.0),
    ]
    value = [a if a == b else (a + b) / 2 for a, b in zip(lower, upper, strict=True)]
    return Answer(
        value=value,
        lower=lower,
        upper=upper,
        verdict="PROVED",
        notes=(OVER_ALL, UNLIKE, MOVED),
    )


def decide_costs(values: Mapping[str, Any], constants: Sequence[Fraction]) -> Answer:
    """Refute constants for costs that change: the first that is none, at last c3.

    Raises
    ------
    InputError
        As `blocks_of`.
    """
    blocks, kurtosis = blocks_of(values)
    for block in blocks:
        failed = refuted(block, kurtosis, constants, changing=False)
        if failed is not None:
            return failed
    given = dict(zip(NAMES, constants, strict=True))
    now, before = next((a, b) for a, b in permutations(blocks, 2) if a.hessian != b.hessian)
    y = _far(now, before, given["c3"], given["c4"])
    data: dict[str, Any] = {"H": now.hessian, "G": before.hessian, "Xi": now.noise}
    data |= {"eta": [[x] for x in now.drift], "c3": given["c3"], "c4": given["c4"]}
    witness = [matrix_item([[x] for x in y]), *semidefinite_items(split(now.noise))]
    document = certificate("cyclic_spsa", "assumptions_of_two", data, witness, "REFUTED")
    return Answer(verdict="REFUTED", certificate=document, notes=(f"c3: {UNLIKE}",))


def _far(now: Block, before: Block, c3: Fraction, c4: Fraction) -> tuple[Fraction, ...]:
    """y where the mean of the change, squared, is above c3 |y|^2 + c4."""
    rest, size = add(now.hessian, before.hessian, -1), range(now.size)
    units = identity(now.size)
    sums = [
        tuple(a + b for a, b in zip(units[i], units[j], strict=True)) for i in size for j in size
    ]
    z = next(x for x in sums if quadratic(x, rest))
    pulled = tuple(dot(row, now.drift) for row in now.hessian)
    level = dot(pulled, now.drift) + trace(multiply(rest, now.noise))
    while True:
        mean = quadratic(z, rest) - 2 * dot(pulled, z) + level
        if mean**2 > 4 * (c3 * dot(z, z) + c4):
            return z
        z = tuple(2 * x for x in z)


def blocks_of(values: Mapping[str, Any]) -> tuple[tuple[Block, ...], Fraction]:
    """The costs of the list, and the kurtosis of the noise.

    Raises
    ------
    InputError
        As `cost_of`; a Hessian or bounds on it are given beside the list; the sizes differ, or the
        costs do not.
    """
    for name in ("h", "H", "low", "high"):
        if values[name] is not None:
            raise InputError(name, "given beside costs", "one of the two is needed")
    costs = values["costs"]
    if len({len(rows) for rows in costs}) > 1:
        sizes = ", ".join(str(len(rows)) for rows in costs)
        raise InputError("costs", f"Hessians of sizes {sizes}", "one size is needed")
    if len({*costs}) == 1:
        raise InputError("costs", "one Hessian only", "two that differ are needed, or H")
    found = []
    for number, rows in enumerate(costs, start=1):
        try:
            found.append(cost_of({**values, "h": None, "H": rows}))
        except InputError as error:
            if error.name != "H":
                raise
            raise InputError("costs", f"number {number}: {error.found}", error.needed) from None
    return tuple(block for block, _ in found), found[0][1]
