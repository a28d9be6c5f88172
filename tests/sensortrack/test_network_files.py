"""Files from strangers: what is read, to the letter, and what is refused, with the place."""

import csv
import io
from fractions import Fraction
from pathlib import Path
from xml.sax.saxutils import escape, quoteattr

import networkx as nx
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sensortrack import network_files
from sensortrack.errors import InputError
from sensortrack.network_files import csv_network, exact_weight
from sensortrack.network_graphml import graphml_network
from sensortrack.networks import read_network
from tests.strategies import networks

NASTY = ["a,b", "</script>", 'say "x"', "ü ñ 漢字", "two words", "<!-- -->", "&amp;", "0", "' OR 1"]


def refused(name: str, *words: str):
    """Expect an input error about `name` whose text holds all these words."""
    pattern = "(?s)" + "".join(f"(?=.*{word})" for word in (f"^{name}: ", *words))
    return pytest.raises(InputError, match=pattern)


@pytest.fixture
def write(tmp_path):
    def write(content: str | bytes, name: str = "g.csv") -> str:
        path = tmp_path / name
        path.write_bytes(content.encode() if isinstance(content, str) else content)
        return str(path)

    return write


# ------------------------------------------------------------------------- CSV


def test_nodes_keep_the_order_of_first_appearance(write):
    network = read_network(write("source,target\nb,a\nc,b\na,d\n"))
    assert list(network.names) == ["b", "a", "c", "d"]
    assert network.edges.tolist() == [[0, 1], [0, 2], [1, 3]]
    assert network.weights is None
    assert network.label == "g.csv"


@pytest.mark.parametrize(
    "content",
    [
        "target,length,source\nb,1,a\nc,,b\n",
        "\ufeffsource,target\r\na,b\r\nb,c\r\n",
        'source , target\n\n"a", b \n  \n\nb,c',
        "source,target\na,b\nb,c",
    ],
)
def test_other_columns_marks_and_blanks_do_not_count(write, content):
    network = read_network(write(content))
    assert sorted(network.names) == ["a", "b", "c"]
    assert network.m == 2


GRAPHS = "graph,source,target,w\none,a,b,1\ntwo,a,b,2\ntwo,b,c,3\n"


def test_the_column_graph_tells_graphs_apart(write):
    network = read_network(write(GRAPHS), name="two", weight="w")
    assert network.label == "g.csv (two)"
    assert network.weights == (Fraction(2), Fraction(3))


def test_a_single_graph_needs_no_name(write):
    path = write("graph,source,target\none,a,b\n")
    assert read_network(path).label == read_network(path, name="one").label == "g.csv (one)"


def test_faults_of_one_graph_do_not_spoil_another(write):
    path = write(GRAPHS + "bad,a,a,0\n")
    assert read_network(path, name="one", weight="w").m == 1
    with refused("graph", "line 5", "'a' to itself"):
        read_network(path, name="bad")


@pytest.mark.parametrize(
    "content, name, words",
    [
        (GRAPHS, None, ("holds 2 graphs", "one, two")),
        (GRAPHS, "tow", ("no graph 'tow'", r"Did you mean two\?", "one, two")),
        ("source,target\na,b\n", "one", ("no column 'graph'",)),
        ("graph,source,target\n,a,b\n", None, ("line 2", "no graph")),
        ("", None, ("g.csv is empty",)),
        ("\ufeff \n", None, ("empty",)),
        ("source,target\n", None, ("no line below its header",)),
        ("from,to\na,b\n", None, ("'from', 'to'", "a column 'source'", "Line 1")),
        ("source;target\na;b\n", None, ("'source;target'", "a column 'source'")),
        ("source,to\na,b\n", None, ("a column 'target'",)),
        ("source,source,target\na,a,b\n", None, ("2 columns 'source'",)),
        ("source,target\na,b,c\n", None, ("line 2: 3 fields below 2",)),
        ("source,target\na,b\nb\n", None, ("line 3: 1 fields below 2",)),
        ("source,target\na,\n", None, ("line 2: the field 'target' is empty",)),
        ("source,target\n,\n", None, ("line 2: the field 'source' is empty",)),
        ("source,target\n  ,b\n", None, ("line 2: the field 'source' is empty",)),
        ('source,target\n"a,b\n', None, ("line 2: unexpected end of data",)),
        ('source,target\n"a"x,b\n', None, ("line 2",)),
        ("source,target\na," + "b" * 200_000, None, ("line 2", "field larger")),
        ("source,target\nb,a\nc,c\n", None, ("line 3: an edge from 'c' to itself",)),
        ("source,target\na,b\nc,b\nb,a\n", None, ("line 4", "'a' and 'b'", "line 2", "once")),
        ("source,target\na,b\na,b\n", None, ("line 3", "line 2")),
    ],
)
def test_bad_csv_says_where(write, content, name, words):
    with refused("graph", *words):
        read_network(write(content), name=name)


