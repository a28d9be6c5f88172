"""What is answered about networks whose threshold is not known: brackets, proved on both sides."""

import json
from fractions import Fraction
from typing import Any

import pytest

from sensortrack.errors import InputError
from sensortrack.networks import Network, read_network
from verification.certificates import check
from verification.certificates.make import CertificateError, certificate, statements
from verification.exact.cells import cell_bounds
from verification.systems.bearing_dac import brackets, gains

NETWORK = read_network("random_geometric:260,0.13,3")
VALUES = {"graph": NETWORK, "gamma": (Fraction(1),) * NETWORK.n}


@pytest.fixture(scope="module")
def answer() -> Any:
    return gains.gain_threshold(VALUES)


def test_a_bracket_has_both_ends_and_a_certificate(answer: Any) -> None:
    assert answer.value is None
    assert answer.verdict == "UNDECIDED"
    assert 0 < answer.lower < answer.upper < 1.1 * answer.lower
    document = json.loads(json.dumps(answer.certificate))
    entry = check.check_document(document, statements())
    assert entry["verdict"] == "PROVED"
    assert float(Fraction(entry["upper"])) <= answer.upper


def test_gains_outside_the_bracket_are_decided(answer: Any) -> None:
    ends = [Fraction(answer.certificate[end]) for end in ("lower", "upper")]
    for beta, verdict in [
        (ends[1], "PROVED"),
        (ends[1] + 1, "PROVED"),
        (ends[0] * Fraction(999, 1000), "REFUTED"),
        ((ends[0] + ends[1]) / 2, "UNDECIDED"),
    ]:
        found = gains.decide_gain(VALUES | {"beta": beta})
        assert found.verdict == verdict
        assert (found.certificate is None) == (verdict == "UNDECIDED")
        if found.certificate is not None:
            assert check.check_document(found.certificate, statements())["verdict"] == verdict
        else:
            assert any("lies between" in note for note in found.notes)


def test_bounds_that_are_too_long_for_a_file_are_given_with_a_note(
    monkeypatch: pytest.MonkeyPatch, answer: Any
) -> None:
    monkeypatch.setattr(cell_bounds, "KEPT", 10)
    found = gains.gain_threshold(VALUES)
    assert (found.value, found.certificate, found.verdict) == (None, None, "UNDECIDED")
    assert (found.lower, found.upper) == (answer.lower, answer.upper)
    assert brackets.BY_INTEGERS in found.notes
    assert "without certificate" in found.proved
    assert answer.proved == "certified"
    above = gains.decide_gain(VALUES | {"beta": Fraction(found.upper) + 1})
    assert above.verdict == "UNDECIDED"
    assert any(brackets.BY_INTEGERS in note for note in above.notes)


def test_a_network_too_large_for_a_file_is_not_written_down(
    monkeypatch: pytest.MonkeyPatch, answer: Any
) -> None:
    monkeypatch.setattr(brackets, "FILE_EDGES", 100)
    monkeypatch.setattr(cell_bounds, "KEPT", 10)
    below = gains.decide_gain(VALUES | {"beta": Fraction(answer.lower) / 2})
    assert below.verdict == "UNDECIDED"
    assert below.certificate is None


def test_a_file_that_the_checker_would_not_read_is_no_certificate(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    pair = Network(["a", "b"], [[0, 1]])
    monkeypatch.setattr(check, "FILE_BYTES", 50)
    witness = [{"kind": "cuts", "parts": [{"kind": "tree"}]}]
    inputs = {"graph": pair.to_data(), "gamma": Fraction(1), "beta": Fraction(1)}
    with pytest.raises(CertificateError, match="longer than the checker reads"):
        certificate("bearing_dac", "gain", inputs, witness)


def test_bounds_and_weights_of_their_own() -> None:
    """Twice the disturbances need twice the gain, twice the weights half of it."""
    gamma = tuple(Fraction(1 + i % 2) for i in range(NETWORK.n))
    heavy = Network(NETWORK.names, NETWORK.edges, [Fraction(2 + e % 3) for e in range(NETWORK.m)])
    one = gains.gain_threshold({"graph": heavy, "gamma": gamma})
    assert one.certificate is not None
    assert one.lower < one.upper < 1.2 * one.lower
    twice = gains.gain_threshold({"graph": heavy, "gamma": tuple(2 * g for g in gamma)})
    assert twice.lower == pytest.approx(2 * one.lower, rel=0.02)
    assert twice.upper == pytest.approx(2 * one.upper, rel=0.02)


def test_a_negative_bound_is_refused_on_large_networks() -> None:
    gamma = (Fraction(1),) * (NETWORK.n - 1) + (Fraction(-1),)
    with pytest.raises(InputError, match="gamma"):
        gains.gain_threshold({"graph": NETWORK, "gamma": gamma})
