"""Agents that leave and join between two steps."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from sensortrack.errors import InputError
from sensortrack.networks import Network

from .stepper import ConsensusState, SignConsensus, StepStatus


def change_members(
    law: SignConsensus,
    state: ConsensusState,
    network: Network,
    r: ArrayLike,
    heirs: Mapping[str, str | None] | None = None,
) -> tuple[SignConsensus, ConsensusState]:
    """Go on with another network, whose agents keep their w by name.

    Parameters
    ----------
    law : SignConsensus
    state : ConsensusState
        Of that law.
    network : Network
        The new one. Agents that join have w = 0, which moves nobody's mean.
    r : array (n, K)
        The signals of the new network's agents.
    heirs : mapping of str to str or None, optional
        For each agent that leaves the one that takes over its w. With None instead it is lost: the
        n - 1 survivors then agree on their mean plus -w/(n - 1), for ever. An agent that had agreed
        with all others leaves the error (r_i - mean)/(n - 1).

    Returns
    -------
    law, state
        For the new network.

    Raises
    ------
    InputError
        With the name ``heirs``: an agent leaves without, the heir is none that stays, or one named
        does not leave. With the name ``r``: as `SignConsensus.init` does.
    """
    later = replace(law, network=network)
    given = heirs or {}
    places = {name: i for i, name in enumerate(network.names)}
    before = {name: i for i, name in enumerate(law.network.names)}
    for name in given:
        if name not in before or name in places:
            raise InputError("heirs", f"{name!r} does not leave", "agents that leave are needed")
    w = np.zeros((network.n, state.w.shape[1]))
    for name, i in before.items():
        if name in places:
            w[places[name]] += state.w[i]
            continue
        if name not in given:
            cure = f"name the agent that takes over its w, or {{{name!r}: None}} to lose it"
            raise InputError("heirs", f"{name!r} leaves without one", "an heir is needed", cure)
        heir = given[name]
        if heir is None:
            continue
        if heir not in places:
            found = f"{heir!r} for {name!r}"
            raise InputError("heirs", found, "an agent of the new network is needed")
        w[places[heir]] += state.w[i]
    signal = later.init(r).x
    if signal.shape != w.shape:
        raise InputError("r", f"shape {signal.shape}", f"the shape {w.shape} is needed")
    links = later.links
    rows = links.packed(w), links.packed(w + signal)
    return later, ConsensusState(links, *rows, StepStatus(law.method))
