"""How the claims about the consensus laws and the other sentences of Theorem 1 are decided."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

from sensortrack.networks import read_network
from verification.certificates.make import certificate
from verification.verdict import Decision, Verdict

from ..claim_figures import agreement_off_the_average
from .common import SYSTEM, disproof, file_of, lettered, proofs, reliances, squares

START = (Fraction(1), Fraction(-1))
ESTIMATE = {
    "gamma": Fraction(10),
    "beta": Fraction(2),
    "n_hat": Fraction(4),
    "lambda_hat": Fraction(20),
}


def compact() -> Decision:
    """A column of B serves its two nodes."""
    return Decision(
        verdict=Verdict.PROVED,
        reason="Each link adds the sign of its difference at its head and the opposite at its "
        "tail, as an identity, and turning it round changes nothing because the sign is odd; "
        "entries do not mix.",
        printed="B sgn(B'x)",
        sharp="the same",
        margin_text="identical",
        certificates=proofs("section_3_compact"),
    )


def error() -> Decision:
    """Take the average off."""
    return Decision(
        verdict=Verdict.PROVED,
        reason="x less the average of phi is w + M phi, as an identity of any number of nodes; "
        "Lemma 2, which is cited for it, is not needed.",
        printed="w + M phi",
        sharp="the same",
        margin_text="identical",
        certificates=proofs("section_3_error"),
    )


def kept() -> Decision:
    """1'B = 0."""
    return Decision(
        verdict=Verdict.PROVED,
        reason="The ones are orthogonal to every column of B, so the sum of w never moves, "
        "whatever the signs.",
        printed="mean of x = average",
        sharp="the same",
        margin_text="identical",
        certificates=proofs("algorithm_1_start"),
    )


def needed() -> Decision:
    """Only the sum has to be zero."""
    network, beta, t = read_network("path:2"), Fraction(1), Fraction(1)
    inputs = {"graph": lettered(network), "beta": beta, "w": list(START), "t": t}
    rest = {"duration": t, "disturbance": [0, 0], "signs": [1]}
    witness = [{"kind": "trajectory", "pieces": [rest]}]
    refuted = certificate(SYSTEM, "algorithm_1_start_needed", inputs, witness, "REFUTED")
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="Two sensors with internal states 1 and -1 agree on the average after one second, "
        "replayed exactly: zero is not needed for each of them.",
        printed="w(t0) = 0",
        sharp="1'w(t0) = 0",
        margin_text="n numbers are asked for, one is needed",
        repair="Agreement is on the average if and only if the internal states start at sum zero; "
        "otherwise all sensors agree, for ever, on the average plus the mean of w(t0).",
        repair_formula=r"\mathbf{1}^\top w(t_0)=0",
        certificates=file_of("algorithm_1_start_needed", refuted)
        | proofs("algorithm_1_start_needed_repair"),
        replay=(
            ("t", "x_1 - average", "x_2 - average"),
            ("0", *map(str, START)),
            (str(t), "0", "0"),
        ),
        figure=agreement_off_the_average(),
    )


def stays_filippov() -> Decision:
    """An electrical flow is a selection of signs."""
    certificates = proofs("theorem_1_stays_filippov")
    return Decision(
        verdict=Verdict.PROVED,
        reason="The flow B'L^+u balances the disturbance, and its length is at most gamma "
        "sqrt(n/lambda_2), as identities for every connected graph; divided by beta it is a "
        "selection of signs at the tie. Below the threshold of the network no selection does.",
        printed="0 for all t >= t*",
        sharp="0, at any gain from the threshold on",
        margin_text="holds, with signs between -1 and 1 at ties",
        relies_on=reliances(certificates),
        certificates=certificates,
    )


def stays_classical() -> Decision:
    """sgn(0) = 0 holds nothing."""
    certificates = disproof("theorem_1_stays_classical") | proofs("theorem_1_stays_filippov")
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="At agreement all printed signs are zero, and the error moves with the disturbance, "
        "as an identity: it stays zero only while nothing disturbs it.",
        printed="0 for all t >= t*",
        sharp="left at once",
        margin_text="no classical solution stays",
        repair="In Filippov's sense, with any signs between -1 and 1 at a tie, agreement is kept "
        "at every gain from gamma sqrt(n/lambda_2) on.",
        repair_formula=r"\dot{\tilde x}\in-\beta\mathcal{B}\,\mathrm{SGN}(\mathcal{B}^\top\tilde x)"
        r"+M\dot\phi,\quad\mathrm{SGN}(0)=[-1,1]",
        relies_on=reliances(certificates),
        certificates=certificates,
    )


