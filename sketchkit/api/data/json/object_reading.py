"""What a JSONObject holds, read by its keys."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, TypeVar, cast

from sketchkit.api.data.faults import no_name
from sketchkit.api.data.json.json_array import JSONArray
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
from sketchkit.core.errors import SketchError, nearest
from sketchkit.core.notices import warn_once

if TYPE_CHECKING:
    from sketchkit.api.data.json.json_object import JSONObject

T = TypeVar("T")


class ObjectReading(JSONValue):
    """`getInt()`, `hasKey()` and the like."""

    _values: dict[str, object]

    def size(self) -> int:
        """Return how many keys there are."""
        return len(self._values)

    def hasKey(self, key: str) -> bool:
        """Return whether there is a key.

        Parameters
        ----------
        key : str
            The key; Python writes `key in json`.

        Examples
        --------
        >>> json = JSONObject({"id": 1})
        >>> json.hasKey("id"), json.hasKey("name")
        (True, False)
        """
        return key in self._values

    def isNull(self, key: str) -> bool:
        """Return whether the value of a key is null, or there is no such key.

        Parameters
        ----------
        key : str
            The key.

        Examples
        --------
        >>> json = parseJSONObject('{"id": 1, "name": null}')
        >>> json.isNull("id"), json.isNull("name"), json.isNull("age")
        (False, True, True)
        """
        return self._values.get(key) is None

    def getString(self, key: str, defaultValue: str | None = None) -> str | None:
        """Return the text of a key; None if there is no such key.

        Parameters
        ----------
        key : str
            The key.
        defaultValue : str, optional
            With it anything is returned as text, and this if there is nothing.

        Raises
        ------
        SketchError
            If there is something else than text, and `defaultValue` is left out.

        Examples
        --------
        >>> json = loadJSONObject("lion.json")
        >>> json.getString("species"), json.getString("id", "?"), json.getString("name", "?")
        ('Panthera leo', '1', '?')
        """
        value = self._values.get(key)
        if value is None:
            if defaultValue is None:
                self._remark("getString", key)
            return defaultValue
        if defaultValue is None and not isinstance(value, str):
            raise not_a(f'getString("{key}")', "text", value)
        return as_text(value)

    def getInt(self, key: str, defaultValue: int | None = None) -> int:
        """Return the whole number of a key; a fraction is cut off.

        Parameters
        ----------
        key : str
            The key.
        defaultValue : int, optional
            What is returned if there is no number.

        Raises
        ------
        SketchError
            If there is no number, and `defaultValue` is left out.

        Examples
        --------
        >>> json = loadJSONObject("lion.json")
        >>> json.getInt("id"), json.getInt("age", 0)
        (1, 0)
        """
        return self._found("getInt", key, "number", as_whole, defaultValue)

    getLong = getInt

    def getFloat(self, key: str, defaultValue: float | None = None) -> float:
        """Return the number of a key.

        Parameters
        ----------
        key : str
            The key.
        defaultValue : float, optional
            What is returned if there is no number.

        Raises
        ------
        SketchError
            If there is no number, and `defaultValue` is left out.

        Examples
        --------
        >>> json = JSONObject({"weight": 4.5})
        >>> json.getFloat("weight"), json.getFloat("height", 1.0)
        (4.5, 1.0)
        """
        return self._found("getFloat", key, "number", as_fraction, defaultValue)

    getDouble = getFloat

    def getBoolean(self, key: str, defaultValue: bool | None = None) -> bool:
        """Return the truth value of a key: True or False.

        Parameters
        ----------
        key : str
            The key.
        defaultValue : bool, optional
            What is returned if there is neither of them.

        Raises
        ------
        SketchError
            If there is neither, and `defaultValue` is left out.

        Examples
        --------
        >>> json = JSONObject({"tame": True})
        >>> json.getBoolean("tame"), json.getBoolean("striped", False)
        (True, False)
        """
        return self._found("getBoolean", key, "truth value", as_truth, defaultValue)

    def getJSONArray(self, key: str) -> JSONArray | None:
        """Return the array of a key; None if there is no such key.

        Parameters
        ----------
        key : str
            The key.

        Raises
        ------
        SketchError
            If there is something else than an array.

        Examples
        --------
        >>> json = parseJSONObject('{"scores": [30, 10]}')
        >>> json.getJSONArray("scores").getInt(1)
        10
        """
        return self._part("getJSONArray", key, JSONArray)

    def getJSONObject(self, key: str) -> JSONObject | None:
        """Return the object of a key; None if there is no such key.

        Parameters
        ----------
        key : str
            The key.

        Raises
        ------
        SketchError
            If there is something else than an object.

        Examples
        --------
        >>> json = parseJSONObject('{"place": {"x": 10, "y": 20}}')
        >>> place = json.getJSONObject("place")
        >>> circle(place.getInt("x"), place.getInt("y"), 30)
        """
        return cast("JSONObject | None", self._part("getJSONObject", key, JSONValue.kinds[dict]))

    def getStringList(self, key: str) -> StringList:
        """Return an array of texts in a StringList."""
        return self._array("getStringList", key).toStringList()

    def getIntList(self, key: str) -> IntList:
        """Return an array of numbers in an IntList."""
        return self._array("getIntList", key).toIntList()

    def getLongList(self, key: str) -> LongList:
        """Return an array of numbers in a LongList."""
        return self._array("getLongList", key).toLongList()

    def getFloatList(self, key: str) -> FloatList:
        """Return an array of numbers in a FloatList."""
        return self._array("getFloatList", key).toFloatList()

    def getDoubleList(self, key: str) -> DoubleList:
        """Return an array of numbers in a DoubleList."""
        return self._array("getDoubleList", key).toDoubleList()

    def _found(
        self, name: str, key: str, wanted: str, read: Callable[[object], T | None], other: T | None
    ) -> T:
        if key not in self._values and other is None:
            raise self._no_key(key)
        value = self._values.get(key)
        found = read(value)
        if found is None and other is None:
            raise not_a(f'{name}("{key}")', wanted, value)
        return cast("T", other if found is None else found)

    def _part(self, name: str, key: str, kind: type[T]) -> T | None:
        value = self._values.get(key)
        if value is None:
            self._remark(name, key)
            return None
        if not isinstance(value, kind):
            raise not_a(f'{name}("{key}")', kind.__name__, value)
        return value

    def _array(self, name: str, key: str) -> JSONArray:
        if key not in self._values:
            raise self._no_key(key)
        value = self._values[key]
        if not isinstance(value, JSONArray):
            raise not_a(f'{name}("{key}")', "JSONArray", value)
        return value

    def _no_key(self, key: object) -> SketchError:
        return no_name("This JSONObject", "key", key, self._values)

    def _remark(self, name: str, key: str) -> None:
        """Say that a key is probably misspelt: as in Processing, None is the result."""
        if key not in self._values and (close := nearest(str(key), self._values)):
            warn_once(f"{name}() finds no key {key!r} and gives None. Do you mean {close!r}?")
