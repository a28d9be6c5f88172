"""How the claims about measurement noise are decided."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

from verification.certificates.make import certificate
from verification.verdict import Decision, Verdict

from ..claim_figures import readings_over_time, velocity_variance
from ..noise_gains import noise_gain
from .discrete import SAMPLE_STEP, UNIT_GAINS
from .witnesses import derivation

DRIFT_SAMPLES = 5


def velocity_noise() -> Decision:
    """The velocity estimate is never better than the raw average, in any direction."""
    document = certificate(
        "variational",
        "section_3_velocity_noise",
        {},
        [derivation((("1", "p", "W"),))],
        case="REFUTED",
    )
    answer = noise_gain({**UNIT_GAINS, "h": SAMPLE_STEP})
    gain = float(answer.value[2])
    return Decision(
        verdict=Verdict.REFUTED,
        reason="The internal state does not know the newest velocity noise, so that its "
        "variance is "
        "added to that of the noise in every direction, for all gains and steps.",
        printed="variance below 1",
        sharp=f"variance {gain:.5g} at M = K = C = 1, h = 1/10",
        printed_value=1.0,
        sharp_value=gain,
        margin_text=f"{gain - 1:.2%} more than the raw average",
        figure=velocity_variance(),
        relies_on=tuple(document["relies_on"]),
        certificates={"variational.section_3_velocity_noise": document},
    )


def robust_reading_a() -> Decision:
    """A stable recursion with bounded input."""
    document = certificate(
        "variational",
        "section_3_robust_reading_a",
        {},
        [
            derivation((("h", "1", "C"),)),
            derivation((("2", "1", "M"), ("h", "1", "C"))),
            derivation((("h**2", "1", "K"),)),
            derivation((("1", "1", "Q"),), ("-1", "0", "1")),
        ],
    )
    return Decision(
        verdict=Verdict.PROVED,
        reason="The free errors tend to zero at every step below the limit, by Jury's "
        "conditions as "
        "identities, and noise enters linearly; how large the errors get, the quantities peak_gain "
        "and noise_gain say.",
        printed="bounded",
        sharp="bounded",
        margin_text="holds below the step limit",
        relies_on=tuple(document["relies_on"]),
        certificates={"variational.section_3_robust_reading_a": document},
    )


def robust_reading_b() -> Decision:
    """A constant velocity noise moves the estimate away for ever."""
    document = certificate(
        "variational",
        "section_3_robust_reading_b",
        {},
        [derivation((), ("1", "0", "1"), ("h", "1", "1"))],
        case="REFUTED",
    )
    step, noise, error = Fraction(1, 100), Fraction(1, 10), Fraction(0)
    rows = [("sample", "position error")]
    for k in range(DRIFT_SAMPLES):
        rows.append((str(k), str(error)))
        error -= step * noise
    return Decision(
        verdict=Verdict.REFUTED,
        reason="From x = u = 0 both stay zero, and a constant velocity noise moves the true "
        "error by "
        "-h nu in every sample, as an identity: nothing measured brings it back.",
        printed="bounded",
        sharp="grows by h nu a sample",
        margin_text="no bound",
        certificates={"variational.section_3_robust_reading_b": document},
        replay=tuple(rows),
        figure=readings_over_time(),
    )


DECISIONS: Mapping[str, Callable[[], Decision]] = {
    "variational.section_3_velocity_noise": velocity_noise,
    "variational.section_3_robust_reading_a": robust_reading_a,
    "variational.section_3_robust_reading_b": robust_reading_b,
}
