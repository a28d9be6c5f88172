"""Formulas as MathML, rebuilt node by node from a closed list of elements."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .dom import Element, el

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element as Xml

ALLOWED = {
    "math", "mrow", "mi", "mn", "mo", "mtext", "mspace", "mfrac", "msqrt", "mroot", "msub", "msup",
    "msubsup", "munder", "mover", "munderover", "mtable", "mtr", "mtd", "mstyle", "mpadded",
    "mfenced", "menclose",
}  # fmt: skip
ATTRIBUTES = {"display", "stretchy", "fence", "form", "mathvariant", "width", "displaystyle"}


def formula(latex: str, display: bool = True) -> Element | None:
    """MathML of a LaTeX formula, or its text if it cannot be converted.

    Parameters
    ----------
    latex : str
        Without dollar signs.
    display : bool, optional
        A block of its own.

    Returns
    -------
    Element or None
        None for an empty formula.
    """
    if not latex:
        return None
    from xml.etree import ElementTree

    from latex2mathml.converter import convert

    try:
        tree = ElementTree.fromstring(convert(latex, display="block" if display else "inline"))
    except Exception:  # whatever the converter cannot read is shown as it was typed
        return el("code", latex, class_="formula")
    return _rebuilt(tree)


def _rebuilt(node: Xml) -> Element:
    name = node.tag.split("}")[-1]
    text = node.text or ""
    if name == "mtext":  # spaces at the ends of words would be dropped
        text = text.replace(" ", "\u00a0")
    children: list[Element | str] = [text] if text.strip(" \n") else []
    children.extend(_rebuilt(child) for child in node)
    attributes = tuple((k, v) for k, v in node.attrib.items() if k in ATTRIBUTES)
    return Element(name if name in ALLOWED else "mrow", attributes, tuple(children))
