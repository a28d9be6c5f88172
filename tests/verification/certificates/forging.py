"""Tools of a forger, and what is asked of every forgery."""

import copy
import random

from verification.certificates import check

from .documents import judged_in_memory
from .truths import is_true


def refused_or_restated(forged, known):
    """True if refused; else the forged data are printed, and the statement is true of them."""
    entry, status = judged_in_memory(forged, known)
    assert status in (0, 1, 2)
    if not entry["valid"]:
        assert status != 0
        assert entry["reason"]
        return True
    assert status == 0
    assert entry["inputs"] == forged["inputs"]
    assert (entry["lower"], entry["upper"]) == (forged.get("lower"), forged.get("upper"))
    assert is_true(entry), entry
    return False


def share(items, most, seed):
    """All of a few items; of many, as many as are given, in their order and drawn by the seed."""
    places = range(len(items))
    drawn = random.Random(seed).sample(places, min(most, len(items)))
    return [items[k] for k in sorted(drawn)]


def leaves(value, path=()):
    """Where numbers stand in a document: (path, number)."""
    if isinstance(value, dict):
        for key in value:
            yield from leaves(value[key], (*path, key))
    elif isinstance(value, list):
        for index, entry in enumerate(value):
            yield from leaves(entry, (*path, index))
    elif isinstance(value, int) or check.NUMBER.fullmatch(str(value)):
        yield path, value


def altered(made, path, change):
    forged = copy.deepcopy(made)
    place = forged
    for key in path[:-1]:
        place = place[key]
    place[path[-1]] = change(place[path[-1]])
    return forged


def numbers(made):
    parts = {key: made[key] for key in ("inputs", "witness", "lower", "upper") if key in made}
    return list(leaves(parts))
