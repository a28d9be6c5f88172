"""How the claims about the simulated parameters and about discrete time are decided."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

from sensortrack.networks import Network
from theory.systems.bearing_dac.claim_statements.numerics import GAIN, GAMMA, LAMBDA, NODES, SHARP
from verification.adversary.small_graphs import connected_graphs
from verification.certificates.make import certificate
from verification.exact.laplacians.spectral_gap import connectivity_bracket
from verification.verdict import Decision, Verdict

from ..claim_figures import steps_of_two_sensors
from ..counterexamples import Cut, cuts
from .common import SYSTEM, disproof, file_of, lettered, proofs, reliances, squares

STEP_GAIN = Fraction(1, 10)
"""Step times gain in the tables and figures of two sensors."""
STARTED = Fraction(3, 20)
SAMPLES = 6


def neediest() -> tuple[Network, Cut]:
    """Of the connected graphs on five nodes with lambda_2 of at least 0.4, one that needs most.

    Returns
    -------
    Network
        The one of the largest lambda_2 among them.
    Cut
        Its critical cut.
    """
    allowed = [
        (network, connectivity_bracket(network).lower) for network in connected_graphs(int(NODES))
    ]
    worst = [
        (max(cuts(network), key=lambda cut: cut.p / cut.k), lam)
        for network, lam in allowed
        if lam >= Fraction(LAMBDA)
    ]
    cut, _ = max(worst, key=lambda entry: (entry[0].p / entry[0].k, entry[1]))
    return cut.network, cut


def example() -> Decision:
    """560.02 is 2.33 times what five sensors can need."""
    network, cut = neediest()
    lines = [
        {"kind": "derivation", "squares": entries, "relations": relations}
        for entries, relations in (
            ([[f"({GAIN} - 1)**2*({LAMBDA})**2 - {GAMMA}**2*{NODES}", "1", "1"]], []),
            ([[f"{GAMMA}**2*{NODES} - (56001/100 - 1)**2*({LAMBDA})**2", "1", "1"]], []),
            (
                [[GAIN, "S", "P"], [f"{GAIN}*(j + {LAMBDA}) - 2*{GAMMA} - 1", "S", "M"]],
                [[f"-{GAIN}*T(S)", "0", "S"], [f"{GAIN}*T(S)*M", "1", "S"]],
            ),
        )
    ]
    reached = [{"kind": "cut", "nodes": list(cut.inside)}]
    certificates = {
        **file_of("example_gain", certificate(SYSTEM, "example_gain", {}, lines)),
        **file_of(
            "example_gain_enough",
            certificate(SYSTEM, "example_gain_enough", {}, squares(f"{SHARP}*j + 2*{GAMMA}*a")),
        ),
        **file_of(
            "example_gain_attained",
            certificate(SYSTEM, "example_gain_attained", {"graph": lettered(network)}, reached),
        ),
    }
    printed, sharp = float(Fraction(GAIN)), float(Fraction(SHARP))
    return Decision(
        verdict=Verdict.PROVED,
        reason="For every connected network with lambda_2 of at least 0.4 the gain exceeds 2 "
        "gamma/lambda_2 = 500, which is enough, as an identity. On five sensors 240 is, whatever "
        "lambda_2; of all connected graphs on five nodes with such a lambda_2, that with the edges "
        f"{network.label} needs it.",
        printed=f"{printed:.5g}",
        sharp=SHARP,
        printed_value=printed,
        sharp_value=sharp,
        margin_text=f"{printed / sharp:.3g} times what is needed",
        relies_on=reliances(certificates),
        certificates=certificates,
    )


def explicit() -> Decision:
    """Two sensors change places for ever."""
    states = [STARTED / 2]
    for _ in range(SAMPLES - 1):
        states.append(states[-1] - (STEP_GAIN if states[-1] > 0 else -STEP_GAIN))
    rows = [("step", "x_1", "x_2"), *((str(k), str(x), str(-x)) for k, x in enumerate(states))]
    certificates = disproof("section_5_discrete_explicit")
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="Two sensors, any step h and any gain: from x = h beta/2 (1, -1) each step changes "
        "the sign of the error, as an identity. Every step moves the difference by 2 h beta, so it "
        "meets zero from its multiples only.",
        printed="agreement",
        sharp="+- h beta/2 for ever",
        margin_text="never settles",
        repair="With an explicit step errors fall where they exceed h Q/(2r) and end below the "
        "larger of that and h sqrt(Q), r being the rate of the network and sqrt(Q) a bound on "
        "|beta B g - Mu|.",
        repair_formula=r"\limsup\lVert\tilde x_k\rVert\le h\max\left(\sqrt Q,\frac Q{2r}\right)",
        certificates=certificates | proofs("section_5_discrete_explicit_repair"),
        replay=tuple(rows),
        figure=steps_of_two_sensors(STARTED, STEP_GAIN),
    )


def implicit() -> Decision:
    """The proximal step."""
    certificates = proofs("section_5_discrete_implicit")
    return Decision(
        verdict=Verdict.PROVED,
        reason="With signs taken at the new error y, |y|(|y| + h r) <= y'x <= |y||x|, as "
        "identities for every graph and step: each step shortens the error by h r until it is "
        "zero, and the selection that keeps agreement in continuous time keeps it here. Every step "
        "asks for all nodes at once.",
        printed="agreement",
        sharp="in |x|/(h r) steps, rounded up",
        margin_text="holds for the implicit step, at the same gains",
        certificates=certificates,
    )


DECISIONS: Mapping[str, Callable[[], Decision]] = {
    "bearing_dac.example_gain": example,
    "bearing_dac.section_5_discrete_explicit": explicit,
    "bearing_dac.section_5_discrete_implicit": implicit,
}
