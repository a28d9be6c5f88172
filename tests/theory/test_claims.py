"""Claims and assumptions check themselves."""

from dataclasses import replace

import pytest

from theory.claims import SENSES, Assumption, Claim, Gap

GIVEN = Assumption("A1", "the gains are positive")
CLAIM = Claim(
    id="pendulum.theorem_1_gain",
    system="pendulum",
    source="Someone, Theorem 1",
    title="Every gain is large enough",
    statement="The error tends to zero for every gain.",
    formula=r"\frac{1}{2} k > 0",
    sense="threshold",
    assumes=(GIVEN,),
    printed="k > 0",
)


def test_a_claim_offers_its_assumptions_as_text() -> None:
    assert CLAIM.assumptions == ("A1: the gains are positive",)


@pytest.mark.parametrize("sense", sorted(SENSES))
def test_every_sense_is_accepted(sense: str) -> None:
    assert replace(CLAIM, sense=sense).sense == sense


@pytest.mark.parametrize(
    "change, what",
    [
        ({"id": "pendulum.Theorem_1"}, "id"),
        ({"id": "pendulum.theorem"}, "id"),
        ({"id": "pendulum.theorem_"}, "id"),
        ({"id": "clock.theorem_1"}, "id"),
        ({"id": "pendulumtheorem_1"}, "id"),
        ({"sense": "strict"}, "sense"),
        ({"source": "Someone, the main theorem"}, "number"),
        ({"source": ""}, "source"),
        ({"title": ""}, "title"),
        ({"title": "Stable"}, "title"),
        ({"title": " Every gain is large enough"}, "title"),
        ({"statement": "two\nlines of it"}, "statement"),
        ({"formula": "$k$"}, "formula"),
        ({"formula": r"\frac{1}{2"}, "formula"),
        ({"printed": " k"}, "printed"),
        ({"assumes": ()}, "no assumption"),
        ({"assumes": (GIVEN, Assumption("A1", "another text"))}, "twice"),
    ],
)
def test_a_malformed_claim_is_refused_by_name(change: dict[str, object], what: str) -> None:
    with pytest.raises(ValueError, match=what):
        replace(CLAIM, **change)


@pytest.mark.parametrize(
    "label, text", [("a1", "some text"), ("", "some text"), ("A1", ""), ("A1", "x")]
)
def test_a_malformed_assumption_is_refused(label: str, text: str) -> None:
    with pytest.raises(ValueError, match="assumption"):
        Assumption(label, text)


def test_a_gap_says_what_is_missing():
    gap = Gap("Author, Figure 2", "the error is small", "the noise and the gains")
    assert gap.missing == "the noise and the gains"
    with pytest.raises(ValueError, match="missing"):
        Gap("Author, Figure 2", "the error is small", "")
