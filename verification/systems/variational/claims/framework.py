"""How the claims about sensors, weights and communication are decided."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from fractions import Fraction

from theory.systems.variational.statements.framework import SENSORS, TWO_TRIANGLES
from verification.adversary.placements import placement
from verification.certificates.make import certificate
from verification.verdict import Decision, Verdict

from ..claim_figures import network
from .witnesses import derivation


def observed_by() -> Decision:
    """The sign of the relative position is the other one."""
    refuted = certificate(
        "variational", "eq_1_observed_by", {}, [derivation((), ("-1", "0", "1"))], case="REFUTED"
    )
    repaired = certificate(
        "variational", "eq_1_observed_by_repair", {}, [derivation((), ("1", "0", "1"))]
    )
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="By (1) the relative position is sensor minus target; what the sensor sees is "
        "target minus sensor, and the two differ by twice the relative position, as an identity.",
        printed="target seen from sensor",
        sharp="sensor seen from target",
        margin_text="the sign is the other one",
        repair="b_0i of (1) is sensor i as the target would see it; a sensor that reports what it "
        "sees reports -b_0i.",
        repair_formula=r"b^{0i} = b^i - b^0",
        certificates={
            "variational.eq_1_observed_by": refuted,
            "variational.eq_1_observed_by_repair": repaired,
        },
    )


def errors() -> Decision:
    """(6) and (7) give the true errors for any weights of sum one."""
    document = certificate(
        "variational",
        "eq_6_errors",
        {},
        [derivation((), ("1", "0", "b")), derivation((), ("1", "1", "b"))],
    )
    return Decision(
        verdict=Verdict.PROVED,
        reason="The weighted mean of what three sensors report is the target's position, for all "
        "weights of sum one, and so is that of two of them: an identity, so nothing jumps when one "
        "is lost and the weights are rescaled. Weights kept at 1/3 would put two thirds of the "
        "position in its place.",
        printed="x = b_hat - b",
        sharp="the same",
        margin_text="identical",
        certificates={"variational.eq_6_errors": document},
    )


def kinematics() -> Decision:
    """(8) follows from (6), (7) and the motion of the estimate."""
    witness = [derivation((), ("1", "0", "1"), ("-1", "1", "1"))]
    document = certificate("variational", "eq_8_kinematics", {}, witness)
    return Decision(
        verdict=Verdict.PROVED,
        reason="Since the weights drop out of (6) and (7), the derivative of the error is the "
        "difference of the two velocities, as an identity.",
        printed="x' = u",
        sharp="the same",
        margin_text="identical",
        certificates={"variational.eq_8_kinematics": document},
    )


def kinematics_measured() -> Decision:
    """Noise of the position is not the integral of that of the velocity."""
    witness = [derivation((), ("1", "0", "1"), ("-1", "1", "1"), ("1", "2", "1"))]
    document = certificate("variational", "eq_8_kinematics_measured", {}, witness, case="REFUTED")
    return Decision(
        verdict=Verdict.REFUTED,
        reason="The two sides differ by the derivative of the position noise less the velocity "
        "noise, as an identity: a constant velocity noise is enough.",
        printed="x' = u",
        sharp="x' = u + q - n, q the derivative of the averaged position noise, n that of (7)",
        margin_text="wrong by q - n",
        certificates={"variational.eq_8_kinematics_measured": document},
    )


def neighbours() -> Decision:
    """A path of three sensors is connected and its ends have one neighbour."""
    links = ((0, 1), (1, 2))
    fewest = min(sum(node in link for link in links) for node in range(3))
    return _placed(
        "section_2_neighbours",
        3,
        links,
        (0, 2),
        Decision(
            verdict=Verdict.REFUTED,
            reason="A search places three sensors so that the outer two are out of range of each "
            "other, replayed in rationals: the network is connected, and two sensors have one "
            "neighbour.",
            printed="2 neighbours",
            sharp="1 neighbour",
            printed_value=2.0,
            sharp_value=float(fewest),
            margin_text="one neighbour too many is promised",
        ),
    )


def two_edge_connected() -> Decision:
    """Two triangles joined by one link: every degree is two or three, and one link is a bridge."""
    return _placed(
        "section_2_two_edge_connected",
        SENSORS,
        TWO_TRIANGLES,
        (2, 3),
        Decision(
            verdict=Verdict.REFUTED,
            reason="A search places six sensors as two triangles joined by one link, replayed in "
            "rationals for all 15 pairs: each sensor has two neighbours or three, and the network "
            "falls apart when that link is lost. Links that serve both ways make a connected "
            "network strongly connected without this.",
            printed="no bridge",
            sharp="one bridge",
            margin_text="the property is not implied",
        ),
    )


def _placed(
    name: str,
    sensors: int,
    links: Collection[tuple[int, int]],
    marked: tuple[int, ...],
    found: Decision,
) -> Decision:
    """The decision with its places, or undecided if the search found none."""
    places = placement(sensors, links)
    if not places:
        return Decision(Verdict.UNDECIDED, "stage search: no places were found")
    inputs = {f"p{k}": [[x], [y]] for k, (x, y) in enumerate(places)} | {"r": Fraction(1)}
    document = certificate("variational", name, inputs, [], case="REFUTED")
    rows = [(f"p{k}", str(x), str(y)) for k, (x, y) in enumerate(places)]
    values = vars(found) | {
        "certificates": {f"variational.{name}": document},
        "replay": (("sensor", "x", "y"), *rows),
        "figure": network(places, links, marked),
    }
    return Decision(**values)


DECISIONS: Mapping[str, Callable[[], Decision]] = {
    "variational.eq_1_observed_by": observed_by,
    "variational.eq_6_errors": errors,
    "variational.eq_8_kinematics": kinematics,
    "variational.eq_8_kinematics_measured": kinematics_measured,
    "variational.section_2_neighbours": neighbours,
    "variational.section_2_two_edge_connected": two_edge_connected,
}
