"""``sensortrack data``: the real networks that are shipped."""

from __future__ import annotations

import argparse

from . import listing

add_arguments = listing.add_json


def run(options: argparse.Namespace) -> int:
    """List name, nodes and edges."""
    from sensortrack.data import load_network, real_networks

    networks = [load_network(name) for name in real_networks()]
    entries = [
        {"graph": network.label, "nodes": network.n, "edges": network.m} for network in networks
    ]
    listing.show(entries, ["{graph}", "{nodes} nodes", "{edges} edges"], options.json)
    return 0