@pytest.mark.parametrize("encoding", ["utf-16", "latin-1"])
def test_other_encodings_are_refused(write, encoding):
    with refused("graph", "not UTF-8", "Save it"):
        read_network(write("source,target\nü,b\n".encode(encoding)))


@given(networks(min_nodes=2, weighted=True).filter(lambda network: network.m > 0), st.data())
def test_csv_round_trip(network, data):
    names = data.draw(st.permutations(NASTY))[: network.n]
    weights = [str(weight) for weight in network.weights]
    text = io.StringIO()
    rows = [(names[i], names[j]) for i, j in network.edges.tolist()]
    lines = [(*row, weight) for row, weight in zip(rows, weights, strict=True)]
    csv.writer(text).writerows([("source", "target", "w"), *lines])
    again = csv_network(text.getvalue(), "drawn", weight="w")

    assert again.weights == network.weights
    assert [{again.names[i], again.names[j]} for i, j in again.edges] == [set(row) for row in rows]


# --------------------------------------------------------------------- weights


@pytest.mark.parametrize(
    "text, value",
    [
        ("1", Fraction(1)),
        ("0.1", Fraction(1, 10)),
        (" 2.50 ", Fraction(5, 2)),
        (".5", Fraction(1, 2)),
        ("3.", Fraction(3)),
        ("+7", Fraction(7)),
        ("1e-3", Fraction(1, 1000)),
        ("2.5E+2", Fraction(250)),
        ("1/3", Fraction(1, 3)),
        ("6/4", Fraction(3, 2)),
        ("1e300", Fraction(10**300)),
        ("1e-300", Fraction(1, 10**300)),
        ("0.1000000000000000055511151231257827", Fraction("0.1000000000000000055511151231257827")),
    ],
)
def test_a_weight_is_its_text(text, value):
    assert exact_weight(text, "here") == value


@pytest.mark.parametrize(
    "text",
    [
        *("", "x", "0", "0.0", "-1", "-1/2", "1/0", "0/5", "1/-2", "1.5/2", "inf", "Infinity"),
        *("nan", "1e301", "1e400", "1e-301", "1e999999999", "11e300", "0.1e-300", "1_0", "٣"),
        *("1,5", "0x1", "1e", "e5", ".", "1/3/5", "True", "1" * 401, "1" * 302),
    ],
)
def test_what_is_no_positive_finite_weight(text):
    with refused("weight", "here: the weight", "positive"):
        exact_weight(text, "here")


def test_a_bad_weight_says_its_line(write):
    with refused("weight", "g.csv, line 3: the weight '-2'"):
        read_network(write("source,target,w\na,b,1\nb,c,-2\n"), weight="w")
    with refused("weight", "g.csv, line 2: the weight ''"):
        read_network(write("source,target,w\na,b,\n"), weight="w")


def test_an_unknown_weight_is_told_the_nearest(write):
    path = write("source,target,distance\na,b,1\n")
    with refused("weight", "no column 'distanc'", r"Did you mean distance\?"):
        read_network(path, weight="distanc")
    with refused("weight", "no column 'source'"):
        read_network(path, weight="source")
    with refused("weight", "a file with weights"):
        read_network(write("source,target\na,b\n"), weight="w")


# --------------------------------------------------------------------- GraphML

