"""Inputs become exact values, and everything else is refused by name."""

import re
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sensortrack.errors import InputError
from sensortrack.networks import read_network
from tests.strategies import rationals
from verification.answers import Input
from verification.input_kinds import KINDS
from verification.input_words import nearest
from verification.inputs import read_inputs

GAINS = tuple(Input(name, "matrix", f"gain {name}") for name in "MKC")
STEP = Input("h", "number", "step")
NODES = (Input("graph", "graph", "network"), Input("x0", "node numbers", "start", default="0"))
THREE = read_network("path:3")
HALF = Fraction(1, 2)


def matrices(m="1", k="1", c="1"):
    return read_inputs(GAINS, {"M": m, "K": k, "C": c}).values


def refused(inputs, data, network=None):
    """Name, first line of the error."""
    with pytest.raises(InputError) as caught:
        read_inputs(inputs, data, network, "toy.question")
    return caught.value.name, str(caught.value).splitlines()[0]


@pytest.mark.parametrize(
    "text, value",
    [
        ("0.1", Fraction(1, 10)),
        ("1e-3", Fraction(1, 1000)),
        ("1/3", Fraction(1, 3)),
        ("-7", Fraction(-7)),
        (5, Fraction(5)),
        ("1e400", Fraction(10) ** 400),
    ],
)
def test_a_number_is_exactly_its_text(text, value):
    reading = read_inputs([STEP], {"h": text})
    assert reading.values == {"h": value}
    assert reading.texts == {"h": str(value)}


@given(rationals())
def test_the_text_of_a_rational_reads_as_itself(value):
    assert read_inputs([STEP], {"h": str(value)}).values["h"] == value


@pytest.mark.parametrize(
    "bad",
    [
        "NaN",
        "Infinity",
        "-Infinity",
        "inf",
        "",
        " ",
        "1/0",
        "one",
        "[1",
        "1e401",
        "1e999999999",
        "1" * 2000,
        True,
        None,
        [1],
        {"a": "1"},
        "0x10",
        "1_000",
    ],
)
def test_what_is_no_finite_number_of_bearable_size_is_refused(bad):
    name, line = refused([STEP], {"h": bad})
    assert name == "h"
    assert line.startswith("h: ")
    assert len(line) < 1200


def test_a_number_is_that_multiple_of_the_identity_of_the_others_size():
    values = matrices(m="2", k=[["5", "1"], ["1", "2"]])
    assert values["M"] == ((2, 0), (0, 2))
    assert values["C"] == ((1, 0), (0, 1))
    assert matrices(m="0.5")["M"] == ((HALF,),)


def test_texts_keep_the_form_in_which_the_inputs_were_given():
    given_ = {"M": "2", "K": [["5", "0.5"], ["1/2", "2"]], "C": "0.1"}
    texts = read_inputs(GAINS, given_).texts
    assert texts == {"M": "2", "K": [["5", "1/2"], ["1/2", "2"]], "C": "1/10"}


@given(st.integers(1, 4), st.data())
def test_matrices_keep_every_entry(n, data):
    rows = [[data.draw(rationals()) for _ in range(n)] for _ in range(n)]
    texts = [[str(entry) for entry in row] for row in rows]
    assert matrices(m=texts)["M"] == tuple(map(tuple, rows))


@pytest.mark.parametrize(
    "bad, words",
    [
        ([["1", "2"]], "1 x 2"),
        ([["1"], ["2"]], "2 x 1"),
        ([["1", "2"], ["3"]], "row 2 has 1 numbers, row 1 has 2"),
        (["1", "2"], "row 1 is '1'"),
        ([], "an empty list"),
        ([[]], "1 x 0"),
        ([["1", "0"], ["0", "NaN"]], "entry 2,2 is 'NaN'"),
        ([["1", True], ["0", "1"]], "entry 1,2 is true"),
        ([["1", None], ["0", "1"]], "entry 1,2 is null"),
        ([[["1"]]], "entry 1,1 is ["),
        ("[[1, 2], [3, 4]", "which is no JSON"),
        ({"a": "1"}, '{"a": "1"}'),
    ],
)
def test_what_is_no_square_matrix_is_refused_with_the_place(bad, words):
    name, line = refused(GAINS, {"M": "1", "K": bad, "C": "1"})
    assert name == "K"
    assert words in line


