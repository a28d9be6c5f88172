"""Certificates of universal statements, whose witness is how theory derived them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from theory.algebra.identities import Identity

from .make import certificate

Document = dict[str, Any]


@dataclass(frozen=True)
class Derivations:
    """The universal statements of a system.

    Parameters
    ----------
    system : str
    known : mapping of str to tuple of Identity
        Name of a statement to the identities that prove it.
    """

    system: str
    known: Mapping[str, tuple[Identity, ...]]

    def proof(self, name: str, case: str = "PROVED") -> Document:
        """Certificate of one universal statement.

        Parameters
        ----------
        name : str
        case : str, optional

        Returns
        -------
        dict

        Raises
        ------
        KeyError
            There is no such statement.
        CertificateError
            The checker refuses it.
        """
        witness = [{"kind": "derivation", **entry.to_data()} for entry in self.known[name]]
        return certificate(self.system, name, {}, witness, case)

    def proofs(self, *names: str) -> dict[str, Document]:
        """Certificates of proved statements, by the stems of their files."""
        return {f"{self.system}.{name}": self.proof(name) for name in names}

    def disproof(self, name: str) -> dict[str, Document]:
        """Certificate of a statement that refutes a claim, by the stem of its file."""
        return {f"{self.system}.{name}": self.proof(name, "REFUTED")}

    def replayed(
        self, name: str, inputs: Mapping[str, Any], case: str = "REFUTED"
    ) -> dict[str, Document]:
        """Certificate of a statement about data that asks for no witness, by its stem.

        Raises
        ------
        CertificateError
            The data do not do what the statement says.
        """
        return {f"{self.system}.{name}": certificate(self.system, name, inputs, [], case)}
