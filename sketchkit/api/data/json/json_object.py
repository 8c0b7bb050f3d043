"""JSONObject: values that are found by their keys, as JSON has them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, MutableMapping
from typing import TypeVar, cast

from sketchkit.api.data.dicts.value_dict import ValueDict
from sketchkit.api.data.faults import fraction, no_name, whole, wrong_kind
from sketchkit.api.data.json.json_array import JSONArray
from sketchkit.api.data.json.values import (
    JSONValue,
    as_fraction,
    as_text,
    as_truth,
    as_whole,
    finite,
    held,
    not_a,
    parsed,
    single,
)
from sketchkit.api.data.lists.float_list import DoubleList, FloatList
from sketchkit.api.data.lists.int_list import IntList, LongList
from sketchkit.api.data.lists.string_list import StringList
from sketchkit.core.errors import SketchError, nearest
from sketchkit.core.notices import warn_once
from sketchkit.data.json_writing import quote

T = TypeVar("T")


class JSONObject(JSONValue, MutableMapping[str, object], plain=dict):
    """Values that are found by their keys, as JSON has them.

    Parameters
    ----------
    values : dict, optional
        The keys and their values. Lists and dictionaries among them become arrays and objects.

    Notes
    -----
    It is a dictionary, too: `json["name"]`, `"name" in json`, `for key in json`. The keys keep
    the order in which they came; Processing's have none.

    Examples
    --------
    >>> animal = JSONObject()
    >>> animal.setInt("id", 0)
    {"id":0}
    >>> animal.setString("species", "Panthera leo")
    {"id":0,"species":"Panthera leo"}
    >>> animal["legs"] = 4
    >>> animal.getString("species"), animal.getInt("legs"), animal.getInt("wings", 0)
    ('Panthera leo', 4, 0)
    >>> println(animal)
    {
      "id": 0,
      "species": "Panthera leo",
      "legs": 4
    }
    """

    NULL = None

    def __init__(self, values: Mapping[str, object] | ValueDict[object] | None = None) -> None:
        pairs = [] if values is None else values.items()
        self._values = {str(key): held("JSONObject", value) for key, value in pairs}

    @staticmethod
    def parse(source: str) -> JSONObject:
        """Return the object that a text holds."""
        if not isinstance(source, str):
            raise wrong_kind("JSONObject.parse", "text", source)
        return cast("JSONObject", parsed("The text", source, dict))

    @staticmethod
    def quote(string: str) -> str:
        """Return a text in quotes, as JSON has it."""
        return quote(string or "")

    def size(self) -> int:
        """Return how many keys there are."""
        return len(self._values)

    def hasKey(self, key: str) -> bool:
        """Return whether there is a key."""
        return key in self._values

    def isNull(self, key: str) -> bool:
        """Return whether the value of a key is null, or there is no such key."""
        return self._values.get(key) is None

    def getString(self, key: str, defaultValue: str | None = None) -> str | None:
        """Return a text, or None if there is no such key.

        With a second value, anything is returned as text, and that one if there is nothing.
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
        """Return a whole number; a second value takes the place of what is none."""
        return self._found("getInt", key, "number", as_whole, defaultValue)

    getLong = getInt

    def getFloat(self, key: str, defaultValue: float | None = None) -> float:
        """Return a number; a second value takes the place of what is none."""
        return self._found("getFloat", key, "number", as_fraction, defaultValue)

    getDouble = getFloat

    def getBoolean(self, key: str, defaultValue: bool | None = None) -> bool:
        """Return True or False; a second value takes the place of what is neither."""
        return self._found("getBoolean", key, "truth value", as_truth, defaultValue)

    def getJSONArray(self, key: str) -> JSONArray | None:
        """Return an array, or None if there is no such key."""
        return self._part("getJSONArray", key, JSONArray)

    def getJSONObject(self, key: str) -> JSONObject | None:
        """Return an object, or None if there is no such key."""
        return self._part("getJSONObject", key, JSONObject)

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

    def setString(self, key: str, value: str | None) -> JSONObject:
        """Set a text, and return the object."""
        if value is not None and not isinstance(value, str):
            hint = f"str({value!r}) makes text of it."
            raise wrong_kind("setString", "text", value, hint, place=key)
        return self.put(key, value)

    def setInt(self, key: str, value: int) -> JSONObject:
        """Set a whole number, and return the object."""
        return self.put(key, whole("setInt", value, place=key))

    setLong = setInt

    def setFloat(self, key: str, value: float) -> JSONObject:
        """Set a number in 32 bits, and return the object; `setDouble()` keeps all digits."""
        return self.put(key, single("setFloat", fraction("setFloat", value, place=key)))

    def setDouble(self, key: str, value: float) -> JSONObject:
        """Set a number, and return the object."""
        return self.put(key, finite("setDouble", fraction("setDouble", value, place=key)))

    def setBoolean(self, key: str, value: bool) -> JSONObject:
        """Set True or False, and return the object."""
        return self.put(key, bool(value))

    def setJSONObject(self, key: str, value: object) -> JSONObject:
        """Set an object or a dictionary, and return the object."""
        return self._put_part("setJSONObject", key, value, JSONObject, "a dictionary")

    def setJSONArray(self, key: str, value: object) -> JSONObject:
        """Set an array or a list, and return the object."""
        return self._put_part("setJSONArray", key, value, JSONArray, "a list")

    def put(self, key: str, value: object) -> JSONObject:
        """Set a value of any kind, and return the object; None removes nothing: it is null."""
        if not isinstance(key, str):
            raise wrong_kind("put", "text as the key", key, f"str({key!r}) makes text of it.")
        self._values[key] = held("put", value)
        return self

    def remove(self, key: str) -> object:
        """Remove a key, and return its value; None if there is no such key."""
        return self._values.pop(key, None)

    def keyIterator(self) -> Iterator[str]:
        """Return what `next()` takes the keys of, one after the other."""
        return iter(self._values)

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

    def _put_part(
        self, name: str, key: str, value: object, kind: type[JSONValue], plain: str
    ) -> JSONObject:
        part = held(name, value)
        if part is not None and not isinstance(part, kind):
            raise wrong_kind(name, f"a {kind.__name__} or {plain}", value, place=key)
        return self.put(key, part)

    def _no_key(self, key: object) -> SketchError:
        return no_name("This JSONObject", "key", key, self._values)

    def _remark(self, name: str, key: str) -> None:
        """Say that a key is probably misspelt: as in Processing, None is the result."""
        if key not in self._values and (close := nearest(str(key), self._values)):
            warn_once(f"{name}() finds no key {key!r} and gives None. Do you mean {close!r}?")

    def __len__(self) -> int:
        return len(self._values)

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __contains__(self, key: object) -> bool:
        return key in self._values

    def __getitem__(self, key: str) -> object:
        if key not in self._values:
            raise self._no_key(key)
        return self._values[key]

    def __setitem__(self, key: str, value: object) -> None:
        self.put(key, value)

    def __delitem__(self, key: str) -> None:
        if key not in self._values:
            raise self._no_key(key)
        del self._values[key]
