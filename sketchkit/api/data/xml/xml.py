"""XML: an element of a document, with all that stands in it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from os import PathLike

from sketchkit.api.data.faults import no_place, unreadable, whole, wrong_kind
from sketchkit.api.data.lists.value_list import Writes
from sketchkit.api.data.saving import save_text
from sketchkit.api.data.xml.attributes import Attributes
from sketchkit.core.errors import SketchError, shown
from sketchkit.data.malformed import MalformedError
from sketchkit.data.xml_reading import read_xml
from sketchkit.data.xml_tree import Kind, Node
from sketchkit.data.xml_writing import COMPACT, write_xml

_NAME = re.compile(r"[^\W\d][\w.:-]*")


class XML(Attributes):
    """An element of a document in XML, with all that stands in it.

    Parameters
    ----------
    name : str
        The tag of a new element.

    Notes
    -----
    Texts between elements are children, too, and so are line ends: their name is "#text".
    `for child in xml` goes through the children. A path of names, "group/item", leads further
    down. Entities that a document defines are put in if they are short; nothing is fetched.

    Examples
    --------
    >>> zoo = XML("zoo")
    >>> animal = zoo.addChild("animal")
    >>> animal.setString("species", "Panthera leo")
    >>> animal.setInt("id", 1)
    >>> animal.setContent("Lion")
    >>> println(zoo)
    <zoo><animal id="1" species="Panthera leo">Lion</animal></zoo>
    >>> for child in zoo.getChildren("animal"):
    ...     println(child.getInt("id"), child.getContent())
    1 Lion
    """

    def __init__(self, name: str) -> None:
        super().__init__(_tag("XML", name))

    @staticmethod
    def parse(data: str, options: str | None = None) -> XML:
        """Return the root element of a document that a text holds."""
        return XML.read("The text", data)

    @staticmethod
    def read(source: str, data: str | bytes) -> XML:
        """Return the root element of a document; `source` names it in messages."""
        if not isinstance(data, str | bytes):
            raise wrong_kind("parseXML", "text", data, "A file is read by loadXML().")
        try:
            return read_xml(data, XML)
        except MalformedError as error:
            raise unreadable(source, error) from None

    def getName(self) -> str:
        """Return the tag of an element; "#text" for a text, "#comment" for a comment."""
        return self.name

    def setName(self, newName: str) -> None:
        """Give an element another tag."""
        self.name = _tag("setName", newName)

    def getLocalName(self) -> str:
        """Return the tag of an element without its namespace."""
        return self.name.rpartition(":")[2]

    def getParent(self) -> XML | None:
        """Return the element that this one stands in; None for the first of all."""
        return self.parent

    def getChildCount(self) -> int:
        """Return how many children there are, texts among them."""
        return len(self.children)

    def hasChildren(self) -> bool:
        """Return whether anything stands in it."""
        return bool(self.children)

    def listChildren(self) -> list[str]:
        """Return the names of the children."""
        return [child.name for child in self.children]

    def getChildren(self, name: str | None = None) -> list[XML]:
        """Return all children, or those of a name, or at a path of names: "group/item"."""
        return list(self.children) if name is None else self.descendants_at(_path(name))

    def getChild(self, name: int | str) -> XML | None:
        """Return the child at a place, or the first one of a name or at a path, or None."""
        if isinstance(name, str):
            return self.first_at(_path(name))
        place = whole("getChild", name)
        if not 0 <= place < len(self.children):
            raise no_place("getChild", name, self.children)
        return self.children[place]

    def addChild(self, tag: str | XML) -> XML:
        """Add an element at the end: a new one, or a copy of another. Return it."""
        if self.kind is not Kind.ELEMENT:
            raise SketchError(f"Only elements have children; this is {self.name}.")
        if isinstance(tag, XML):
            return self.place_last(tag.duplicate())
        return self.place_last(XML(_tag("addChild", tag)))

    def removeChild(self, kid: XML) -> None:
        """Remove a child."""
        place = next((p for p, child in enumerate(self.children) if child is kid), None)
        if place is None:
            raise SketchError(
                f"removeChild() takes a child of <{self.name}>.",
                got=f"<{kid.name}>" if isinstance(kid, Node) else shown(kid),
                hint="getChild() finds one.",
            )
        self.children.pop(place).parent = None

    def trim(self) -> None:
        """Remove the texts that are spaces and line ends alone, at every depth."""
        self.remove_blank_texts()

    def format(self, indent: int = 2) -> str:
        """Return it as text, with each level moved that far to the right; -1 for a single line."""
        return write_xml(self, indent)

    def print(self) -> None:
        """Print it, one element in each line."""
        print(self.format(2))

    def save(self, file: str | PathLike[str], options: str | None = None) -> bool:
        """Write it into a file."""
        save_text("save", file, self.format(2))
        return True

    def write(self, output: Writes) -> bool:
        """Write it to what `createWriter()` has made."""
        output.write(self.format(2))
        return True

    def toString(self) -> str:
        """Return it as text in a single line."""
        return self.format(COMPACT)

    def __iter__(self) -> Iterator[XML]:
        return iter(list(self.children))

    def __len__(self) -> int:
        return len(self.children)

    def __bool__(self) -> bool:
        return True  # there is an element, even if nothing stands in it

    def __str__(self) -> str:
        return self.format(COMPACT)

    def __repr__(self) -> str:
        return self.format(COMPACT)


def _tag(name: str, tag: object) -> str:
    """Return a name that an element can have, or raise that it is none."""
    if isinstance(tag, str) and _NAME.fullmatch(tag):
        return tag
    hint = None
    if isinstance(tag, str) and "<" in tag:
        hint = "parseXML() reads text with tags in it."
    raise SketchError(
        f"{name}() takes the name of an element: letters and digits, without spaces.",
        got=shown(tag),
        hint=hint,
    )


def _path(name: object) -> str:
    if not isinstance(name, str) or not name or name.startswith("/"):
        raise SketchError(
            'A child is found by its name, or by a path of names: "group/item".', got=shown(name)
        )
    return name
