"""One folder a system: how its claims are decided, what can be asked about it.

`SYSTEMS` finds the folders and imports what is in them only when it is asked for.
"""

from __future__ import annotations

import pkgutil
from collections.abc import Mapping
from dataclasses import dataclass
from importlib import import_module
from types import ModuleType


@dataclass(frozen=True)
class Room:
    """The proofs of one system.

    Parameters
    ----------
    name : str
        Short name of the system, which is its folder's name.
    """

    name: str

    @property
    def quantities(self) -> ModuleType:
        """The module with ``QUANTITIES`` and ``CONDITIONS``."""
        return import_module(f"{__name__}.{self.name}.quantities")

    @property
    def claims(self) -> ModuleType:
        """The module with ``DECISIONS``."""
        return import_module(f"{__name__}.{self.name}.claims")


SYSTEMS: Mapping[str, Room] = {
    found.name: Room(found.name) for found in pkgutil.iter_modules(__path__) if found.ispkg
}
"""Short name to room, in alphabetical order."""
