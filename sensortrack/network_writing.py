"""Networks as GraphML that `read_network` reads back."""

from __future__ import annotations

import re
from xml.sax.saxutils import escape

from sensortrack.errors import InputError
from sensortrack.networks import Network

FORBIDDEN = re.compile("[^\t\n\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""Characters that no XML document may hold, and the carriage return, which readers change."""

HEAD = """<?xml version="1.0" encoding="UTF-8"?>
<graphml xmlns="http://graphml.graphdrawing.org/xmlns">
  <key id="label" for="node" attr.name="label" attr.type="string"/>
  <key id="weight" for="edge" attr.name="weight" attr.type="string"/>
  <graph id="network" edgedefault="undirected">
"""


def graphml_text(network: Network) -> str:
    """The network as a GraphML document.

    Parameters
    ----------
    network : Network

    Returns
    -------
    str
        Nodes and edges in their order; the names are labels, exact weights the attribute
        ``weight``, which is left out where all are one.

    Raises
    ------
    InputError
        A name holds characters that XML cannot.
    """
    for name in network.names:
        if FORBIDDEN.search(name):
            raise InputError("graph", f"the name {name!r}", "names without control characters")
    lines = [
        f'    <node id="n{i}"><data key="label">{escape(name)}</data></node>\n'
        for i, name in enumerate(network.names)
    ]
    for place, (i, j) in enumerate(network.edges.tolist()):
        ends = f'    <edge source="n{i}" target="n{j}"'
        weight = "" if network.weights is None else str(network.weights[place])
        inner = f'><data key="weight">{weight}</data></edge>\n' if weight else "/>\n"
        lines.append(ends + inner)
    return "".join([HEAD, *lines, "  </graph>\n</graphml>\n"])
