"""Laws to scalar lines: matrices become entries, common parts get names, order is kept."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from ..expressions import Tree, canonical
from .safe import direction, guarded, signs
from .scalars import Algebra, Expr, Matrix, Pool
from .stepper import Assignment, Program, Slot, Stepper

Given = Mapping[str, Sequence[Sequence[Fraction]]]
"""Slots of the context whose values are constants of the generated source."""


@dataclass(frozen=True)
class Line:
    """``name = expr``; `heading` stands before the first line of a group."""

    name: str
    expr: Expr
    heading: str = ""


@dataclass(frozen=True)
class Lowered:
    """One function as scalar lines.

    Parameters
    ----------
    program : Program
    lines : tuple of Line
    results : tuple of Expr
        One an entry of the resulting group, in the order of its slots.
    names : mapping
        Expression object to the name that is printed for it.
    """

    program: Program
    lines: tuple[Line, ...]
    results: tuple[Expr, ...]
    names: Mapping[int, str]


def entries(slot: Slot, n: int) -> list[str]:
    """Names of a slot's scalars: ``h``, ``u_0``, ``M_01`` (upper triangle by rows)."""
    if not slot.shape:
        return [slot.name]
    if len(slot.shape) == 1:
        return [f"{slot.name}_{i}" for i in range(n)]
    return [f"{slot.name}_{i}{j}" for i in range(n) for j in range(i, n)]


def lower(stepper: Stepper, program: Program, n: int, given: Given) -> Lowered:
    """Write one function of a stepper as scalar lines.

    Parameters
    ----------
    stepper, program : Stepper, Program
    n : int
        Coordinates.
    given : mapping
        Values that become constants.
    """
    work = _Lowering(stepper, n, given)
    for assignment in program.assignments:
        work.assign(assignment)
    slots = stepper.groups[program.output]
    results = tuple(x for slot in slots for (x,) in work.values[program.results[slot.name]])
    lines, names = _named(work.roots, results)
    return Lowered(program, lines, results, names)


class _Lowering:
    """Values of all names so far, and the lines that made them."""

    def __init__(self, stepper: Stepper, n: int, given: Given) -> None:
        self.pool = Pool()
        self.algebra = Algebra(self.pool)
        self.sums = stepper.sums
        self.n = n
        self.roots: list[Line] = []
        self.values: dict[str, Matrix] = {}
        for slots in stepper.groups.values():
            for slot in slots:
                self.values[slot.name] = self._slot(slot, given.get(slot.name))

    def _slot(self, slot: Slot, value: Sequence[Sequence[Fraction]] | None) -> Matrix:
        if value is not None:
            return tuple(tuple(self.pool.const(x) for x in row) for row in value)
        if len(slot.shape) < 2:
            return tuple((self.pool.name(name),) for name in entries(slot, self.n))
        rows = [
            [f"{slot.name}_{min(i, j)}{max(i, j)}" for j in range(self.n)] for i in range(self.n)
        ]
        return tuple(tuple(self.pool.name(name) for name in row) for row in rows)

    def assign(self, assignment: Assignment) -> None:
        """Compute one target."""
        stem = _stem(assignment.target)
        heading = f"{assignment.target}, {assignment.source}"
        value = self.evaluate(assignment.tree)
        if assignment.guard:
            value = self._guarded(assignment, value, stem, heading)
        elif assignment.factor is not None:
            value = self._solved(self.evaluate(assignment.factor), value, stem, heading)
        else:
            value = self._record(stem, value, heading)
        self.values[assignment.target] = value

    def evaluate(self, tree: Tree) -> Matrix:
        """The entries of a formula.

        Raises
        ------
        ValueError
            The formula has something that no language is generated from.
        """
        algebra = self.algebra
        match tree:
            case ("number", int(number)):
                return ((self.pool.const(number),),)
            case ("name", str(name)):
                return self.values[name]
            case ("power", base, int(exponent)):
                return algebra.power(self.evaluate(base), exponent)
            case ("call", "T", inner):
                return algebra.transpose(self.evaluate(inner))
            case ("call", "next", ("name", str(name))):
                return self.values[f"next({name})"]
            case ("call", "sum", _):
                return self.values[self.sums[canonical(tree)]]
            case ("call", "sin" | "cos" | "column" | "sgn", *_) | (
                "direction" | "entry" | "rows",
                *_,
            ):
                return self._plane(tree)
            case (str(sign), left, right) if sign in "+-*/":
                operation = {"+": algebra.add, "-": algebra.sub, "*": algebra.mul, "/": algebra.div}
                return operation[sign](self.evaluate(left), self.evaluate(right))
        raise ValueError(f"{canonical(tree)} cannot be generated")

    def _plane(self, tree: Tree) -> Matrix:
        """What bearings need: angles, entries, signs."""
        match tree:
            case ("call", "sin" | "cos" as function, inner):
                return ((self.pool.call(function, self.evaluate(inner)[0][0]),),)
            case ("call", "column", *parts):
                return tuple(self.evaluate(part)[0] for part in parts)
            case ("call", "sgn", ("-", left, right)):
                return signs(self.pool, self.evaluate(left), self.evaluate(right))
            case ("direction", inner):
                return direction(self.pool, self.evaluate(inner))
            case ("entry", inner, int(i), int(j)):
                return ((self.evaluate(inner)[i][j],),)
            case ("rows", *rows):
                return tuple(tuple(self.evaluate(x)[0][0] for x in row) for row in rows)
        raise ValueError(f"{canonical(tree)} cannot be generated")

    def _guarded(self, given: Assignment, b: Matrix, stem: str, heading: str) -> Matrix:
        """Solve A x = b for symmetric A of two rows where det A is large enough, else 0."""
        ((bound,),) = self.values[given.guard]
        solved = guarded(self.pool, self.evaluate(given.factor or ()), b, bound)
        for name, expr in solved.parts.items():
            self._line(f"{stem}_{name}", expr, heading)
            heading = ""
        self.values[f"status({given.target})"] = ((solved.known,),)
        return self._record(stem, solved.values, "")

    def _record(self, stem: str, value: Matrix, heading: str) -> Matrix:
        """Give each entry a line of its own."""
        for i, (expr,) in enumerate(value):
            name = f"{stem}_{i}" if len(value) > 1 else f"{stem}_0"
            self.roots.append(Line(name, expr, heading if i == 0 else ""))
        return value

    def _solved(self, a: Matrix, b: Matrix, stem: str, heading: str) -> Matrix:
        """Solve A x = b for symmetric positive definite A: A = L D L', without square roots."""
        pool, n = self.pool, len(a)
        pivots: list[Expr] = []
        lower: list[list[Expr]] = []
        weighted: list[list[Expr]] = []
        for i in range(n):
            lower.append([])
            weighted.append([])
            for j in range(i):
                rest = self._less(a[i][j], weighted[i], lower[j][:j])
                self._line(f"{stem}_w{i}{j}", rest, heading)
                weighted[i].append(rest)
                heading = ""
                factor = pool.div(rest, pivots[j])
                self._line(f"{stem}_l{i}{j}", factor)
                lower[i].append(factor)
            pivot = self._less(a[i][i], weighted[i], lower[i])
            self._line(f"{stem}_d{i}", pivot, heading)
            heading = ""
            pivots.append(pivot)
        forward: list[Expr] = []
        for i in range(n):
            forward.append(self._less(b[i][0], lower[i], forward))
            self._line(f"{stem}_y{i}", forward[i])
        solution: dict[int, Expr] = {}
        for i in reversed(range(n)):
            start = pool.div(forward[i], pivots[i])
            later = range(i + 1, n)
            solution[i] = self._less(
                start, [lower[j][i] for j in later], [solution[j] for j in later]
            )
            self._line(f"{stem}_{i}", solution[i])
        return tuple((solution[i],) for i in range(n))

    def _less(self, start: Expr, left: Sequence[Expr], right: Sequence[Expr]) -> Expr:
        """start minus the sum of products."""
        total = start
        for a, b in zip(left, right, strict=False):
            total = self.pool.sub(total, self.pool.mul(a, b))
        return total

    def _line(self, name: str, expr: Expr, heading: str = "") -> None:
        self.roots.append(Line(name, expr, heading))


