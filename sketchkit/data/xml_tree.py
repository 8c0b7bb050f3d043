"""A document in XML as a tree: its elements, and what stands in and between them."""

from __future__ import annotations

from collections.abc import Iterator
from enum import StrEnum
from typing import Self


class Kind(StrEnum):
    """What a node is; the value is the name of nodes that have none of their own."""

    ELEMENT = "#element"
    TEXT = "#text"
    RAW = "#cdata-section"  # text in which < and & mean nothing
    COMMENT = "#comment"
    INSTRUCTION = "#instruction"  # <?name text?>


class Node:
    """An element, a text, a comment or an instruction.

    Parameters
    ----------
    name : str
        The tag of an element, or the name of an instruction.
    kind : Kind
        Which of these it is.
    text : str
        What stands in it, if it is no element.

    Attributes
    ----------
    attributes : dict
        Those of an element.
    children : list of nodes
        What stands in an element.
    parent : node or None
        The element that it stands in.
    """

    def __init__(self, name: str = "", kind: Kind = Kind.ELEMENT, text: str = "") -> None:
        self.kind = kind
        self.name = name or kind.value
        self.text = text
        self.attributes: dict[str, str] = {}
        self.children: list[Self] = []
        self.parent: Self | None = None

    def place_last(self, child: Self) -> Self:
        """Make a node the last child of this one, and return it."""
        child.parent = self
        self.children.append(child)
        return child

    def duplicate(self) -> Self:
        """Return a node like this one, and all that stands in it, without a parent."""
        twin = type(self).__new__(type(self))
        Node.__init__(twin, self.name, self.kind, self.text)
        twin.attributes = dict(self.attributes)
        for child in self.children:
            twin.place_last(child.duplicate())
        return twin

    def content(self) -> str:
        """Return the text of an element, and of all elements in it; of others, their own."""
        if self.kind is not Kind.ELEMENT:
            return self.text
        return "".join(
            child.content()
            for child in self.children
            if child.kind in (Kind.ELEMENT, Kind.TEXT, Kind.RAW)
        )

    def children_named(self, name: str) -> Iterator[Self]:
        """Yield the children of a name; a number names the child at that place."""
        if name[:1].isdigit():
            place = int(name)
            yield from self.children[place : place + 1]
        else:
            yield from (child for child in self.children if child.name == name)

    def descendants_at(self, path: str) -> list[Self]:
        """Return the nodes at a path of names, `"group/item"`."""
        first, _, rest = path.partition("/")
        found = list(self.children_named(first))
        return [node for child in found for node in child.descendants_at(rest)] if rest else found

    def first_at(self, path: str) -> Self | None:
        """Return the node at a path, in which each name means the first node of that name."""
        first, _, rest = path.partition("/")
        child = next(self.children_named(first), None)
        return child.first_at(rest) if child is not None and rest else child

    def remove_blank_texts(self) -> None:
        """Remove the texts of spaces and line ends alone, at every depth."""
        self.children = [child for child in self.children if not child.is_blank_text()]
        for child in self.children:
            child.remove_blank_texts()

    def is_blank_text(self) -> bool:
        """Return whether it is a text of spaces and line ends alone."""
        return self.kind is Kind.TEXT and not self.text.strip(" \t\n\r")
