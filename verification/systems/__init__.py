"""One folder a system: how its claims are decided, what can be asked about it.

`SYSTEMS` finds the folders and imports what is in them only when it is asked for.
"""

from __future__ import annotations

import pkgutil
from collections.abc import Mapping
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
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
    def design(self) -> ModuleType | None:
        """The module with ``DESIGNS``, or None where nothing can be chosen."""
        name = f"{__name__}.{self.name}.design"
        return import_module(name) if find_spec(name) else None

    @property
    def claims(self) -> ModuleType:
        """The module with ``DECISIONS``."""
        return import_module(f"{__name__}.{self.name}.claims")


SYSTEMS: Mapping[str, Room] = {
    found.name: Room(found.name) for found in pkgutil.iter_modules(__path__) if found.ispkg
}
"""Short name to room, in alphabetical order."""
