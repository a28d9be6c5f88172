"""``sensortrack claims``: what the papers print."""

from __future__ import annotations

import argparse

from . import listing

add_arguments = listing.add_system


def run(options: argparse.Namespace) -> int:
    """List id, source and title."""
    entries = [
        {
            "id": claim.id,
            "system": claim.system,
            "source": claim.source,
            "title": claim.title,
            "statement": claim.statement,
            "formula": claim.formula,
            "sense": claim.sense,
            "assumptions": list(claim.assumptions),
            "printed": claim.printed or None,
        }
        for system in listing.chosen(options.system)
        for claim in system.claims
    ]
    listing.show(entries, ["{id}", "{source}", "{title}"], options.json)
    return 0