@pytest.mark.parametrize("odd", "MKC")
def test_the_matrix_of_another_size_is_the_one_named(odd):
    two, three = ([[str(int(i == j)) for i in range(n)] for j in range(n)] for n in (2, 3))
    data = {name: three if name == odd else two for name in "MKC"}
    name, line = refused(GAINS, data)
    assert name == odd
    other = "K" if odd == "M" else "M"
    assert line == f"{odd}: 3 x 3; 2 x 2 is needed, the size of {other}"


def test_numbers_by_node_may_be_one_a_list_or_an_object():
    def read(value):
        return read_inputs(NODES, {"x0": value}, THREE).values["x0"]

    assert read("1/2") == (HALF, HALF, HALF)
    assert read(["1", "2", "3"]) == (1, 2, 3)
    assert read({"2": "3", "0": "1", "1": "2"}) == (1, 2, 3)
    assert read_inputs(NODES, {}, THREE).values["x0"] == (0, 0, 0)


@pytest.mark.parametrize(
    "bad, words",
    [
        (["1", "2"], "2 numbers; 3 are needed"),
        ([], "0 numbers; 3 are needed"),
        (["1", "2", "x"], "number 3 is 'x'"),
        ([["1"], "2", "3"], "number 1 is ["),
        ({"0": "1"}, "no number for node '1' and 1 further nodes"),
        ({"0": "1", "1": "1"}, "no number for node '2';"),
        ({"0": "1", "1": "1", "2": "1", "3": "1"}, "no node is called '3'"),
        ({"0": "1", "1": "inf", "2": "1"}, "node '1' is 'inf'"),
    ],
)
def test_numbers_that_do_not_fit_the_nodes_are_refused(bad, words):
    name, line = refused(NODES, {"x0": bad}, THREE)
    assert name == "x0"
    assert words in line


def test_an_unknown_node_gets_the_nearest_name():
    star = read_network("star:3")
    with pytest.raises(InputError, match=re.escape("did you mean 0?")):
        read_inputs(NODES, {"x0": {"00": "1"}}, star)


def test_unknown_names_suggest_the_nearest_and_list_what_is_taken():
    for bad, hint in [("m", "did you mean M?"), ("hh", "did you mean h?")]:
        with pytest.raises(InputError) as caught:
            read_inputs((*GAINS, STEP), {bad: "1"}, None, "toy.question")
        text = str(caught.value)
        assert text == f"{bad}: no such input; {hint}\ntoy.question takes M, K, C, h"
    assert refused(GAINS, {"zzz": "1"})[1] == "zzz: no such input; toy.question takes M, K, C"


def test_a_missing_name_is_named_and_every_other_one_described():
    with pytest.raises(InputError) as caught:
        read_inputs(GAINS, {"M": "1"}, None, "toy.question")
    lines = str(caught.value).splitlines()
    assert lines[0] == "K: not given; toy.question takes M, K, C"
    assert [line.split(",")[0] for line in lines[1:]] == ["K", "C"]
    assert "--set C=VALUE" in lines[2]


def test_the_graph_is_asked_for_and_refused_by_its_option():
    assert refused(NODES, {})[1].startswith("graph: not given;")
    assert refused(GAINS, {}, THREE) == ("graph", "graph: given; toy.question takes M, K, C")
    name, line = refused(NODES, {"graph": "path:3"})
    assert (name, line) == ("graph", "graph: 'path:3' given as a value; --graph is needed for it")


def test_names_with_line_breaks_stay_on_the_first_line():
    _, line = refused(GAINS, {"a\nb": "1"})
    assert line.startswith("a\\nb: no such input")


def test_every_kind_says_in_words_what_to_write():
    assert all(kind.form for kind in KINDS.values())
    assert nearest("gama", ["beta", "gamma"]) == "did you mean gamma?"
    assert nearest("q", ["beta", "gamma"]) == ""