def estimates() -> Decision:
    """Read as a bound on the estimate."""
    goal = "n*(2*l*j + j**2) + a*(l + j)**2"
    document = certificate(SYSTEM, "theorem_1_estimates", {}, squares(goal))
    return Decision(
        verdict=Verdict.PROVED,
        reason="n^ times the square of lambda_2, less n times the square of lambda2^, is a "
        "polynomial with positive coefficients in the slacks of both estimates; and every rate "
        "grows with beta.",
        printed="lambda2^ <= lambda_2",
        sharp="the same",
        margin_text="holds in this reading",
        certificates=file_of("theorem_1_estimates", document),
    )


def estimates_printed() -> Decision:
    """As printed, the estimate is free."""
    network = read_network("path:4")
    inputs = {"graph": lettered(network), **ESTIMATE}
    cut = {"kind": "cut", "nodes": [0, 1]}
    refuted = certificate(SYSTEM, "theorem_1_estimates_printed", inputs, [cut], "REFUTED")
    repaired = certificate(
        SYSTEM, "theorem_1_estimates", {}, squares("n*(2*l*j + j**2) + a*(l + j)**2")
    )
    certificates = file_of("theorem_1_estimates_printed", refuted)
    certificates |= file_of("theorem_1_estimates", repaired)
    return Decision(
        verdict=Verdict.CORRECTED,
        reason=f"Four sensors in a row, gamma = {ESTIMATE['gamma']}: the estimate "
        f"{ESTIMATE['lambda_hat']} allows the gain {ESTIMATE['beta']}, a tenth of what is needed, "
        f"and a disturbance drives the halves apart.",
        printed="lambda_2 <= lambda_2(L)",
        sharp="lambda2^ <= lambda_2(L)",
        printed_value=float(ESTIMATE["beta"]),
        sharp_value=20.0,
        margin_text="a hat is missing",
        repair="The estimate must not exceed lambda_2(L); then it only raises the gain.",
        repair_formula=r"0<\hat\lambda_2\le\lambda_2(L)",
        relies_on=reliances(certificates),
        certificates=certificates,
    )


def time_start() -> Decision:
    """Taking the mean off shortens."""
    return Decision(
        verdict=Verdict.PROVED,
        reason="|x|^2 - |Mx|^2 = (1'x)^2/n, as an identity. With the error in its place t* would "
        "be earlier and would not change with the origin.",
        printed="|x(t0)|",
        sharp="|x~(t0)|",
        margin_text="safe, and later than needed by the mean",
        certificates=proofs("theorem_1_time_start"),
    )


def time_incomplete() -> Decision:
    """All graphs but the complete ones."""
    goals = (
        "g*b*l*(1 + a) + g*(2 + b)*j",
        "l**2*a*(1 + a) + 2*l*(1 + a)*j + j**2",
        "g*b*l + g*(2 + b)*j + 2*g*l*a",
        "l**2*a + 2*l*j + j**2",
        "11/9",
    )
    document = certificate(SYSTEM, "theorem_1_time_incomplete", {}, squares(*goals))
    return Decision(
        verdict=Verdict.PROVED,
        reason="Every cut of a graph that lacks a link has beta k - 2 gamma p >= lambda_2 sqrt(p) "
        "at the printed gain: polynomials with positive coefficients, by k >= lambda_2 p where p "
        ">= 1 and by Fiedler's bound on degrees where one node is cut off.",
        printed="|x(t0)|/lambda_2",
        sharp="at most that",
        margin_text="holds wherever a link is missing",
        relies_on=tuple(document["relies_on"]),
        certificates=file_of("theorem_1_time_incomplete", document),
    )


DECISIONS: Mapping[str, Callable[[], Decision]] = {
    "bearing_dac.section_3_compact": compact,
    "bearing_dac.section_3_error": error,
    "bearing_dac.algorithm_1_start": kept,
    "bearing_dac.algorithm_1_start_needed": needed,
    "bearing_dac.theorem_1_stays_filippov": stays_filippov,
    "bearing_dac.theorem_1_stays_classical": stays_classical,
    "bearing_dac.theorem_1_estimates": estimates,
    "bearing_dac.theorem_1_estimates_printed": estimates_printed,
    "bearing_dac.theorem_1_time_start": time_start,
    "bearing_dac.theorem_1_time_incomplete": time_incomplete,
}
