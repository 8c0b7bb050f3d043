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
        """Return how many attributes there are."""
        return len(self.attributes)

    def listAttributes(self) -> list[str]:
        """Return the names of the attributes, in the order of the alphabet."""
        return sorted(self.attributes)

    def hasAttribute(self, name: str) -> bool:
        """Return whether there is an attribute."""
        return name in self.attributes

    def getString(self, name: str, defaultValue: str | None = None) -> str | None:
        """Return an attribute; a second value, or None, if there is no such attribute."""
        return self.attributes.get(name, defaultValue)

    def getInt(self, name: str, defaultValue: int = 0) -> int:
        """Return an attribute as a whole number; a second value, or 0, if there is none."""
        if (text := self.attributes.get(name)) is None:
            return defaultValue
        return self._checked(name, text, read_whole(text), "whole number")

    def getLong(self, name: str, defaultValue: int = 0) -> int:
        """Return an attribute as a whole number; a second value, or 0, if there is none."""
        return self.getInt(name, defaultValue)

    def getFloat(self, name: str, defaultValue: float = 0.0) -> float:
        """Return an attribute as a number; a second value, or 0, if there is none."""
        if (text := self.attributes.get(name)) is None:
            return defaultValue
        return self._checked(name, text, read_float(text), "number")

    def getDouble(self, name: str, defaultValue: float = 0.0) -> float:
        """Return an attribute as a number; a second value, or 0, if there is none."""
        return self.getFloat(name, defaultValue)

    def setString(self, name: str, value: str) -> None:
        """Set an attribute to a text."""
        if not isinstance(value, str):
            hint = f"str({value!r}) makes text of it."
            raise wrong_kind("setString", "text", value, hint, place=name)
        self._set(name, value)

    def setInt(self, name: str, value: int) -> None:
        """Set an attribute to a whole number."""
        self._set(name, str(whole("setInt", value, place=name)))

    def setLong(self, name: str, value: int) -> None:
        """Set an attribute to a whole number."""
        self._set(name, str(whole("setLong", value, place=name)))

    def setFloat(self, name: str, value: float) -> None:
        """Set an attribute to a number."""
        self._set(name, float_text(fraction("setFloat", value, place=name)))

    def setDouble(self, name: str, value: float) -> None:
        """Set an attribute to a number, with all of its digits."""
        self._set(name, double_text(fraction("setDouble", value, place=name)))

    def getContent(self, defaultValue: str | None = None) -> str:
        """Return the text in an element, and in all elements in it."""
        return self.content()

    def getIntContent(self, defaultValue: int = 0) -> int:
        """Return the text in an element as a whole number; a second value, or 0, if it is none."""
        number = read_int(self.content())
        return defaultValue if number is None else number

    def getLongContent(self, defaultValue: int = 0) -> int:
        """Return the text in an element as a whole number; a second value, or 0, if it is none."""
        number = read_whole(self.content())
        return defaultValue if number is None else number

    def getFloatContent(self, defaultValue: float = 0.0) -> float:
        """Return the text in an element as a number; a second value, or 0, if it is none."""
        number = read_float(self.content())
        return defaultValue if number is None else number

    def getDoubleContent(self, defaultValue: float = 0.0) -> float:
        """Return the text in an element as a number; a second value, or 0, if it is none."""
        return self.getFloatContent(defaultValue)

    def setContent(self, text: str) -> None:
        """Have a text stand in an element, in place of all that stands there."""
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
