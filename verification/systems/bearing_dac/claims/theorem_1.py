"""How gain and time of Theorem 1, as printed, are decided."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from verification.certificates.make import certificate
from verification.verdict import Decision, Verdict

from ..counterexamples import (
    Counterexample,
    complete_time_counterexamples,
    gain_counterexamples,
    time_counterexamples,
)
from ..figures import error_over_time, gain_plane

LARGEST_GAIN = 4
LARGEST_TIME = 4
LARGEST_COMPLETE = 7


def theorem_1_gain() -> Decision:
    """beta >= 1 + gamma sqrt(n)/lambda_2 is too small on two sensors and on the triangle."""
    found = list(gain_counterexamples(LARGEST_GAIN))
    if not found:
        return _nothing(f"no counterexample on up to {LARGEST_GAIN} nodes")
    first = found[0]
    repaired = gain_repair()
    return Decision(
        verdict=Verdict.CORRECTED,
        reason=f"Of all connected graphs on up to {LARGEST_GAIN} nodes, those with edges "
        f"{_labels(found)} refute the printed gain: one admissible disturbance drives a cut apart "
        f"for "
        "ever, replayed in rationals. The repair is x'Lx >= lambda_2 |x|^2 at the indicator of "
        "each cut.",
        printed=f"{first.printed:.5g}",
        sharp=f"{first.sharp:.5g}",
        printed_value=first.printed,
        sharp_value=first.sharp,
        margin_text=f"{1 - first.printed / first.sharp:.1%} too small at {_where(first)}",
        repair="beta >= 2 gamma/lambda_2 keeps agreement and any larger gain reaches it in finite "
        "time; "
        "the sharp threshold of a network is gamma max over cuts of 2p/k, p = s(n-s)/n.",
        repair_formula=r"\beta^*=\gamma\max_S\frac{2\,s(n-s)}{n\,k_S}\le\frac{2\gamma}{\lambda_2}",
        relies_on=tuple(repaired["relies_on"]),
        certificates=_files("bearing_dac.theorem_1_gain", found, repaired),
        replay=_table(found, "threshold"),
        figure=gain_plane(first),
    )


def theorem_1_time() -> Decision:
    """t* = t0 + |x(t0)|/lambda_2 comes too early on small complete graphs."""
    found = list(time_counterexamples(LARGEST_TIME))
    if not found:
        return _nothing(f"no counterexample on up to {LARGEST_TIME} nodes")
    last = found[-1]
    larger = list(complete_time_counterexamples(LARGEST_TIME + 1, LARGEST_COMPLETE))
    repaired = time_repair()
    return Decision(
        verdict=Verdict.CORRECTED,
        reason=f"Of all connected graphs on up to {LARGEST_TIME} nodes, those with edges "
        f"{_labels(found)} refute the printed time although the gain is above the true threshold: "
        "the error of one run is replayed in rationals and is not zero after t*; so do the "
        f"complete graphs on up to {LARGEST_COMPLETE} nodes for small gamma. No graph that lacks a "
        f"link does, as theorem_1_time_incomplete shows. The repair needs k >= 1 and k >= lambda_2 "
        f"p only.",
        printed=f"{last.printed:.5g}",
        sharp=f"{last.sharp:.5g}",
        printed_value=last.printed,
        sharp_value=last.sharp,
        margin_text=f"{1 - last.printed / last.sharp:.1%} too early at {_where(last)}",
        repair="with beta >= 1 + 2 gamma/lambda_2 and unit weights the error is zero from "
        "t0 + |x(t0)|/sqrt(lambda_2) on; the sharp bound is |x(t0)|/min over cuts of "
        "(beta k - 2 gamma p)/sqrt(p), and it is attained.",
        repair_formula=r"t^*=t_0+\frac{\lVert\tilde x(t_0)\rVert}"
        r"{\min_S(\beta k_S-2\gamma p_S)/\sqrt{p_S}}",
        relies_on=tuple(repaired["relies_on"]),
        certificates=_files("bearing_dac.theorem_1_time", [*found, *larger], repaired),
        replay=_table([*found, *larger], "settling time"),
        figure=error_over_time(last),
    )


def gain_repair(name: str = "theorem_1_gain_repair") -> dict[str, Any]:
    """Certificate that 2 gamma/lambda_2 clears every cut of every connected graph."""
    squares = [["2*g", "S", "P"]]
    return _universal(name, [(squares, [["-2*g*T(S)", "0", "S"]])])


def time_repair(name: str = "theorem_1_time_repair") -> dict[str, Any]:
    """Certificate of the repaired time on every connected graph."""
    expanded = "j + j**2 + 2*(1 + j)*(d*(1 + j) + 2*g*s) + (d*(1 + j) + 2*g*s)**2 + s"
    return _universal(name, [([], []), ([[expanded, "1", "1"]], [])])


def _nothing(what: str) -> Decision:
    return Decision(verdict=Verdict.UNDECIDED, reason=f"stage: search; {what}")


def _universal(name: str, parts: Sequence[tuple[Sequence[Any], Sequence[Any]]]) -> dict[str, Any]:
    witness = [
        {"kind": "derivation", "squares": list(squares), "relations": list(relations)}
        for squares, relations in parts
    ]
    return certificate("bearing_dac", name, {}, witness)


def _labels(found: list[Counterexample]) -> str:
    return "; ".join(f"{{{example.network.label}}}" for example in found)


def _short(example: Counterexample) -> str:
    """The edges, or that they are all."""
    n, m = example.network.n, example.network.m
    complete = n > LARGEST_TIME and 2 * m == n * (n - 1)
    return f"all pairs of {n} nodes" if complete else example.network.label


def _where(example: Counterexample) -> str:
    return f"n = {example.network.n}, gamma = {example.gamma}, beta = {example.beta}"


def _files(
    stem: str, found: list[Counterexample], repaired: dict[str, Any]
) -> dict[str, dict[str, Any]]:
    files = {
        f"{stem}_{example.network.label.replace(' ', '_')}": example.document for example in found
    }
    return files | {f"{stem}_repair": repaired}


def _table(found: list[Counterexample], what: str) -> tuple[tuple[str, ...], ...]:
    head = ("edges", "gamma", "beta", f"printed {what}", f"true {what}", "t", "error at t")
    rows = [
        (
            _short(example),
            str(example.gamma),
            str(example.beta),
            f"{example.printed:.5g}",
            f"{example.sharp:.5g}",
            str(example.run["t"]),
            "(" + ", ".join(map(str, example.run["x1"])) + ")",
        )
        for example in found
    ]
    return (head, *rows)


DECISIONS: Mapping[str, Callable[[], Decision]] = {
    "bearing_dac.theorem_1_gain": theorem_1_gain,
    "bearing_dac.theorem_1_time": theorem_1_time,
}
