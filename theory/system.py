"""One estimator as symbols: signals, parameters, laws, guards and the claims about it."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from .claims import Assumption, Claim, Gap
from .expressions import canonical, check_comparison, names
from .kinds import FormulaError, Kind
from .symbols import DOMAINS, FRAMES, Guard, Law, Parameter, Signal, need
from .units import parse_unit

__all__ = ["DOMAINS", "FRAMES", "Guard", "Law", "Parameter", "Signal", "System"]


@dataclass(frozen=True)
class System:
    """One estimator or controller of a paper; checks itself when it is made.

    Parameters
    ----------
    name : str
        Short name, the first part of claim ids.
    title, citation : str
        What it is; author, title and year.
    signals, parameters : tuple
        Everything that laws and guards speak about, each used at least once.
    laws, guards : tuple
        Their units and shapes agree.
    claims : tuple of Claim
    dimensions : mapping of str to str, optional
        Sizes that are left open, with their meaning.
    units : mapping of str to str, optional
        Units that are left open, with their meaning.
    gaps : tuple of Gap, optional
        Printed statements that the text does not determine, so that they are no claims.

    Raises
    ------
    ValueError
        A name is taken twice, not declared or not used; a unit cannot be read; the sides of a law
        or guard differ in unit or shape; a claim belongs to another system.
    """

    name: str
    title: str
    citation: str
    signals: tuple[Signal, ...]
    parameters: tuple[Parameter, ...]
    laws: tuple[Law, ...]
    guards: tuple[Guard, ...]
    claims: tuple[Claim, ...]
    dimensions: Mapping[str, str] = field(default_factory=dict)
    units: Mapping[str, str] = field(default_factory=dict)
    gaps: tuple[Gap, ...] = ()

    def __post_init__(self) -> None:
        need(self.name.isidentifier(), repr(self.name), "an identifier is needed as a name")
        labels = [symbol.name for symbol in self.symbols]
        _once(self.name, "symbol", [*labels, *self.dimensions])
        _once(self.name, "guard", [guard.name for guard in self.guards])
        _once(self.name, "claim", [claim.id for claim in self.claims])
        self._check_claims()
        self._check_formulas()
        self._check_use()

    def _check_claims(self) -> None:
        known: dict[str, Assumption] = {}
        for claim in self.claims:
            need(claim.system == self.name, self.name, f"{claim.id} belongs to {claim.system}")
            for given in claim.assumes:
                same = known.setdefault(given.id, given) == given
                need(same, self.name, f"assumption {given.id} has two texts; one is needed")

    def _check_formulas(self) -> None:
        kinds = self.kinds()
        equations = [(law.equation, law.tree) for law in self.laws]
        for where, tree in [*equations, *((guard.name, guard.tree) for guard in self.guards)]:
            try:
                check_comparison(tree, kinds)
            except FormulaError as error:
                raise FormulaError(f"{self.name}, {where}: {error}") from error

    def _check_use(self) -> None:
        trees = [line.tree for line in self.laws] + [line.tree for line in self.guards]
        used = {name for tree in trees for name in names(tree)}
        unused = sorted({symbol.name for symbol in self.symbols} - used)
        need(not unused, self.name, f"unused symbols {', '.join(unused)}; each must be in a law")
        sizes = {size for symbol in self.symbols for size in symbol.shape if isinstance(size, str)}
        bases = {name for kind in self.kinds().values() for name, _ in kind.unit.powers}
        idle = sorted({*self.dimensions} - sizes) + sorted({*self.units} - bases)
        need(not idle, self.name, f"unused dimensions or units {', '.join(idle)}")

    @property
    def symbols(self) -> tuple[Signal | Parameter, ...]:
        """Signals, then parameters."""
        return (*self.signals, *self.parameters)

    def kinds(self) -> dict[str, Kind]:
        """Unit and shape of each signal and parameter, by name."""
        found: dict[str, Kind] = {}
        for symbol in self.symbols:
            for size in symbol.shape:
                known = not isinstance(size, str) or size in self.dimensions
                need(known, symbol.name, f"dimension {size} is not declared")
            shape = (*symbol.shape, 1, 1)[:2]
            try:
                found[symbol.name] = Kind(parse_unit(symbol.unit, self.units), (shape[0], shape[1]))
            except ValueError as error:
                raise ValueError(f"{symbol.name}: {error}") from error
        return found

    def law(self, equation: str) -> Law:
        """Return the one law with this number.

        Raises
        ------
        KeyError
            There is none, or there are several.
        """
        found = [law for law in self.laws if law.equation == equation]
        if len(found) != 1:
            raise KeyError(f"{self.name}: {len(found)} laws have the number {equation}")
        return found[0]

    def canonical_text(self) -> str:
        """Everything mathematical as one text, the same in every run; no words about it."""
        kinds = self.kinds()
        frames = {signal.name: signal.frame for signal in self.signals}
        domains = {parameter.name: parameter.domain for parameter in self.parameters}
        symbols = [
            [name, str(kind.unit), [str(size) for size in kind.shape], frames.get(name)]
            for name, kind in kinds.items()
        ]
        content = {
            "name": self.name,
            "symbols": sorted(symbols, key=lambda symbol: str(symbol[0])),
            "domains": domains,
            "laws": sorted([law.equation, canonical(law.tree)] for law in self.laws),
            "guards": sorted(canonical(guard.tree) for guard in self.guards),
            "claims": sorted(_mathematics(claim) for claim in self.claims),
        }
        return json.dumps(content, sort_keys=True, separators=(",", ":"))

    @property
    def digest(self) -> str:
        """SHA-256 of the canonical text, in hexadecimal."""
        return hashlib.sha256(self.canonical_text().encode()).hexdigest()


def _mathematics(claim: Claim) -> list[str]:
    """What a claim says, without its title: the statement in words and the formula."""
    head = [claim.id, claim.source, claim.sense, claim.statement, claim.formula, claim.printed]
    return head + sorted(claim.assumptions)


def _once(whose: str, what: str, labels: Iterable[str]) -> None:
    listed = list(labels)
    twice = sorted({label for label in listed if listed.count(label) > 1})
    need(not twice, whose, f"{what} {', '.join(twice)} stands twice; once is needed")