KEYS = (
    '<key id="d0" for="node" attr.name="label" attr.type="string"/>'
    '<key id="d1" for="edge" attr.name="w" attr.type="double"/>'
    '<key id="d2" for="node" attr.name="name" attr.type="string"/>'
)
AB = '<node id="a"/><node id="b"/>'
SPACE = ' xmlns="http://graphml.graphdrawing.org/xmlns"'


def graphml(body: str, keys: str = KEYS, space: str = SPACE, attributes: str = "") -> str:
    """Document with one graph."""
    return f"<graphml{space}>{keys}<graph{attributes}>{body}</graph></graphml>"


@pytest.mark.parametrize("space", ["", SPACE, ' xmlns="urn:other"'])
@pytest.mark.parametrize("ending", ["g.graphml", "g.xml", "g.GraphML"])
def test_graphml_keeps_the_order_of_its_nodes(write, space, ending):
    edges = '<edge source="a" target="c"/><edge source="b" target="c"/>'
    nodes = '<node id="c"/><node id="alone"/><node id="b"/><node id="a"/>'
    network = read_network(write(graphml(edges + nodes, space=space), ending))
    assert list(network.names) == ["c", "alone", "b", "a"]
    assert network.edges.tolist() == [[0, 3], [0, 2]]
    assert network.components() == [[0, 2, 3], [1]]
    assert network.label == ending


def test_a_prefix_is_as_good_as_a_default_namespace():
    text = (
        '<g:graphml xmlns:g="urn:x" xmlns:y="urn:y"><y:node id="no"/><g:graph><g:node id="a">'
        '<y:node id="neither"/></g:node><g:node id="b"/><g:edge source="a" target="b"/>'
        "</g:graph></g:graphml>"
    )
    assert list(graphml_network(text, "g").names) == ["a", "b"]


@pytest.mark.parametrize("attribute", ["label", "name"])
@pytest.mark.parametrize(
    "titles, names",
    [
        (["x y", "</script>"], ["x y", "</script>"]),
        (["x", "x"], ["a", "b"]),
        (["x", ""], ["a", "b"]),
        (["x", None], ["a", "b"]),
    ],
)
def test_labels_name_the_nodes_if_all_differ(attribute, titles, names):
    key = {"label": "d0", "name": "d2"}[attribute]
    nodes = "".join(
        f'<node id="{id_}">' + f'<data key="{key}"> {escape(t or "")} </data>' * (t is not None)
        + "</node>"
        for id_, t in zip("ab", titles, strict=True)
    )  # fmt: skip
    network = graphml_network(graphml(nodes + '<edge source="a" target="b"/>'), "g")
    assert list(network.names) == names


@given(networks(min_nodes=2, weighted=True), st.data())
def test_graphml_round_trip_with_exact_weights(network, data):
    names = data.draw(st.permutations(NASTY))[: network.n]
    nodes = "".join(f"<node id={quoteattr(name)}/>" for name in names)
    edges = "".join(
        f"<edge source={quoteattr(names[i])} target={quoteattr(names[j])}>"
        f'<data key="d1">{weight}</data></edge>'
        for (i, j), weight in zip(network.edges.tolist(), network.weights, strict=True)
    )
    again = graphml_network(graphml(nodes + edges), "drawn", weight="w")
    assert list(again.names) == names
    assert again.edges.tolist() == network.edges.tolist()
    assert (again.weights or ()) == network.weights


def test_files_of_networkx_are_read(tmp_path):
    graph = nx.karate_club_graph()
    nx.write_graphml(graph, tmp_path / "karate.graphml")
    network = read_network(str(tmp_path / "karate.graphml"), weight="weight")
    weights = [Fraction(graph[i][j]["weight"]) for i, j in graph.edges()]
    assert network.edges.tolist() == [list(edge) for edge in graph.edges()]
    assert list(network.weights) == weights


def test_a_default_weight_counts():
    keys = '<key id="d1" for="edge" attr.name="w"><default> 1/3 </default></key>'
    edges = '<edge source="a" target="b"/><edge source="b" target="c"><data key="d1">0.1</data>'
    text = graphml(f'{AB}<node id="c"/>{edges}</edge>', keys)
    assert graphml_network(text, "g", weight="w").weights == (Fraction(1, 3), Fraction(1, 10))


DIRECTED = ' edgedefault="directed"'


