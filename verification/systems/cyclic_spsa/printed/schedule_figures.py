"""Figures of the claims about the cycle: active blocks, ages of estimates, lags."""

from __future__ import annotations

from collections.abc import Callable

from theory.systems.cyclic_spsa.schedule import active, pairs, printed_active, printed_base
from verification.figure import Axis, Curve, Dots, Plot


def blocks_over_time(k: int, cycles: int) -> Plot:
    """The active block, and the printed index, from instant to instant.

    Parameters
    ----------
    k, cycles : int
    """
    last = 2 * k * cycles

    def stairs(index: Callable[[int, int], int]) -> tuple[tuple[float, ...], tuple[float, ...]]:
        x = [t + side for t in range(1, last + 1) for side in (-0.5, 0.5)]
        return tuple(x), tuple(float(index(k, t)) for t in range(1, last + 1) for _ in range(2))

    split = [t for t in range(2, last + 1, 2) if printed_active(k, t) != printed_active(k, t - 1)]
    return Plot(
        title=f"Active block of {k}, instant by instant",
        finding="The printed index changes within every pair of instants, the block between them.",
        caption="A pair, an odd instant and the even one after it, takes its two costs in one "
        "block. The printed index (dashed) changes in between: at the diamonds it is another one.",
        x=Axis("instant t", "", 0.5, last + 0.5),
        y=Axis("block", "", -0.3, k + 0.3, ticks=tuple(float(u) for u in range(k + 1))),
        curves=(
            Curve("sharp", *stairs(active), "block of the pair"),
            Curve("printed", *stairs(printed_active), "(t mod 2k) div 2"),
        ),
        dots=(
            Dots(
                "refuting",
                tuple(float(t) for t in split),
                tuple(float(printed_active(k, t)) for t in split),
                "",
            ),
        ),
    )


def age_of_the_base(k: int, cycles: int) -> Plot:
    """How old the estimate is around which the two points of a pair are taken.

    Parameters
    ----------
    k, cycles : int
    """
    every = list(pairs(k, cycles))
    t = tuple(float(pair.t) for pair in every)
    ages = tuple(float(pair.t - printed_base(pair)) for pair in every)
    last = every[-1].t
    return Plot(
        title=f"Age of the printed base point, {k} blocks",
        finding="The base grows older with every cycle, while each block is updated once in each.",
        caption=f"Each block has its last update 2k = {2 * k} instants before its turn (line). The "
        "printed base is older from the second cycle on, and ever more so.",
        x=Axis("instant t", "", 0.0, last + 1.0),
        y=Axis("age", "instants", 0.0, 1.15 * max(ages), ticks=(float(2 * k),)),
        curves=(
            Curve("sharp", (0.0, last + 1.0), (2.0 * k, 2.0 * k), "last update of the block"),
            Curve("printed", t, ages, "base of the pair"),
        ),
    )


def lag_of_steps(constant: float, updates: int) -> Plot:
    """Mean error behind a target that moves by 1 between updates, h = 1.

    Parameters
    ----------
    constant : float
        A step that stays; the other one is 1 over the number of the update.
    updates : int
    """
    falling, kept = [0.0], [0.0]
    for update in range(1, updates + 1):
        falling.append(falling[-1] * (1 - 1 / update) + 1)
        kept.append(kept[-1] * (1 - constant) + 1)
    number = tuple(float(k) for k in range(updates + 1))
    return Plot(
        title="Mean lag behind a target that moves by 1 between updates",
        finding="With steps that decrease the lag grows for ever; with a constant one it settles.",
        caption=f"Steps 1, 1/2, 1/3, ... (dashed) fall behind; the constant step {constant:g} "
        f"settles at a lag of {1 / constant:g}, drift over step.",
        x=Axis("update", "", 0.0, float(updates)),
        y=Axis("lag", "moves", 0.0, 1.1 * max(falling), ticks=(1 / constant,)),
        curves=(
            Curve("sharp", number, tuple(kept), f"constant {constant:g}"),
            Curve("printed", number, tuple(falling), "1/T"),
        ),
    )
