"""How the claims about the experiment of section 5 are decided."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from verification.certificates.make import certificate
from verification.verdict import Decision, Verdict

from ..printed.claim_figures import steps_over_perturbations
from ..printed.looseness import Case
from ..stability.steps import decide_step, step_limit
from .common import disproof, limit_document, proofs

ALPHA, BETA = Fraction(1, 20), Fraction(3, 100)
VARIANCE = Fraction(225, 4)
"""tr Xi of a target in km^2."""


def targets(count: int, reading: str) -> dict[str, Any]:
    """Inputs of the questions about stability: `count` targets in a block, weights 1."""
    size = 2 * count
    half, zero = VARIANCE / 2, Fraction(0)
    return {
        "h": (Fraction(1),) * size,
        "H": None,
        "Xi": tuple(tuple(half if i == j else zero for j in range(size)) for i in range(size)),
        "eta": (zero,),
        "beta": BETA,
        "reading": reading,
        "k": Fraction(1),
        "alpha": ALPHA,
    }


def step_interval() -> Decision:
    """The sum of the six constants is too large."""
    summed, mean = (Fraction(1, 432) / least for least in (Fraction(1, 2), Fraction(1, 12)))
    return Decision(
        verdict=Verdict.REFUTED,
        reason="With K the sum of the six variances for a target, some sensor has M >= 1/2, for "
        f"all variances, and then mu/gamma <= 1/(432 M) <= {summed}; with the mean instead of the "
        f"sum it is at most {mean}. {ALPHA} is above both.",
        printed="0.05",
        sharp=f"below {summed}, or {mean} with the mean",
        printed_value=0.05,
        sharp_value=float(summed),
        margin_text=f"at least {float(ALPHA / summed):.3g} times too large, "
        f"{float(ALPHA / mean):.3g} times with the mean",
        certificates=disproof("section_5_step_interval"),
    )


def step_document(at: dict[str, Any]) -> dict[str, Any]:
    """The certificate at the printed step."""
    document = decide_step(at).certificate
    if document is None:
        raise ValueError("alpha: the step is not decided; one away from the limit is needed")
    return document


def stable_two_instants() -> Decision:
    """sigma/beta is 250."""
    name, counts = "cyclic_spsa.section_5_stable_two_instants", (6, 3, 1)
    made = {count: step_document(targets(count, "two")) for count in counts}
    limit, *others = (float(step_limit(targets(count, "two")).value) for count in counts)
    return Decision(
        verdict=Verdict.REFUTED,
        reason="Targets with weights 1 and sigma = 7.5 km, beta = 0.03 km: at 0.05 the second "
        "moments do not decay, by exact certificates for six targets, for three and for one at a "
        f"time. They do for steps below {limit:.5g}, {others[0]:.5g} and {others[1]:.5g} only, "
        "from the closed form for diagonal Hessians. For six and any weight h the mean "
        f"error is then multiplied by 1 - {limit:.3g} at best in an update. The printed figures "
        "cannot come from this algorithm with these parameters in km.",
        printed="0.05",
        sharp=f"below {limit:.5g}",
        printed_value=0.05,
        sharp_value=limit,
        margin_text=f"{0.05 / limit:.4g} times too large",
        certificates={name if n == 6 else f"{name}_{n}": entry for n, entry in made.items()},
        figure=steps_over_perturbations(
            Case(12, ALPHA, BETA, Fraction(53, 10), Fraction(0)),
            end=2.0,
            unit="km",
            marked="the printed parameters are",
        ),
    )


def stable_one_instant() -> Decision:
    """Neither noise nor beta enters."""
    at = targets(6, "one")
    limit, document = limit_document(at)
    return Decision(
        verdict=Verdict.PROVED,
        reason="With one instant the noise does not multiply the error, and for weights 1 the "
        f"second moments of twelve coordinates decay for every step below {limit:.6g}, by exact "
        "certificates of this limit and at 0.05.",
        printed="0.05",
        sharp=f"below {limit:.6g}",
        printed_value=0.05,
        sharp_value=limit,
        margin_text=f"{limit / 0.05:.3g} times as much would do",
        certificates={
            "cyclic_spsa.section_5_stable_one_instant": step_document(at),
            "cyclic_spsa.section_5_stable_one_instant_limit": document,
        },
    )


def few_targets() -> Decision:
    """A target has its turn less often."""
    return Decision(
        verdict=Verdict.PROVED,
        reason="An update multiplies the mean error by 1 - alpha h, in either reading, and each "
        "target is updated every 2k samples, k = 6/m_max: in twelve samples six times, three "
        "times or once.",
        printed="slower",
        sharp="(1 - alpha h)^(t/2k) after t samples",
        margin_text="k times as many samples",
        certificates=proofs("section_5_few_targets"),
    )


def settled(size: int, alpha: Fraction, h: Fraction, variance: Fraction) -> Fraction:
    """Mean square of the error that stays in a block of `size` coordinates at rest."""
    return alpha * h * size**2 * variance / (2 - alpha * h * size)


def most_targets() -> Decision:
    """Each coordinate of a block adds noise to all others."""
    h, variance = Fraction(1), VARIANCE / 2
    few, everything = (settled(size, ALPHA, h, variance) for size in (2, 12))
    inputs = {"alpha": ALPHA, "h": h, "variance": variance, "few": few, "all": everything}
    sizes = [float(value) ** 0.5 for value in (6 * few, everything)]
    rows = [("m_max", "mean square of all six, km^2", "root, km")]
    for count in (1, 2, 3, 6):
        total = 6 // count * settled(2 * count, ALPHA, h, variance)
        rows.append((str(count), str(total), f"{float(total) ** 0.5:.5g}"))
    return Decision(
        verdict=Verdict.REFUTED,
        reason="For six targets at rest with weights 1, alpha = 0.05 and one instant the error "
        f"that stays is {sizes[0]:.4g} km with one target at a time and {sizes[1]:.4g} km with "
        "six, as exact fixed points: the perturbations of the other coordinates act as noise. "
        "Moving fast, targets are followed better with more of them at a time.",
        printed="m_max = 6 is best",
        sharp="m_max = 1 is best for targets at rest",
        printed_value=sizes[1],
        sharp_value=sizes[0],
        margin_text=f"{sizes[1] / sizes[0]:.3g} times the smallest error",
        certificates={
            "cyclic_spsa.section_5_most_targets": certificate(
                "cyclic_spsa", "section_5_most_targets", inputs, [], "REFUTED"
            )
        },
        replay=tuple(rows),
    )


DECISIONS: Mapping[str, Callable[[], Decision]] = {
    "cyclic_spsa.section_5_step_interval": step_interval,
    "cyclic_spsa.section_5_stable_two_instants": stable_two_instants,
    "cyclic_spsa.section_5_stable_one_instant": stable_one_instant,
    "cyclic_spsa.section_5_few_targets": few_targets,
    "cyclic_spsa.section_5_most_targets": most_targets,
}