def test_an_arc_and_its_reverse_are_one_edge():
    arcs = '<edge source="b" target="a"/><edge source="a" target="b"/>'
    assert graphml_network(graphml(AB + arcs, attributes=DIRECTED), "g").edges.tolist() == [[0, 1]]
    single = '<edge directed="true" source="b" target="a"/>'
    assert graphml_network(graphml(AB + single), "g").edges.tolist() == [[0, 1]]


def weighted(source: str, target: str, weight: str) -> str:
    return f'<edge source="{source}" target="{target}"><data key="d1">{weight}</data></edge>'


def test_an_arc_and_its_reverse_have_one_weight():
    same = AB + weighted("a", "b", "0.5") + weighted("b", "a", "1/2")
    network = graphml_network(graphml(same, attributes=DIRECTED), "g", weight="w")
    assert network.weights == (Fraction(1, 2),)
    other = AB + weighted("a", "b", "0.5") + weighted("b", "a", "2")
    with refused("weight", "'a' and 'b' weigh 1/2 and 2"):
        graphml_network(graphml(other, attributes=DIRECTED), "g", weight="w")


def two_graphs(first: str = "one", second: str = "two") -> str:
    edge = '<edge source="a" target="b"/>'
    graphs = "".join(f'<graph id="{id_}">{AB}{edge}</graph>' for id_ in (first, second))
    return f"<graphml{SPACE}>{graphs}</graphml>"


def test_an_id_tells_graphs_apart():
    assert graphml_network(two_graphs(), "g", name="two").label == "g (two)"


EDGE = '<edge source="a" target="b"/>'


@pytest.mark.parametrize(
    "content, words",
    [
        ("<!DOCTYPE graphml><graphml/>", ("DOCTYPE",)),
        (
            '<!DOCTYPE x [<!ENTITY a "aa"><!ENTITY b "&a;&a;">]><graphml>&b;</graphml>',
            ("DOCTYPE or ENTITY",),
        ),
        ("no xml", ("no well-formed XML",)),
        ("<graphml>", ("no well-formed XML",)),
        ("<graphml>&what;</graphml>", ("no well-formed XML",)),
        ("<graphml>\0</graphml>", ("no well-formed XML",)),
        ("<html/>", ("root <html>",)),
        ("<graphml/>", ("no <graph>",)),
        (graphml(""), ("no node",)),
        (graphml(EDGE), ("no node",)),
        (graphml(AB + '<edge source="a" target="c"/>'), ("edge 1 ends at 'c'",)),
        (graphml(AB + '<edge id="e" source="a"/>'), ("edge 'e' lacks an end",)),
        (graphml(AB + AB), ("two nodes with the id 'a'",)),
        (graphml('<node id=""/>'), ("a node without an id",)),
        (graphml("<node/>"), ("a node without an id",)),
        (graphml(AB + '<edge source="b" target="b"/>'), ("edge 1: an edge from 'b' to itself",)),
        (graphml(AB + EDGE + EDGE), ("edge 2", "'a' and 'b'", "edge 1")),
        (graphml(AB + EDGE + '<edge source="b" target="a"/>'), ("edge 2",)),
        (graphml(AB + EDGE + EDGE, attributes=DIRECTED), ("edge 2",)),
        (
            graphml(AB + 2 * (EDGE + '<edge source="b" target="a"/>'), attributes=DIRECTED),
            ("edge 3",),
        ),
        (
            graphml(AB + EDGE + '<edge directed="true" source="b" target="a"/>'),
            ("edge 2",),
        ),
        (graphml('<node id="a"><graph><node id="b"/></graph></node>'), ("a nested graph",)),
        (graphml("<graph/>"), ("a nested graph",)),
        (graphml('<node id="a"><node id="b"/></node>'), ("a <node> inside <node>",)),
        (f"<graphml>{AB}</graphml>", ("a <node> inside <graphml>",)),
        (graphml(AB + '<hyperedge><endpoint node="a"/></hyperedge>'), ("a <hyperedge>",)),
        (graphml('<node id="a"><port name="p"/></node>'), ("a <port>",)),
        (graphml(AB + '<edge source="a" target="b" sourceport="p"/>'), ("edge 1 ends at a port",)),
        (graphml('<node id="a"><data key="d9">x</data></node>'), ("the key 'd9'", "declared")),
        (two_graphs(), ("holds 2 graphs", "one, two")),
        (two_graphs("one", "one"), ("graphs of the same id",)),
    ],
)
def test_bad_graphml_says_what(write, content, words):
    with refused("graph", *words):
        read_network(write(content, "g.graphml"))


