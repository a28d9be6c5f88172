"""Exact runs and exact steps as figures: agreement against its bounds, chattering against none."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import pairwise

from sensortrack.networks import Network
from verification.exact.cuts.extreme import slowest
from verification.exact.rationals import nearest
from verification.exact.runs.filippov import Phase, Run, filippov_run
from verification.exact.runs.prox import Numbers, centred, explicit_step, implicit_step
from verification.figure import Axis, Curve, Plot

from .network_inputs import squared_norm
from .rates import printed_time

BETWEEN = 8
"""Points in which the norm over a straight piece, an arc of a hyperbola, is drawn."""

Line = tuple[tuple[float, ...], tuple[float, ...]]


def norm_over_time(run: Run, between: int = BETWEEN) -> Line:
    """Times and norms of the error, ready to be drawn.

    Parameters
    ----------
    run : Run
    between : int, optional
        Into how many stretches each straight piece is cut.

    Returns
    -------
    times, norms : tuple of float
    """
    times = list(run.times)
    marks = [
        start + (stop - start) * k / between
        for start, stop in pairwise(times)
        for k in range(between)
    ]
    marks.append(times[-1])
    points = [run.at(mark) for mark in marks]
    return tuple(map(nearest, marks)), tuple(norm(point) for point in points)


def entries_over_time(run: Run) -> tuple[Line, ...]:
    """Times and values of the error at each node: exact corners, straight lines between them."""
    times = tuple(map(nearest, run.times))
    return tuple((times, tuple(map(nearest, values))) for values in zip(*run.points, strict=True))


def norm(point: Sequence[Fraction]) -> float:
    """The length of a vector."""
    return math.sqrt(nearest(squared_norm(point)))


def agreement_plot(
    network: Network,
    gamma: Numbers,
    beta: Fraction,
    x0: Numbers,
    phases: Sequence[Phase] | None = None,
) -> Plot:
    """The error of one exact run below its proved bound, beside the printed time.

    Parameters
    ----------
    network : Network
        Connected.
    gamma : sequence of Fraction, length n
        Bounds on the disturbance, which `phases` keep to.
    beta : Fraction
        Gain above the threshold.
    x0 : sequence of Fraction, length n
        Not all the same.
    phases : sequence of (Fraction, sequence of Fraction), optional
        The disturbance; none by default.

    Returns
    -------
    Plot

    Raises
    ------
    ValueError
        No rate can be proved at this gain.
    """
    run = filippov_run(network, beta, x0, phases)
    found = slowest(network, gamma, beta, x0)
    if found.upper is None:
        raise ValueError(f"beta: {beta}; a gain above the threshold is needed")
    size, bound = norm(run.points[0]), math.sqrt(nearest(found.upper))
    printed = printed_time(network, [squared_norm(run.points[0])])
    late = nearest(run.times[-1] if run.agreement is None else run.agreement)
    end = 1.1 * max(late, bound, printed or 0.0)
    curves = [
        Curve("bound", (0.0, bound, end), (size, 0.0, 0.0), "proved bound"),
        Curve("run", *norm_over_time(run), "this run"),
    ]
    if printed is not None:
        curves.append(Curve("printed", (printed,) * 2, (0.0, size), f"printed t* {printed:.4g}"))
    agreed = "does not agree in the time shown"
    if run.agreement is not None:
        agreed = f"agrees at t = {late:.5g}"
    return Plot(
        title=f"Disagreement of {network.n} sensors at the gain {beta}",
        finding=f"This run {agreed}; from its start every run agrees by {bound:.5g}.",
        caption="The norm of the error, followed exactly from event to event, below the straight "
        "line that no admissible disturbance crosses.",
        x=Axis("time", "s", 0.0, end, ticks=(bound,)),
        y=Axis("norm of the error", "c", 0.0, 1.1 * size),
        curves=tuple(curves),
    )


Step = Callable[[Network, Numbers, Fraction], tuple[Fraction, ...]]


def stepped(
    network: Network, x0: Numbers, length: Fraction, count: int, step: Step
) -> list[tuple[Fraction, ...]]:
    """The errors that a start and a number of steps give, exactly.

    Parameters
    ----------
    network : Network
    x0 : sequence of Fraction, length n
        Projected to mean zero in each component.
    length : Fraction
        Step times gain.
    count : int
    step : callable
        `explicit_step` or `implicit_step`.

    Returns
    -------
    list of tuple of Fraction
        `count` + 1 errors.
    """
    points = [tuple(centred(network, x0))]
    for _ in range(count):
        points.append(step(network, points[-1], length))
    return points


def chattering_plot(network: Network, length: Fraction, x0: Numbers, count: int) -> Plot:
    """Norms of the error under explicit and implicit steps from one start.

    Parameters
    ----------
    network : Network
    length : Fraction
        Step times gain.
    x0 : sequence of Fraction, length n
    count : int
        Number of steps.

    Returns
    -------
    Plot
    """
    number = tuple(float(k) for k in range(count + 1))
    explicit, implicit = (
        tuple(map(norm, stepped(network, x0, length, count, step)))
        for step in (explicit_step, implicit_step)
    )
    rest = explicit[count // 2 :]
    reached = next((k for k, size in enumerate(implicit) if not size), None)
    agreed = "do not agree yet" if reached is None else f"agree exactly after {reached}"
    return Plot(
        title=f"Disagreement of {network.n} sensors, step by step",
        finding=f"In the second half explicit steps disagree by {min(rest):.3g} to "
        f"{max(rest):.3g}; implicit ones {agreed}.",
        caption=f"From one start, step times gain {length}; exact arithmetic, so that what is left "
        "is the scheme's and not rounding.",
        x=Axis("step", "", 0.0, float(count)),
        y=Axis("norm of the error", "c", 0.0, 1.1 * max(explicit[0], *explicit) or 1.0),
        curves=(
            Curve("printed", number, explicit, "explicit"),
            Curve("sharp", number, implicit, "implicit"),
        ),
    )
