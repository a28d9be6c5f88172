"""Figures of the claims about the theorems: errors and steps, exact, printed and proved."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from sensortrack.simulation.spsa_batch import SpsaBatch
from theory.systems.cyclic_spsa.bounds import PRINTED, PROVED, Bound, evaluated
from verification.figure import Area, Axis, Curve, Dots, Plot

from ..errors.best_step import best_step
from .looseness import Case, case, compared

Floats = tuple[float, ...]
STEPS = 25
GRID, RUNS, UPDATES, FAR = 6, 2000, 20, 1e5
"""Of what is simulated: points on each axis, runs, updates, start in sizes of noise and drift."""
MOVING = case(2, "0.001", "1", "0.1", "0.1")


def errors_over_steps(chosen: Case = MOVING, low: float = -4.0) -> Plot:
    """Exact error of a moving target, printed and proved bound, over the step.

    Parameters
    ----------
    chosen : Case, optional
        Its own step does not count.
    low : float, optional
        Logarithm of the smallest step.
    """
    steps = np.geomspace(10.0**low, 0.97 * float(chosen.limit), STEPS)
    rows = compared([replace(chosen, alpha=_short(a)) for a in steps])
    x: Floats = tuple(float(row.case.alpha) for row in rows)
    exact = tuple(row.exact for row in rows)
    best, least = (float(value) for value in best_step(chosen.block()).value)
    promised = [value for row in rows for value in (row.printed, row.corrected)]
    every = [value for value in (*exact, *promised) if value < np.inf]
    below = [k for k, row in enumerate(rows) if row.printed < row.exact]
    return Plot(
        title="Error of a moving target over the step, and what is promised",
        finding="The printed bound lies below the exact error for small steps, the proved one "
        "above it and close; both end long before the step of the smallest error.",
        caption=f"Two coordinates, Hessian 1, beta = {float(chosen.beta):g} m, noise "
        f"{float(chosen.sigma):g} m in each coordinate, drift {float(chosen.delta):g} m a sample; "
        "where the printed bound is below the error the claim is false (hatched). Bounds are drawn "
        f"within their intervals; the error is least, {least:.3g} m, at alpha = {best:.3g}.",
        x=Axis("step alpha", "", x[0], x[-1], log=True, ticks=(float(f"{best:.2g}"),)),
        y=Axis("root-mean-square error", "m", min(every) / 2, max(every) * 2, log=True),
        curves=(
            Curve("sharp", x, exact, "exact"),
            _within("printed", x, [row.printed for row in rows], "printed"),
            _within("bound", x, [row.corrected for row in rows], "proved"),
        ),
        areas=(
            Area(
                "false",
                tuple(x[k] for k in below),
                tuple(rows[k].printed for k in below),
                tuple(exact[k] for k in below),
            ),
        )
        if len(below) > 1
        else (),
        dots=(Dots("held", (best,), (least,), "best"),),
    )


def _short(step: float) -> Fraction:
    return Fraction(float(step)).limit_denominator(10**9)


def _within(role: str, x: Floats, y: Sequence[float], label: str) -> Curve:
    """The finite part of a bound, which is infinite beyond its interval."""
    kept = [(a, b) for a, b in zip(x, y, strict=True) if b < np.inf]
    return Curve(role, tuple(a for a, _ in kept), tuple(b for _, b in kept), label)


def limit(bound: Bound, given: dict[str, Fraction]) -> Fraction:
    """mu/gamma."""
    values = dict(given)
    for line in bound.limit:
        values[line.name] = evaluated(line.tree, values)
    return Fraction(values[bound.limit[-1].name])


def steps_over_perturbations(
    chosen: Case, end: float = 1.0, marked: str = "the counterexample is", unit: str = ""
) -> Plot:
    """Steps for which the mean-square error stays bounded, over the size of the perturbation.

    Parameters
    ----------
    chosen : Case
        Its step and its size of the perturbation are marked.
    end : float, optional
        Logarithm of the largest size.
    marked : str, optional
        What the marked point is, with its verb.
    unit : str, optional
        Of lengths, where it matters.
    """
    sizes = np.geomspace(float(chosen.beta) / 10, 10.0**end, 40)
    cases = [
        Case(chosen.d, chosen.alpha, Fraction(float(b)), chosen.sigma, chosen.delta, chosen.k)
        for b in sizes
    ]
    exact = tuple(float(entry.limit) for entry in cases)
    printed = tuple(float(limit(PRINTED, entry.constants())) for entry in cases)
    proved = tuple(float(limit(PROVED, entry.constants_at_every_point())) for entry in cases)
    x: Floats = tuple(sizes.tolist())
    low, top = min(proved) / 2, 3 * max(*exact, *printed)
    wrong = tuple(max(a, b) for a, b in zip(exact, printed, strict=True))
    coordinates = "One coordinate" if chosen.d == 1 else f"{chosen.d} coordinates"
    here, of_length = (float(chosen.beta), float(chosen.alpha)), f" {unit}" if unit else ""
    return Plot(
        title="Steps for which the mean-square error stays bounded",
        finding="The printed limit does not fall with the perturbation; the exact one falls as its "
        "square.",
        caption=f"{coordinates}, Hessian 1, noise {float(chosen.sigma):g}{of_length} in each and "
        f"drift {float(chosen.delta):g}{of_length} a sample, two instants: below the exact limit "
        "the error stays bounded; between it and the limit of Theorem 1 as printed (hatched) that "
        f"theorem is false; the steps of the repaired theorem are shaded; {marked} marked. "
        f"Simulated: the mean square of {RUNS} runs from afar falls (dots) or grows (rings) in "
        f"{UPDATES} updates.",
        x=Axis("size of the perturbation beta", unit, x[0], x[-1], log=True, ticks=(here[0],)),
        y=Axis("step alpha", "", low, top, log=True, ticks=(here[1],)),
        curves=(
            Curve("sharp", x, exact, "exact"),
            Curve("printed", x, printed, "printed"),
            Curve("bound", x, proved, "proved"),
        ),
        areas=(
            Area("false", x, exact, wrong),
            Area("proved", x, (low,) * len(x), proved),
        ),
        dots=(
            *simulated(chosen, np.geomspace(here[0], x[-1] / 2, GRID), (2 * low, top / 2)),
            Dots("refuting", (here[0],), (here[1],)),
        ),
    )


def simulated(chosen: Case, sizes: NDArray[np.float64], ends: tuple[float, float]) -> list[Dots]:
    """Where the mean square of runs from far away falls, and where it grows.

    Parameters
    ----------
    chosen : Case
        Its step and its size of the perturbation do not count.
    sizes : array (n,)
        Sizes of the perturbation.
    ends : tuple of float
        Smallest and largest step of the grid.
    """
    far = FAR * float(chosen.sigma + chosen.delta)
    sides = np.where(np.arange(RUNS) % 2, far, -far)  # so that the drift speaks for neither
    found: dict[str, list[tuple[float, float]]] = {"held": [], "failed": []}
    for beta, alpha in itertools.product(sizes, np.geomspace(*ends, GRID)):
        batch = SpsaBatch(
            [1.0] * chosen.d,
            alpha,
            beta,
            noise=float(chosen.sigma) ** 2,
            drift=[float(chosen.delta)] + [0.0] * (chosen.d - 1),
        )
        run = batch.run(RUNS, UPDATES, start=np.repeat(sides[:, None], chosen.d, axis=1))
        grows = run.curve[0][-1] > chosen.d * far**2
        found["failed" if grows else "held"].append((float(beta), float(alpha)))
    return [
        Dots(role, tuple(beta for beta, _ in dots), tuple(alpha for _, alpha in dots))
        for role, dots in found.items()
    ]
