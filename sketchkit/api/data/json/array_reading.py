"""What a JSONArray holds, read value by value, or all values at once."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, TypeVar, cast

from sketchkit.api.data.faults import no_place, whole
from sketchkit.api.data.json.values import (
    JSONValue,
    as_fraction,
    as_text,
    as_truth,
    as_whole,
    not_a,
)
from sketchkit.api.data.lists.float_list import DoubleList, FloatList
from sketchkit.api.data.lists.int_list import IntList, LongList
from sketchkit.api.data.lists.string_list import StringList
from sketchkit.data.json_writing import COMPACT, write_json

if TYPE_CHECKING:
    from sketchkit.api.data.json.json_array import JSONArray
    from sketchkit.api.data.json.json_object import JSONObject

T = TypeVar("T")


class ArrayReading(JSONValue):
    """`getInt()`, `toIntArray()` and the like."""

    _values: list[object]

    def size(self) -> int:
        """Return how many values there are.

        See Also
        --------
        append

        Examples
        --------
        >>> JSONArray([3, "four"]).size()
        2
        """
        return len(self._values)

    def get(self, index: int) -> object:
        """Return the value at a place, whatever it is."""
        return self._values[self._place("get", index)]

    def getString(self, index: int, defaultValue: str | None = None) -> str | None:
        """Return the text at a place.

        Parameters
        ----------
        index : int
            Its place, counted from 0.
        defaultValue : str, optional
            With it anything is returned as text, and this if there is nothing.

        Raises
        ------
        SketchError
            If there is no such place, or no text, and `defaultValue` is left out.

        Examples
        --------
        >>> names = JSONArray(["Ida", 12])
        >>> names.getString(0), names.getString(1, "?"), names.getString(7, "?")
        ('Ida', '12', '?')
        """
        if defaultValue is None:
            value = self.get(index)
            if value is None or isinstance(value, str):
                return value
            raise not_a(f"getString({index})", "text", value)
        value = self._values[index] if 0 <= index < len(self._values) else None
        return defaultValue if value is None else as_text(value)

    def getInt(self, index: int, defaultValue: int | None = None) -> int:
        """Return the whole number at a place; a fraction is cut off.

        Parameters
        ----------
        index : int
            Its place, counted from 0.
        defaultValue : int, optional
            What is returned if there is no number.

        Raises
        ------
        SketchError
            If there is no number, and `defaultValue` is left out.

        Examples
        --------
        >>> values = JSONArray([3, 2.75, "none"])
        >>> values.getInt(0), values.getInt(1), values.getInt(2, -1)
        (3, 2, -1)
        """
        return self._found("getInt", index, "number", as_whole, defaultValue)

    getLong = getInt

    def getFloat(self, index: int, defaultValue: float | None = None) -> float:
        """Return the number at a place.

        Parameters
        ----------
        index : int
            Its place, counted from 0.
        defaultValue : float, optional
            What is returned if there is no number.

        Raises
        ------
        SketchError
            If there is no number, and `defaultValue` is left out.

        Examples
        --------
        >>> values = JSONArray([2.75, "none"])
        >>> values.getFloat(0), values.getFloat(1, 0.5)
        (2.75, 0.5)
        """
        return self._found("getFloat", index, "number", as_fraction, defaultValue)

    getDouble = getFloat

    def getBoolean(self, index: int, defaultValue: bool | None = None) -> bool:
        """Return the truth value at a place: True or False.

        Parameters
        ----------
        index : int
            Its place, counted from 0.
        defaultValue : bool, optional
            What is returned if there is neither of them.

        Raises
        ------
        SketchError
            If there is neither, and `defaultValue` is left out.

        Examples
        --------
        >>> answers = JSONArray([True, "none"])
        >>> answers.getBoolean(0), answers.getBoolean(1, False)
        (True, False)
        """
        return self._found("getBoolean", index, "truth value", as_truth, defaultValue)

    def getJSONArray(self, index: int, defaultValue: JSONArray | None = None) -> JSONArray:
        """Return the array at a place.

        Parameters
        ----------
        index : int
            Its place, counted from 0.
        defaultValue : JSONArray, optional
            What is returned if there is no array.

        Raises
        ------
        SketchError
            If there is no array, and `defaultValue` is left out.

        Examples
        --------
        >>> rows = JSONArray([[1, 2], [3, 4]])
        >>> rows.getJSONArray(1).getInt(0)
        3
        """
        return self._found("getJSONArray", index, "JSONArray", as_array, defaultValue)

    def getJSONObject(self, index: int, defaultValue: JSONObject | None = None) -> JSONObject:
        """Return the object at a place.

        Parameters
        ----------
        index : int
            Its place, counted from 0.
        defaultValue : JSONObject, optional
            What is returned if there is no object.

        Raises
        ------
        SketchError
            If there is no object, and `defaultValue` is left out.

        Examples
        --------
        >>> animals = JSONArray([{"species": "Goat"}, {"species": "Leopard"}])
        >>> for i in range(animals.size()):
        ...     println(animals.getJSONObject(i).getString("species"))
        Goat
        Leopard
        """
        return self._found("getJSONObject", index, "JSONObject", as_object, defaultValue)

    def isNull(self, index: int) -> bool:
        """Return whether there is null at a place, or nothing.

        Parameters
        ----------
        index : int
            Its place, counted from 0.

        Examples
        --------
        >>> values = parseJSONArray("[1, null]")
        >>> values.isNull(0), values.isNull(1), values.isNull(2)
        (False, True, True)
        """
        return not 0 <= index < len(self._values) or self._values[index] is None

    def join(self, separator: str) -> str:
        """Return the values as one text, with a separator between them."""
        return separator.join(write_json(value, COMPACT) for value in self._values)

    def toStringArray(self) -> list[str | None]:
        """Return the values as a list of texts; none of another kind may be among them.

        Raises
        ------
        SketchError
            If one of them is no text.

        Notes
        -----
        `getStringArray()` is the same.

        Examples
        --------
        >>> JSONArray(["Goat", "Zebra"]).toStringArray()
        ['Goat', 'Zebra']
        """
        return [self.getString(place) for place in range(len(self._values))]

    def toIntArray(self) -> list[int]:
        """Return the values as a list of whole numbers; all have to be numbers.

        Raises
        ------
        SketchError
            If one of them is no number.

        Notes
        -----
        `getIntArray()` is the same.

        Examples
        --------
        >>> scores = JSONArray([30, 10, 20])
        >>> scores.toIntArray(), max(scores.toIntArray())
        ([30, 10, 20], 30)
        """
        return [self.getInt(place) for place in range(len(self._values))]

    def toFloatArray(self) -> list[float]:
        """Return the values as a list; all have to be numbers."""
        return [self.getFloat(place) for place in range(len(self._values))]

    def toBooleanArray(self) -> list[bool]:
        """Return the values as a list; all have to be True or False."""
        return [self.getBoolean(place) for place in range(len(self._values))]

    def arrayValues(self) -> list[JSONArray]:
        """Return the values as a list; all have to be arrays."""
        return [self.getJSONArray(place) for place in range(len(self._values))]

    def objectValues(self) -> list[JSONObject]:
        """Return the values as a list; all have to be objects."""
        return [self.getJSONObject(place) for place in range(len(self._values))]

    getStringArray = toStringArray
    getIntArray = getLongArray = toLongArray = intValues = longValues = toIntArray
    getFloatArray = getDoubleArray = toDoubleArray = floatValues = doubleValues = toFloatArray
    getBooleanArray = booleanValues = toBooleanArray

    def toStringList(self) -> StringList:
        """Return the values in a StringList; all have to be text."""
        return StringList(self.toStringArray())

    def toIntList(self) -> IntList:
        """Return the values in an IntList; all have to be numbers."""
        return IntList(self.toIntArray())

    def toLongList(self) -> LongList:
        """Return the values in a LongList; all have to be numbers."""
        return LongList(self.toIntArray())

    def toFloatList(self) -> FloatList:
        """Return the values in a FloatList; all have to be numbers."""
        return FloatList(self.toFloatArray())

    def toDoubleList(self) -> DoubleList:
        """Return the values in a DoubleList; all have to be numbers."""
        return DoubleList(self.toFloatArray())

    def _found(
        self,
        name: str,
        index: int,
        wanted: str,
        read: Callable[[object], T | None],
        other: T | None,
    ) -> T:
        if other is not None and not 0 <= index < len(self._values):
            return other
        value = self._values[self._place(name, index)]
        found = read(value)
        if found is None and other is None:
            raise not_a(f"{name}({index})", wanted, value)
        return cast("T", other if found is None else found)

    def _place(self, name: str, index: object) -> int:
        place = whole(name, index)
        if not 0 <= place < len(self._values):
            raise no_place(name, index, self._values)
        return place


def as_array(value: object) -> JSONArray | None:
    """Return a value if it is an array, or None."""
    return cast("JSONArray", value) if isinstance(value, JSONValue.kinds[list]) else None


def as_object(value: object) -> JSONObject | None:
    """Return a value if it is an object, or None."""
    return cast("JSONObject", value) if isinstance(value, JSONValue.kinds[dict]) else None