def _stem(target: str) -> str:
    """``next(b_hat)`` becomes ``b_hat_next``."""
    head, _, inner = target.partition("(")
    return f"{inner[:-1]}_{head}" if inner else head


def _named(
    roots: Sequence[Line], results: Sequence[Expr]
) -> tuple[tuple[Line, ...], dict[int, str]]:
    """Lines in order, with the parts that are used twice before their first use."""
    wanted = {id(line.expr) for line in roots}
    uses = Counter(id(part) for line in roots for part in _parts(line.expr, wanted))
    uses.update(id(result) for result in results)
    names: dict[int, str] = {}
    lines: list[Line] = []
    heading = ""
    for line in roots:
        heading = line.heading or heading
        if line.expr.leaf or id(line.expr) in names:
            continue
        shared = [
            part
            for part in _inner(line.expr, wanted)
            if uses[id(part)] > 1 and id(part) not in names
        ]
        for k, part in enumerate(shared):
            names[id(part)] = f"{line.name}_part{k}"
            lines.append(Line(names[id(part)], part, heading))
            heading = ""
        names[id(line.expr)] = line.name
        lines.append(Line(line.name, line.expr, heading))
        heading = ""
    return tuple(lines), names


def _parts(expr: Expr, wanted: set[int]) -> Iterator[Expr]:
    """Every use of a part in a line; what has a line of its own is not looked into."""
    seen: set[int] = set()
    stack = [*expr.args]
    while stack:
        part = stack.pop()
        yield part
        if id(part) not in seen and id(part) not in wanted:
            seen.add(id(part))
            stack.extend(part.args)


def _inner(expr: Expr, wanted: set[int]) -> Iterator[Expr]:
    """Composite parts without a line of their own, deepest first and each once."""
    seen: set[int] = set()

    def visit(part: Expr) -> Iterator[Expr]:
        if part.leaf or id(part) in seen or id(part) in wanted:
            return
        seen.add(id(part))
        for inner in part.args:
            yield from visit(inner)
        yield part

    for part in expr.args:
        yield from visit(part)
