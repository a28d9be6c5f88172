"""Elements of a page as values: text is escaped in one place, attributes in the same."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import TypeAlias

VOID = {"br", "hr", "img", "input", "link", "meta", "path", "line", "circle", "rect", "use"}
INLINE_FREE = str.maketrans({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;"})


@dataclass(frozen=True)
class Raw:
    """Text that is markup already: only our own style, script, and `Element` may become one."""

    text: str


@dataclass(frozen=True)
class Element:
    """One element with its attributes and children.

    Parameters
    ----------
    name : str
        Tag name.
    attributes : tuple of (str, str)
        In order; values are escaped when written.
    children : tuple of nodes
        Elements and texts; texts are escaped when written.
    """

    name: str
    attributes: tuple[tuple[str, str], ...]
    children: tuple[Element | Raw | str, ...]

    def __str__(self) -> str:
        attributes = "".join(f' {key}="{escape(value)}"' for key, value in self.attributes)
        if self.name in VOID and not self.children:
            return f"<{self.name}{attributes}/>"
        inner = "".join(_written(child) for child in self.children)
        return f"<{self.name}{attributes}>{inner}</{self.name}>"


def escape(text: str) -> str:
    """Make any text safe between tags and inside quoted attributes."""
    clean = "".join(c if c in "\n\t" or ord(c) >= 32 else "\ufffd" for c in text)
    return clean.translate(INLINE_FREE)


def _written(child: Element | Raw | str) -> str:
    if isinstance(child, Raw):
        return child.text
    return str(child) if isinstance(child, Element) else escape(child)


Child: TypeAlias = "Element | Raw | str | Iterable[Child] | None"


def el(tag: str, /, *children: Child, **attributes: str | int | float | None) -> Element:
    """Build an element: ``el("a", "text", href="#x", class_="link")``.

    Children may be elements, texts, None (left out) or lists of these; a trailing underscore of an
    attribute's name is dropped and other underscores become hyphens.
    """
    flat = tuple(_flat(children))
    pairs = tuple(
        (key.rstrip("_").replace("_", "-"), str(value))
        for key, value in attributes.items()
        if value is not None
    )
    return Element(tag, pairs, flat)


def _flat(children: Iterable[Child]) -> Iterator[Element | Raw | str]:
    for child in children:
        if isinstance(child, (Element, Raw, str)):
            yield child
        elif child is not None:
            yield from _flat(child)
