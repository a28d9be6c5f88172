"""Polynomials in matrices that do not commute: identities for every size at once.

A `Form` is a sum of rational coefficients times powers of commuting scalars times words of
letters. Letters stand for matrices and vectors of any size that fits, so that an identity between
forms holds for all of them. Powers of scalars may be negative; letters have no inverse.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction

Key = tuple[tuple[tuple[str, int], ...], tuple[str, ...]]


@dataclass(frozen=True)
class Form:
    """A polynomial in non-commuting letters and commuting scalars.

    Parameters
    ----------
    terms : mapping
        ``(((scalar, power), ...), (letter, ...))`` to coefficient. A letter that ends in ``'`` is a
        transpose.
    symmetric : frozenset of str
        Letters that equal their transpose.
    """

    terms: Mapping[Key, Fraction]
    symmetric: frozenset[str] = frozenset()

    def __post_init__(self) -> None:
        object.__setattr__(self, "terms", {key: a for key, a in self.terms.items() if a})

    def __add__(self, other: Form) -> Form:
        terms = dict(self.terms)
        for key, a in other.terms.items():
            terms[key] = terms.get(key, Fraction(0)) + a
        return Form(terms, self.symmetric | other.symmetric)

    def __neg__(self) -> Form:
        return Form({key: -a for key, a in self.terms.items()}, self.symmetric)

    def __sub__(self, other: Form) -> Form:
        return self + -other

    def __mul__(self, other: Form | int | Fraction) -> Form:
        if not isinstance(other, Form):
            return Form({key: a * other for key, a in self.terms.items()}, self.symmetric)
        terms: dict[Key, Fraction] = {}
        for (s, v), a in self.terms.items():
            for (t, w), b in other.terms.items():
                key = (_merged(s, t), v + w)
                terms[key] = terms.get(key, Fraction(0)) + a * b
        return Form(terms, self.symmetric | other.symmetric)

    def __rmul__(self, other: int | Fraction) -> Form:
        return self * other

    @property
    def T(self) -> Form:
        """The transpose."""

        def flipped(letter: str) -> str:
            if letter.endswith("'"):
                return letter[:-1]
            return letter if letter in self.symmetric else letter + "'"

        terms = {(s, tuple(flipped(x) for x in reversed(w))): a for (s, w), a in self.terms.items()}
        return Form(terms, self.symmetric)

    def substitute(self, values: Mapping[str, Form]) -> Form:
        """Replace letters and scalars (to positive powers) by forms."""
        total = Form({}, self.symmetric)
        for (scalars, word), a in self.terms.items():
            product = Form({((), ()): a}, self.symmetric)
            for name, power in scalars:
                factor = values.get(name)
                for _ in range(power if factor else 0):
                    product = product * factor  # type: ignore[operator]
                if factor is None:
                    product = product * Form({(((name, power),), ()): Fraction(1)})
            for letter in word:
                value = values.get(letter.rstrip("'"), Form({((), (letter,)): Fraction(1)}))
                flip = letter.endswith("'") and letter[:-1] in values
                product = product * (value.T if flip else value)
            total = total + product
        return total

    def coefficient(self, scalar: str, power: int) -> Form:
        """The part with ``scalar`` to ``power``, that scalar removed."""
        terms = {
            (tuple(f for f in s if f[0] != scalar), w): a
            for (s, w), a in self.terms.items()
            if dict(s).get(scalar, 0) == power
        }
        return Form(terms, self.symmetric)

    def before(self, letter: str) -> Form:
        """The factor F of the part F letter, the words that end in ``letter``."""
        terms = {(s, w[:-1]): a for (s, w), a in self.terms.items() if w and w[-1] == letter}
        return Form(terms, self.symmetric)

    def after(self, letter: str) -> Form:
        """The factor F of the part letter F, the words that start with ``letter``."""
        terms = {(s, w[1:]): a for (s, w), a in self.terms.items() if w and w[0] == letter}
        return Form(terms, self.symmetric)

    def __str__(self) -> str:
        """Return the form in the checker's language, like ``M + h*C - 1/2*h**2*T(x)*K*x``."""
        text = ""
        for (scalars, word), a in sorted(self.terms.items(), key=_reading_order):
            factors = [name if power == 1 else f"{name}**{power}" for name, power in scalars]
            factors += [f"T({x[:-1]})" if x.endswith("'") else x for x in word]
            size = abs(a)
            head = [] if size == 1 and factors else [str(size)]
            sign = "-" if a < 0 else "+"
            text += f" {sign} " + "*".join(head + factors)
        if not text:
            return "0"
        return text[3:] if text[1] == "+" else "-" + text[3:]


def _merged(
    s: tuple[tuple[str, int], ...], t: tuple[tuple[str, int], ...]
) -> tuple[tuple[str, int], ...]:
    powers = dict(s)
    for name, power in t:
        powers[name] = powers.get(name, 0) + power
    return tuple(sorted((name, power) for name, power in powers.items() if power))


def _reading_order(item: tuple[Key, Fraction]) -> tuple[object, ...]:
    """Few scalars first, then by name, as a person would write it."""
    (scalars, word), _ = item
    return (sum(power for _, power in scalars), word, scalars)


def letters(names: str, symmetric: Iterable[str] = ()) -> tuple[Form, ...]:
    """One form for each letter of the blank-separated ``names``."""
    known = frozenset(symmetric)
    return tuple(Form({((), (name,)): Fraction(1)}, known) for name in names.split())


def scalars(names: str) -> tuple[Form, ...]:
    """One form for each commuting scalar of the blank-separated ``names``."""
    return tuple(Form({(((name, 1),), ()): Fraction(1)}) for name in names.split())


def inverse(scalar: Form) -> Form:
    """1/scalar for a form that is one scalar to some power."""
    ((factors, word), a), *rest = scalar.terms.items()
    if rest or word or len(factors) != 1:
        raise ValueError(f"scalar: {scalar}; one scalar to a power has an inverse here")
    ((name, power),) = factors
    return Form({(((name, -power),), ()): 1 / a}, scalar.symmetric)
