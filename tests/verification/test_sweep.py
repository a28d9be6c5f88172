"""Rows about the shipped networks beside numbers that others computed, and beside their own cut."""

import csv
from fractions import Fraction
from math import sqrt

import pytest

from sensortrack.data import real_networks
from tests.meta.repository import ROOT
from verification.certificates import check
from verification.certificates.make import statements
from verification.verify.sweeping import sweep

with (ROOT / "tests" / "data" / "real_networks.csv").open(encoding="utf-8") as file:
    KNOWN = {row["graph"]: row for row in csv.DictReader(file)}


@pytest.mark.parametrize("name", real_networks())
def test_a_row_agrees_with_known_numbers_its_cut_and_its_certificate(name):
    finding = sweep(name)
    row, known = finding.record, KNOWN[name]
    assert (finding.skipped, row["graph"]) == ("", name)
    assert (row["nodes"], row["edges"]) == (int(known["nodes"]), int(known["edges"]))
    connectivity = float(known["algebraic_connectivity"])
    assert row["lambda_2"] == pytest.approx(connectivity, rel=1e-7)
    assert row["printed_value"] == pytest.approx(1 + sqrt(row["nodes"]) / connectivity, rel=1e-7)

    n, s = row["nodes"], len(row["cut"])
    assert 0 < 2 * s <= n
    assert len(row["cut_links"]) == row["cut_edges"]
    assert all(len({*link} & {*row["cut"]}) == 1 for link in row["cut_links"])
    assert Fraction(row["threshold"]) == Fraction(2 * s * (n - s), n * row["cut_edges"])
    assert row["ratio"] == pytest.approx(row["printed_value"] / float(Fraction(row["threshold"])))

    (document,) = finding.certificates.values()
    entry = check.check_document(document, statements())
    assert (entry["verdict"], entry["lower"], entry["upper"]) == ("PROVED", *[row["threshold"]] * 2)


def test_a_network_that_is_not_shipped_is_skipped_with_the_reason():
    finding = sweep("sndlib_polskaa")
    assert finding.record == {}
    assert finding.skipped.startswith("network sndlib_polskaa: InputError: graph: ")
