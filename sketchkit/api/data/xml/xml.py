"""XML: an element of a document, with all that stands in it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from os import PathLike
from typing import overload

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
    `for child in xml` goes through the children, `xml[0]` is the first. A path of names,
    "group/item", leads further down. Entities that a document defines are put in if they are
    short; nothing is fetched.

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
        """Return the root element of a document that a text holds.

        Parameters
        ----------
        data : str
            The text.
        options : str, optional
            None has a meaning.

        Raises
        ------
        SketchError
            If it is not well-formed; it tells the line.

        See Also
        --------
        parseXML, loadXML

        Examples
        --------
        >>> XML.parse("<zoo><animal/></zoo>").listChildren()
        ['animal']
        """
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
        """Return the tag of an element; "#text" for a text, "#comment" for a comment.

        Examples
        --------
        >>> zoo = loadXML("zoo.xml")
        >>> zoo.getName(), zoo.getChild(0).getName()
        ('zoo', 'animal')
        """
        return self.name

    def setName(self, newName: str) -> None:
        """Give an element another tag.

        Parameters
        ----------
        newName : str
            The tag: letters and digits, without spaces.

        Examples
        --------
        >>> animal = XML("animal")
        >>> animal.setName("plant")
        >>> println(animal)
        <plant/>
        """
        self.name = _tag("setName", newName)

    def getLocalName(self) -> str:
        """Return the tag of an element without its namespace."""
        return self.name.rpartition(":")[2]

    def getParent(self) -> XML | None:
        """Return the element that this one stands in; None for the first of all.

        Examples
        --------
        >>> zoo = loadXML("zoo.xml")
        >>> animal = zoo.getChild("animal")
        >>> animal.getParent().getName(), zoo.getParent()
        ('zoo', None)
        """
        return self.parent

    def getChildCount(self) -> int:
        """Return how many children there are, texts and line ends among them.

        See Also
        --------
        getChildren

        Examples
        --------
        >>> parseXML("<zoo><animal/><animal/></zoo>").getChildCount()
        2
        >>> parseXML("<zoo> <animal/> </zoo>").listChildren()
        ['#text', 'animal', '#text']
        """
        return len(self.children)

    def hasChildren(self) -> bool:
        """Return whether anything stands in an element, be it text or other elements.

        Examples
        --------
        >>> parseXML("<zoo><animal/></zoo>").hasChildren(), XML("zoo").hasChildren()
        (True, False)
        """
        return bool(self.children)

    def listChildren(self) -> list[str]:
        """Return the names of the children.

        Examples
        --------
        >>> parseXML("<zoo><animal/><plant/></zoo>").listChildren()
        ['animal', 'plant']
        """
        return [child.name for child in self.children]

    def getChildren(self, name: str | None = None) -> list[XML]:
        """Return a list of all children, or of those of a name.

        Parameters
        ----------
        name : str, optional
            The name, or a path of names: "cage/animal".

        Examples
        --------
        >>> zoo = parseXML("<zoo><animal>Goat</animal><cage><animal>Lion</animal></cage></zoo>")
        >>> for animal in zoo.getChildren("animal") + zoo.getChildren("cage/animal"):
        ...     println(animal.getContent())
        Goat
        Lion
        """
        return list(self.children) if name is None else self.descendants_at(_path(name))

    def getChild(self, name: int | str) -> XML | None:
        """Return the child at a place, or the first one of a name; None if no child has it.

        Parameters
        ----------
        name : int or str
            The place, counted from 0; the name; or a path of names: "cage/animal".

        Raises
        ------
        SketchError
            If there is no such place.

        Examples
        --------
        >>> zoo = parseXML("<zoo><animal>Goat</animal><cage><animal>Lion</animal></cage></zoo>")
        >>> zoo.getChild("animal").getContent(), zoo.getChild("cage/animal").getContent()
        ('Goat', 'Lion')
        >>> zoo.getChild(1).getName(), zoo.getChild("plant")
        ('cage', None)
        """
        if isinstance(name, str):
            return self.first_at(_path(name))
        place = whole("getChild", name)
        if not 0 <= place < len(self.children):
            raise no_place("getChild", name, self.children)
        return self.children[place]

    def addChild(self, tag: str | XML) -> XML:
        """Add an element at the end: a new one, or a copy of another. Return it.

        Parameters
        ----------
        tag : str or XML
            The name of the new element, or the element to copy.

        Examples
        --------
        >>> zoo = XML("zoo")
        >>> animal = zoo.addChild("animal")
        >>> animal.setContent("Goat")
        >>> println(zoo)
        <zoo><animal>Goat</animal></zoo>
        """
        if self.kind is not Kind.ELEMENT:
            raise SketchError(f"Only elements have children; this is {self.name}.")
        if isinstance(tag, XML):
            return self.place_last(tag.duplicate())
        return self.place_last(XML(_tag("addChild", tag)))

    def removeChild(self, kid: XML) -> None:
        """Remove a child.

        Parameters
        ----------
        kid : XML
            The child; `getChild()` finds one.

        Raises
        ------
        SketchError
            If it is no child of this element.

        Examples
        --------
        >>> zoo = parseXML("<zoo><animal/><plant/></zoo>")
        >>> zoo.removeChild(zoo.getChild("plant"))
        >>> println(zoo)
        <zoo><animal/></zoo>
        """
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
        """Return it as text, with each element on a line of its own.

        Parameters
        ----------
        indent : int
            How many spaces each level is moved to the right; -1 puts all on one line.

        Examples
        --------
        >>> println(parseXML("<zoo><animal/></zoo>").format(4))
        <?xml version="1.0" encoding="UTF-8"?>
        <zoo>
            <animal/>
        </zoo>
        <BLANKLINE>
        """
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
        """Return it as text in a single line.

        Examples
        --------
        >>> parseXML("<zoo> <animal/> </zoo>").toString()
        '<zoo><animal/></zoo>'
        """
        return self.format(COMPACT)

    def __iter__(self) -> Iterator[XML]:
        return iter(list(self.children))

    @overload
    def __getitem__(self, place: int) -> XML: ...
    @overload
    def __getitem__(self, place: slice) -> list[XML]: ...
    def __getitem__(self, place: int | slice) -> XML | list[XML]:
        if isinstance(place, str):
            hint = f"getChild({place!r}) gives a child, getString({place!r}) an attribute."
            raise wrong_kind("getChild", "a number in square brackets", place, hint)
        children: list[XML] = list(self.children)
        try:
            return children[place]
        except IndexError:
            raise no_place("getChild", place, children) from None

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
