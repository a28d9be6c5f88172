"""``--set``, ``--params`` and ``--graph``: what is read, and what is refused by name."""

import json

import pytest


def inputs(result):
    status, out, err = result
    assert status == 0, err
    return json.loads(out)["inputs"]


def refused(result):
    status, out, err = result
    assert (status, out) == (2, "")
    assert not any("Traceback" in line for line in err)
    return err[0].removeprefix("sensortrack: ")


@pytest.fixture
def trace(run):
    def call(*argv):
        return run("bound", "toy.trace", "--json", *argv)

    return call


@pytest.fixture
def total(run):
    def call(*argv):
        return run("bound", "toy.total", "--json", *argv)

    return call


@pytest.fixture
def params(tmp_path):
    def write(text, name="in.json"):
        path = tmp_path / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    return write


@pytest.mark.parametrize(
    "value, text",
    [
        ("0.1", "1/10"),
        ("1e-2", "1/100"),
        ('"1/3"', "1/3"),
        ("1/3", "1/3"),
        (" 2 ", "2"),
        ("[[0.5, 0], [0, 1]]", [["1/2", "0"], ["0", "1"]]),
    ],
)
def test_set_takes_json_and_keeps_decimals_exact(trace, value, text):
    assert inputs(trace("--set", f"M={value}", "--set", "K=1"))["M"] == text


def test_a_long_decimal_loses_no_digit(trace):
    digits = "0." + "123456789" * 10
    found = inputs(trace("--set", f"M={digits}", "--set", "K=1"))["M"]
    assert found == f"{int('123456789' * 10)}/{10**90}"


@pytest.mark.parametrize("bad", ["M", "=1", "", "  =1"])
def test_set_without_name_and_value_is_refused(trace, bad):
    assert refused(trace("--set", bad)).startswith("--set: ")


@pytest.mark.parametrize("bad", ["NaN", "Infinity", "[[NaN]]", "-Infinity", "true", "null", "{}"])
def test_what_is_no_finite_number_is_refused_by_its_inputs_name(trace, params, bad):
    assert refused(trace("--set", f"M={bad}", "--set", "K=1")).startswith("M: ")
    path = params(f'{{"M": {bad}, "K": 1}}')
    assert refused(trace("--params", path)).startswith("M: ")


def test_a_million_digits_are_refused_before_arithmetic(trace, params):
    long = "9" * 1_000_000
    path = params(f'{{"M": {long}, "K": 1}}')
    assert refused(trace("--params", path)).startswith("M: a number of 1000000 characters")


@pytest.mark.parametrize("name", ["in.json", "in.JSON"])
def test_params_takes_an_object_of_the_same_names(trace, params, name):
    path = params('{"M": 0.1, "K": [[1]]}', name)
    assert inputs(trace("--params", path)) == {"M": "1/10", "K": [["1"]]}


def test_params_takes_toml_with_exact_decimals(trace, params):
    path = params('M = 0.1\nK = [[1_000.5, 0], [0, "1/3"]]\n', "in.toml")
    assert inputs(trace("--params", path)) == {"M": "1/10", "K": [["2001/2", "0"], ["0", "1/3"]]}


@pytest.mark.parametrize("bad", ["nan", "inf", "true", "1979-05-27", "{a = 1}"])
def test_toml_values_that_are_no_number_are_refused_by_name(trace, params, bad):
    assert refused(trace("--params", params(f"M = {bad}\nK = 1\n", "in.toml"))).startswith("M: ")


def test_params_and_set_complete_each_other(trace, params):
    assert inputs(trace("--params", params('{"M": 1}'), "--set", "K=2")) == {"M": "1", "K": "2"}


def test_the_same_name_in_both_is_refused(trace, params):
    line = refused(trace("--params", params('{"M": 1, "K": 1}'), "--set", "M=1"))
    assert line == "M: given twice, with --params and --set; one value is needed"
    line = refused(trace("--set", "M=1", "--set", "M=1"))
    assert line == "M: given twice, with --set and --set; one value is needed"


def test_a_key_given_twice_is_refused(trace, total, params):
    assert refused(trace("--params", params('{"M": 1, "M": 1}'))).startswith("M: given twice in ")
    assert refused(trace("--params", params("M = 1\nM = 2\n", "in.toml"))).startswith("--params: ")
    twice = '{"0": 1, "0": 2, "1": 1, "2": 1}'
    line = "gamma: '0' given twice; one number is needed"
    assert refused(total("--graph", "path:3", "--set", f"gamma={twice}")) == line
    path = params(f'{{"gamma": {twice}}}')
    assert refused(total("--graph", "path:3", "--params", path)) == line


@pytest.mark.parametrize(
    "text, name",
    [
        ("[1, 2]", "in.json"),
        ("{", "in.json"),
        (b"\xff\xfe", "in.json"),
        ("[" * 100_000, "in.json"),
        ("M = ", "in.toml"),
        ("M = " + "[" * 100_000, "in.toml"),
        ("M: 1", "in.yaml"),
        ("", "in"),
    ],
)
def test_a_file_that_holds_no_object_is_refused(trace, params, text, name):
    assert refused(trace("--params", params(text, name))).startswith("--params: ")


def test_a_file_that_is_not_there_is_refused(trace, tmp_path):
    assert "No such file" in refused(trace("--params", tmp_path / "none.json"))
    (tmp_path / "folder.json").mkdir()
    assert refused(trace("--params", tmp_path / "folder.json")).startswith("--params: ")


def test_a_graph_is_named_by_its_label(total):
    assert inputs(total("--graph", "path:3")) == {"graph": "path:3", "gamma": "1"}


def test_a_graph_of_a_file_is_chosen_by_name_and_weight(total, tmp_path):
    path = tmp_path / "nets.csv"
    path.write_text("graph,source,target,length\na,x,y,2\nb,y,z,0.5\n")
    found = inputs(total("--graph", path, "--graph-name", "b", "--weight", "length"))
    assert found["graph"] == "nets.csv (b)"
    assert refused(total("--graph", path, "--graph-name", "c")).startswith("graph: ")
    line = refused(total("--graph", path, "--graph-name", "b", "--weight", "width"))
    assert line.startswith("weight: ")


def test_a_shipped_network_is_known_by_its_name(total):
    assert inputs(total("--graph", "sndlib_polska"))["graph"] == "sndlib_polska"
    line = refused(total("--graph", "sndlib_polska", "--weight", "km"))
    assert line.startswith("--weight: given with the shipped network sndlib_polska;")


def test_graph_options_without_use_are_refused(trace, total):
    line = refused(trace("--graph", "path:3"))
    assert line == "graph: given; toy.trace takes M, K"
    for option in ("--graph-name", "--weight"):
        assert refused(total(option, "x")).startswith(f"{option}: given without --graph;")
    assert refused(total()).startswith("graph: not given;")
    assert refused(total("--graph", "nowhere.csv")).startswith("graph: ")
