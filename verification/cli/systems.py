"""``sensortrack systems``: the estimators."""

from __future__ import annotations

import argparse

from . import listing

add_arguments = listing.add_json


def run(options: argparse.Namespace) -> int:
    """List name, title and citation."""
    entries = [
        {
            "system": system.name,
            "title": system.title,
            "citation": system.citation,
            "claims": len(system.claims),
            "digest": system.digest,
        }
        for system in listing.chosen(None)
    ]
    listing.show(entries, ["{system}", "{title}", "{citation}"], options.json)
    return 0
