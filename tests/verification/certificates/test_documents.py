"""The checker's layout, and the pages that explain it, forget nothing."""

import re

import pytest

from verification.certificates import check

from .documents import CHECKER

PAGES = CHECKER.parents[2] / "docs" / "verification"
SOURCE = CHECKER.read_text(encoding="utf-8")
LEMMAS = (PAGES / "lemmas.md").read_text(encoding="utf-8")
MANUAL = (PAGES / "certificates.md").read_text(encoding="utf-8")
KINDS = sorted(
    kind
    for call in re.findall(r"(?:take|fields)\((?:\w+, )?(\{[^}]*\})", SOURCE)
    for kind in re.findall(r'"(\w+)": ?"', call)
)
LANGUAGE = [*check.PREDICATES, "forall", "exists", *check.FUNCTIONS]


def anchors(text):
    """Targets of links to headings, as the manual's markup makes them."""
    titles = re.findall(r"^#+ (.*)$", text, flags=re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.strip().lower().replace(" ", "-")) for title in titles}


def test_the_checker_is_short_and_not_wide():
    lines = SOURCE.splitlines()
    assert len(lines) <= 640
    assert max(map(len, lines)) <= 118


def test_the_kinds_of_witness_are_found_in_the_checker():
    assert {"congruence", "vector", "matrix", "derivation", "cuts", "cut", "trajectory"} <= {*KINDS}
    assert {"tree", "enumeration", "routing", "cells", "gap", "product", "sparse_ldl"} <= {*KINDS}


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_of_witness_has_a_lemma_and_a_row(kind):
    where = "cuts" if kind in ("cut", "cuts") else f"(`{kind}`)"
    where = "(`exists`)" if kind == "matrix" else where
    headings = [line for line in LEMMAS.splitlines() if line.startswith("#")]
    assert any(where in heading.lower() for heading in headings)
    assert f"| `{kind}` |" in MANUAL


@pytest.mark.parametrize("word", LANGUAGE)
def test_every_word_of_the_language_is_in_the_grammar(word):
    assert f"{word}(" in MANUAL


def test_links_to_lemmas_lead_somewhere():
    links = re.findall(r"lemmas\.md#([\w-]+)", MANUAL)
    assert len(links) >= 8
    assert {*links} <= anchors(LEMMAS)


def test_kinds_of_data_are_in_the_manual(known):
    used = {kind for entry in known.values() for kind in entry["inputs"].values()}
    assert all(f"| `{kind}` |" in MANUAL for kind in used)
    symbols = {text.split(":")[0] for entry in known.values() for text in entry["symbols"].values()}
    assert all(f'"{kind}' in MANUAL for kind in symbols)
