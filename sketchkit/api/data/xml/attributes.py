"""The attributes of an element of XML, and its content, read and changed."""

from __future__ import annotations

from typing import TypeVar

from sketchkit.api.data.faults import fraction, whole, wrong_kind
from sketchkit.core.errors import SketchError, shown
from sketchkit.data.java_numbers import double_text, float_text, read_float, read_int, read_whole
from sketchkit.data.xml_tree import Kind, Node

T = TypeVar("T")


class Attributes(Node):
    """`getInt()`, `setContent()` and the like."""

    def getAttributeCount(self) -> int:
        """Return how many attributes there are.

        Examples
        --------
        >>> parseXML('<animal id="1" weight="4.5"/>').getAttributeCount()
        2
        """
        return len(self.attributes)

    def listAttributes(self) -> list[str]:
        """Return the names of the attributes, in the order of the alphabet.

        Examples
        --------
        >>> parseXML('<animal weight="4.5" id="1"/>').listAttributes()
        ['id', 'weight']
        """
        return sorted(self.attributes)

    def hasAttribute(self, name: str) -> bool:
        """Return whether there is an attribute of a name.

        Parameters
        ----------
        name : str
            The attribute's name.

        Examples
        --------
        >>> animal = parseXML('<animal id="1"/>')
        >>> animal.hasAttribute("id"), animal.hasAttribute("weight")
        (True, False)
        """
        return name in self.attributes

    def getString(self, name: str, defaultValue: str | None = None) -> str | None:
        """Return an attribute as text.

        Parameters
        ----------
        name : str
            The attribute's name.
        defaultValue : str, optional
            What is returned if there is no such attribute; None if left out.

        Examples
        --------
        >>> animal = parseXML('<animal species="Capra hircus"/>')
        >>> animal.getString("species"), animal.getString("name", "nameless")
        ('Capra hircus', 'nameless')
        """
        return self.attributes.get(name, defaultValue)

    def getInt(self, name: str, defaultValue: int = 0) -> int:
        """Return an attribute as a whole number.

        Parameters
        ----------
        name : str
            The attribute's name.
        defaultValue : int, optional
            What is returned if there is no such attribute; 0 if left out.

        Raises
        ------
        SketchError
            If the attribute is there and is no whole number.

        Examples
        --------
        >>> animal = parseXML('<animal id="7"/>')
        >>> animal.getInt("id"), animal.getInt("legs"), animal.getInt("legs", 4)
        (7, 0, 4)
        """
        if (text := self.attributes.get(name)) is None:
            return defaultValue
        return self._checked(name, text, read_whole(text), "whole number")

    def getLong(self, name: str, defaultValue: int = 0) -> int:
        """Return an attribute as a whole number; a second value, or 0, if there is none."""
        return self.getInt(name, defaultValue)

    def getFloat(self, name: str, defaultValue: float = 0.0) -> float:
        """Return an attribute as a number.

        Parameters
        ----------
        name : str
            The attribute's name.
        defaultValue : float, optional
            What is returned if there is no such attribute; 0 if left out.

        Raises
        ------
        SketchError
            If the attribute is there and is no number.

        Examples
        --------
        >>> animal = parseXML('<animal weight="4.5"/>')
        >>> animal.getFloat("weight"), animal.getFloat("height", 0.5)
        (4.5, 0.5)
        """
        if (text := self.attributes.get(name)) is None:
            return defaultValue
        return self._checked(name, text, read_float(text), "number")

    def getDouble(self, name: str, defaultValue: float = 0.0) -> float:
        """Return an attribute as a number; a second value, or 0, if there is none."""
        return self.getFloat(name, defaultValue)

    def setString(self, name: str, value: str) -> None:
        """Set an attribute to a text.

        Parameters
        ----------
        name : str
            The attribute's name; one that is missing is added.
        value : str
            The text.

        Examples
        --------
        >>> animal = XML("animal")
        >>> animal.setString("species", "Capra hircus")
        >>> println(animal)
        <animal species="Capra hircus"/>
        """
        if not isinstance(value, str):
            hint = f"str({value!r}) makes text of it."
            raise wrong_kind("setString", "text", value, hint, place=name)
        self._set(name, value)

    def setInt(self, name: str, value: int) -> None:
        """Set an attribute to a whole number.

        Parameters
        ----------
        name : str
            The attribute's name; one that is missing is added.
        value : int
            The number; a fraction is cut off.

        Examples
        --------
        >>> animal = XML("animal")
        >>> animal.setInt("legs", 4)
        >>> println(animal)
        <animal legs="4"/>
        """
        self._set(name, str(whole("setInt", value, place=name)))

    def setLong(self, name: str, value: int) -> None:
        """Set an attribute to a whole number, as `setInt()` does: no number is too large.

        Parameters
        ----------
        name : str
            The attribute's name; one that is missing is added.
        value : int
            The number.

        Examples
        --------
        >>> star = XML("star")
        >>> star.setLong("age", 4600000000)
        >>> println(star)
        <star age="4600000000"/>
        """
        self._set(name, str(whole("setLong", value, place=name)))

    def setFloat(self, name: str, value: float) -> None:
        """Set an attribute to a number.

        Parameters
        ----------
        name : str
            The attribute's name; one that is missing is added.
        value : float
            The number; seven digits of it are kept. `setDouble()` keeps all.

        Examples
        --------
        >>> animal = XML("animal")
        >>> animal.setFloat("weight", 4.5)
        >>> println(animal)
        <animal weight="4.5"/>
        """
        self._set(name, float_text(fraction("setFloat", value, place=name)))

    def setDouble(self, name: str, value: float) -> None:
        """Set an attribute to a number, with all of its digits."""
        self._set(name, double_text(fraction("setDouble", value, place=name)))

    def getContent(self, defaultValue: str | None = None) -> str:
        """Return the text in an element, and in all elements in it.

        Parameters
        ----------
        defaultValue : str, optional
            As in Processing, it has no effect: without text there is "".

        Examples
        --------
        >>> parseXML("<zoo>A <b>small</b> goat</zoo>").getContent()
        'A small goat'
        """
        return self.content()

    def getIntContent(self, defaultValue: int = 0) -> int:
        """Return the text in an element as a whole number.

        Parameters
        ----------
        defaultValue : int, optional
            What is returned if the text is no number; 0 if left out.

        Examples
        --------
        >>> zoo = parseXML("<zoo><legs>4</legs><name>Ida</name></zoo>")
        >>> zoo.getChild("legs").getIntContent(), zoo.getChild("name").getIntContent(-1)
        (4, -1)
        """
        number = read_int(self.content())
        return defaultValue if number is None else number

    def getLongContent(self, defaultValue: int = 0) -> int:
        """Return the text in an element as a whole number; a second value, or 0, if it is none."""
        number = read_whole(self.content())
        return defaultValue if number is None else number

    def getFloatContent(self, defaultValue: float = 0.0) -> float:
        """Return the text in an element as a number.

        Parameters
        ----------
        defaultValue : float, optional
            What is returned if the text is no number; 0 if left out.

        Examples
        --------
        >>> zoo = parseXML("<zoo><weight>4.5</weight><name>Ida</name></zoo>")
        >>> zoo.getChild("weight").getFloatContent(), zoo.getChild("name").getFloatContent(-1)
        (4.5, -1)
        """
        number = read_float(self.content())
        return defaultValue if number is None else number

    def getDoubleContent(self, defaultValue: float = 0.0) -> float:
        """Return the text in an element as a number; a second value, or 0, if it is none."""
        return self.getFloatContent(defaultValue)

    def setContent(self, text: str) -> None:
        """Have a text stand in an element, in place of all that stands there.

        Parameters
        ----------
        text : str
            The text; `<` and `&` in it are written as XML wants them.

        Examples
        --------
        >>> animal = XML("animal")
        >>> animal.setContent("Goat & kid")
        >>> println(animal)
        <animal>Goat &amp; kid</animal>
        """
        if not isinstance(text, str):
            raise wrong_kind("setContent", "text", text, f"str({text!r}) makes text of it.")
        self._fill(text)

    def setIntContent(self, value: int) -> None:
        """Have a whole number stand in an element."""
        self._fill(str(whole("setIntContent", value)))

    def setLongContent(self, value: int) -> None:
        """Have a whole number stand in an element."""
        self._fill(str(whole("setLongContent", value)))

    def setFloatContent(self, value: float) -> None:
        """Have a number stand in an element."""
        self._fill(float_text(fraction("setFloatContent", value)))

    def setDoubleContent(self, value: float) -> None:
        """Have a number stand in an element, with all of its digits."""
        self._fill(double_text(fraction("setDoubleContent", value)))

    def _set(self, name: str, text: str) -> None:
        if self.kind is not Kind.ELEMENT:
            raise SketchError(f"Only elements have attributes; this is {self.name}.")
        self.attributes[name] = text

    def _fill(self, text: str) -> None:
        if self.kind is not Kind.ELEMENT:
            self.text = text
            return
        self.children = []
        if text:
            node = type(self).__new__(type(self))
            Node.__init__(node, "", Kind.TEXT, text)
            self.place_last(node)

    def _checked(self, name: str, text: str, number: T | None, what: str) -> T:
        if number is None:
            raise SketchError(
                f"The attribute {name} of <{self.name}> is no {what}.",
                got=shown(text),
                hint=f'getString("{name}") gives it as text.',
            )
        return number