def test_an_unknown_graph_is_told_the_nearest():
    with refused("graph", "no graph 'tow'", r"Did you mean two\?"):
        graphml_network(two_graphs(), "g", name="tow")


@pytest.mark.parametrize(
    "body, weight, words",
    [
        (AB + EDGE, "w", "edge 1 has no attribute 'w'"),
        (AB + EDGE, "x", "no edge attribute 'x'"),
        (AB + EDGE, "label", "no edge attribute 'label'"),
        (AB + weighted("a", "b", "-1"), "w", "edge 1: the weight '-1'"),
        (AB + weighted("a", "b", "NaN"), "w", "edge 1: the weight 'NaN'"),
        (
            AB
            + '<edge source="a" target="b"><data key="d1">1</data><data key="d1">2</data></edge>',
            "w",
            "edge 1 has 2 of them",
        ),
    ],
)
def test_bad_weights_say_their_edge(body, weight, words):
    with refused("weight", words):
        graphml_network(graphml(body), "g", weight=weight)


def test_weights_that_nobody_asked_for_are_left_alone():
    assert graphml_network(graphml(AB + weighted("a", "b", "NaN")), "g").weights is None


@pytest.mark.parametrize("encoding", ["UTF-16", "utf-7", "shift_jis", "nonsense"])
def test_a_file_is_utf_8_whatever_it_claims(write, encoding):
    declaration = f'<?xml version="1.0" encoding="{encoding}"?>'
    body = '<node id="ü"/><node id="b"/><edge source="ü" target="b"/>'
    path = write(declaration + graphml(body), "g.xml")
    assert list(read_network(path).names) == ["ü", "b"]


def test_what_lies_inside_data_is_somebody_elses():
    inner = f'<data key="d0">x<graph>{AB}{AB}<hyper/></graph></data>'
    network = graphml_network(graphml(f'<node id="a">{inner}</node><node id="b"/>{EDGE}'), "g")
    assert list(network.names) == ["a", "b"]


def test_depth_and_length_do_no_harm(write):
    deep = "<graphml>" + "<a>" * 100_000 + "</a>" * 100_000 + "</graphml>"
    with refused("graph", "no <graph>"):
        read_network(write(deep, "g.graphml"))


def test_names_of_a_stranger_play_no_tricks_with_a_terminal(write):
    path = write("graph,source,target\n\x1b[2J,a\x07,b\nother,\u202ec,d\nother,c\x07,c\x07\n")
    for name in (None, "\x1b[2", "other"):
        with pytest.raises(InputError) as caught:
            read_network(path, name=name)
        assert all(line.isprintable() for line in str(caught.value).splitlines())
    assert read_network(path, name="\x1b[2J").label.isprintable()


# ----------------------------------------------------------------------- paths


def test_files_that_cannot_be_taken(write, tmp_path, monkeypatch):
    (tmp_path / "folder.csv").mkdir()
    with refused("graph", "no regular file"):
        read_network(str(tmp_path / "folder.csv"))
    with refused("graph", "ends in '.txt'"):
        read_network(write("source,target\na,b\n", "g.txt"))
    with refused("graph", "there is no such file"):
        read_network(str(tmp_path / "missing.csv"))
    with refused("graph", "there is no such file"):
        read_network(write("source,target\na,b\n") + "/g.csv")
    monkeypatch.setattr(network_files, "MAX_BYTES", 10)
    with refused("graph", "g.csv is larger"):
        read_network(write("source,target\na,b\n"))


def test_a_file_that_may_not_be_opened(write, monkeypatch):
    def refuse(*_args):
        raise PermissionError(13, "Permission denied")

    path = write("source,target\na,b\n")
    monkeypatch.setattr(Path, "open", refuse)
    with refused("graph", "cannot be read .Permission denied."):
        read_network(path)
