"""JSONArray: values in a row, as JSON has them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, TypeVar, cast, overload

from sketchkit.api.data.faults import fraction, no_place, whole, wrong_kind
from sketchkit.api.data.json.values import (
    JSONValue,
    as_fraction,
    as_text,
    as_truth,
    as_whole,
    finite,
    held,
    not_a,
    parsed_or_none,
    single,
)
from sketchkit.api.data.lists.float_list import DoubleList, FloatList
from sketchkit.api.data.lists.int_list import IntList, LongList
from sketchkit.api.data.lists.string_list import StringList
from sketchkit.data.json_writing import COMPACT, write_json

if TYPE_CHECKING:
    from sketchkit.api.data.json.json_object import JSONObject

T = TypeVar("T")


class JSONArray(JSONValue, Sequence[object], plain=list):
    """Values in a row, as JSON has them: text, numbers, True, False, None, objects and arrays.

    Parameters
    ----------
    values : list, optional
        The values. Lists and dictionaries among them become arrays and objects.

    Notes
    -----
    It is a sequence, too: `array[0]`, `len(array)`, `for value in array`.

    Examples
    --------
    >>> scores = JSONArray([3, "four"])
    >>> scores.append(True)
    [3,"four",true]
    >>> scores.getInt(0), scores.getString(1), scores.size()
    (3, 'four', 3)
    >>> println(scores)
    [
      3,
      "four",
      true
    ]
    """

    def __init__(self, values: Iterable[object] = ()) -> None:
        self._values = [held("JSONArray", value) for value in values]

    @staticmethod
    def parse(source: str) -> JSONArray | None:
        """Return the array that a text holds; None, with a remark, if it holds none."""
        return cast("JSONArray | None", parsed_or_none("JSONArray.parse", source, list))

    def size(self) -> int:
        """Return how many values there are."""
        return len(self._values)

    def get(self, index: int) -> object:
        """Return the value at a place, whatever it is."""
        return self._values[self._place("get", index)]

    def getString(self, index: int, defaultValue: str | None = None) -> str | None:
        """Return a text; with a second value, anything as text, and that one if there is none."""
        if defaultValue is None:
            value = self.get(index)
            if value is None or isinstance(value, str):
                return value
            raise not_a(f"getString({index})", "text", value)
        value = self._values[index] if 0 <= index < len(self._values) else None
        return defaultValue if value is None else as_text(value)

    def getInt(self, index: int, defaultValue: int | None = None) -> int:
        """Return a whole number; a second value takes the place of what is none."""
        return self._found("getInt", index, "number", as_whole, defaultValue)

    getLong = getInt

    def getFloat(self, index: int, defaultValue: float | None = None) -> float:
        """Return a number; a second value takes the place of what is none."""
        return self._found("getFloat", index, "number", as_fraction, defaultValue)

    getDouble = getFloat

    def getBoolean(self, index: int, defaultValue: bool | None = None) -> bool:
        """Return True or False; a second value takes the place of what is neither."""
        return self._found("getBoolean", index, "truth value", as_truth, defaultValue)

    def getJSONArray(self, index: int, defaultValue: JSONArray | None = None) -> JSONArray:
        """Return an array; a second value takes the place of what is none."""
        return self._found("getJSONArray", index, "JSONArray", _as_array, defaultValue)

    def getJSONObject(self, index: int, defaultValue: JSONObject | None = None) -> JSONObject:
        """Return an object; a second value takes the place of what is none."""
        return self._found("getJSONObject", index, "JSONObject", _as_object, defaultValue)

    def isNull(self, index: int) -> bool:
        """Return whether there is null at a place, or nothing."""
        return not 0 <= index < len(self._values) or self._values[index] is None

    def append(self, value: object) -> JSONArray:
        """Add a value at the end, and return the array."""
        self._values.append(held("append", value))
        return self

    def setString(self, index: int, value: str | None) -> JSONArray:
        """Set a text, and return the array; one that is too short grows."""
        if value is not None and not isinstance(value, str):
            raise wrong_kind("setString", "text", value, place=index)
        return self._set("setString", index, value)

    def setInt(self, index: int, value: int) -> JSONArray:
        """Set a whole number, and return the array; one that is too short grows."""
        return self._set("setInt", index, whole("setInt", value, place=index))

    setLong = setInt

    def setFloat(self, index: int, value: float) -> JSONArray:
        """Set a number in 32 bits, and return the array; `setDouble()` keeps all digits."""
        number = single("setFloat", fraction("setFloat", value, place=index))
        return self._set("setFloat", index, number)

    def setDouble(self, index: int, value: float) -> JSONArray:
        """Set a number, and return the array; one that is too short grows."""
        number = finite("setDouble", fraction("setDouble", value, place=index))
        return self._set("setDouble", index, number)

    def setBoolean(self, index: int, value: bool) -> JSONArray:
        """Set True or False, and return the array; one that is too short grows."""
        return self._set("setBoolean", index, bool(value))

    def setJSONArray(self, index: int, value: object) -> JSONArray:
        """Set an array or a list, and return the array; one that is too short grows."""
        if _as_array(array := held("setJSONArray", value)) is None and value is not None:
            raise wrong_kind("setJSONArray", "a JSONArray or a list", value, place=index)
        return self._set("setJSONArray", index, array)

    def setJSONObject(self, index: int, value: object) -> JSONArray:
        """Set an object or a dictionary, and return the array; one that is too short grows."""
        if _as_object(member := held("setJSONObject", value)) is None and value is not None:
            raise wrong_kind("setJSONObject", "a JSONObject or a dictionary", value, place=index)
        return self._set("setJSONObject", index, member)

    def remove(self, index: int) -> object:
        """Remove the value at a place, and return it."""
        return self._values.pop(self._place("remove", index))

    def join(self, separator: str) -> str:
        """Return the values as one text, with a separator between them."""
        return separator.join(write_json(value, COMPACT) for value in self._values)

    def toStringArray(self) -> list[str | None]:
        """Return the values as a list; all have to be text."""
        return [self.getString(place) for place in range(len(self._values))]

    def toIntArray(self) -> list[int]:
        """Return the values as a list; all have to be numbers."""
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

    def _set(self, name: str, index: int, value: object) -> JSONArray:
        place = whole(name, index)
        if place < 0:
            raise no_place(name, index, self._values)
        self._values += [None] * (place + 1 - len(self._values))
        self._values[place] = value
        return self

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

    def __len__(self) -> int:
        return len(self._values)

    def __iter__(self) -> Iterator[object]:
        return iter(self._values)

    @overload
    def __getitem__(self, place: int) -> object: ...
    @overload
    def __getitem__(self, place: slice) -> list[object]: ...
    def __getitem__(self, place: int | slice) -> object:
        try:
            return self._values[place]
        except IndexError:
            raise no_place("get", place, self._values) from None

    def __setitem__(self, place: int, value: object) -> None:
        try:
            self._values[place] = held("set", value)
        except IndexError:
            raise no_place("set", place, self._values) from None

    def __delitem__(self, place: int | slice) -> None:
        del self._values[place]

    def __eq__(self, other: object) -> bool:
        if isinstance(other, JSONArray | list | tuple):
            return self._values == list(other)
        return NotImplemented

    __hash__ = None  # type: ignore[assignment] # it can change, as a list


def _as_array(value: object) -> JSONArray | None:
    return value if isinstance(value, JSONArray) else None


def _as_object(value: object) -> JSONObject | None:
    kind = JSONValue.kinds[dict]
    return cast("JSONObject", value) if isinstance(value, kind) else None
