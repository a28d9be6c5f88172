"""Figures of the claims about the cycle: which block is active when."""

from __future__ import annotations

from collections.abc import Callable

from theory.systems.cyclic_spsa.schedule import active, printed_active
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
