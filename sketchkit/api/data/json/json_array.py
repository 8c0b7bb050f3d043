"""JSONArray: values in a row, as JSON has them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import cast, overload

from sketchkit.api.data.faults import fraction, no_place, whole, wrong_kind
from sketchkit.api.data.json.array_reading import ArrayReading, as_array, as_object
from sketchkit.api.data.json.values import finite, held, parsed_or_none, single


class JSONArray(ArrayReading, Sequence[object], plain=list):
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

    def append(self, value: object) -> JSONArray:
        """Add a value at the end, and return the array.

        Parameters
        ----------
        value
            Text, a number, True, False, None, a JSONObject, a JSONArray, a dictionary or a
            list.

        Examples
        --------
        >>> values = JSONArray()
        >>> values.append("Goat").append(3).append([1, 2])
        ["Goat",3,[1,2]]
        """
        self._values.append(held("append", value))
        return self

    def setString(self, index: int, value: str | None) -> JSONArray:
        """Set the text at a place, and return the array; one that is too short grows.

        Parameters
        ----------
        index : int
            Its place, counted from 0.
        value : str
            The text; None is JSON's null.

        Examples
        --------
        >>> names = JSONArray(["Ida", "Ben"])
        >>> names.setString(1, "Cleo")
        ["Ida","Cleo"]
        """
        if value is not None and not isinstance(value, str):
            raise wrong_kind("setString", "text", value, place=index)
        return self._set("setString", index, value)

    def setInt(self, index: int, value: int) -> JSONArray:
        """Set the whole number at a place, and return the array; one that is too short grows.

        Parameters
        ----------
        index : int
            Its place, counted from 0.
        value : int
            The number; a fraction is cut off.

        Examples
        --------
        >>> scores = JSONArray()
        >>> scores.setInt(0, 30)
        [30]
        >>> scores.setInt(2, 10)
        [30,null,10]
        """
        return self._set("setInt", index, whole("setInt", value, place=index))

    setLong = setInt

    def setFloat(self, index: int, value: float) -> JSONArray:
        """Set the number at a place, and return the array; one that is too short grows.

        Parameters
        ----------
        index : int
            Its place, counted from 0.
        value : float
            The number; it is kept in 32 bits. `setDouble()` keeps all digits.

        Examples
        --------
        >>> heights = JSONArray()
        >>> heights.setFloat(0, 1.5)
        [1.5]
        """
        number = single("setFloat", fraction("setFloat", value, place=index))
        return self._set("setFloat", index, number)

    def setDouble(self, index: int, value: float) -> JSONArray:
        """Set a number, and return the array; one that is too short grows."""
        number = finite("setDouble", fraction("setDouble", value, place=index))
        return self._set("setDouble", index, number)

    def setBoolean(self, index: int, value: bool) -> JSONArray:
        """Set the truth value at a place, and return the array; one that is too short grows.

        Parameters
        ----------
        index : int
            Its place, counted from 0.
        value : bool
            True or False.

        Examples
        --------
        >>> answers = JSONArray()
        >>> answers.setBoolean(0, 3 > 2)
        [true]
        """
        return self._set("setBoolean", index, bool(value))

    def setJSONArray(self, index: int, value: object) -> JSONArray:
        """Set the array at a place, and return the array that it stands in; one too short grows.

        Parameters
        ----------
        index : int
            Its place, counted from 0.
        value : JSONArray or list
            The array.

        Examples
        --------
        >>> rows = JSONArray()
        >>> rows.setJSONArray(0, JSONArray([1, 2]))
        [[1,2]]
        """
        if as_array(array := held("setJSONArray", value)) is None and value is not None:
            raise wrong_kind("setJSONArray", "a JSONArray or a list", value, place=index)
        return self._set("setJSONArray", index, array)

    def setJSONObject(self, index: int, value: object) -> JSONArray:
        """Set the object at a place, and return the array; one that is too short grows.

        Parameters
        ----------
        index : int
            Its place, counted from 0.
        value : JSONObject or dict
            The object.

        Examples
        --------
        >>> animal = JSONObject()
        >>> animal.setString("species", "Goat")
        {"species":"Goat"}
        >>> animals = JSONArray()
        >>> animals.setJSONObject(0, animal)
        [{"species":"Goat"}]
        """
        if as_object(member := held("setJSONObject", value)) is None and value is not None:
            raise wrong_kind("setJSONObject", "a JSONObject or a dictionary", value, place=index)
        return self._set("setJSONObject", index, member)

    def remove(self, index: int) -> object:
        """Remove the value at a place, and return it; those behind it move up.

        Parameters
        ----------
        index : int
            Its place, counted from 0.

        Raises
        ------
        SketchError
            If there is no such place.

        Examples
        --------
        >>> names = JSONArray(["Ida", "Ben", "Cleo"])
        >>> names.remove(0)
        'Ida'
        >>> names.getString(0)
        'Ben'
        """
        return self._values.pop(self._place("remove", index))

    def _set(self, name: str, index: int, value: object) -> JSONArray:
        place = whole(name, index)
        if place < 0:
            raise no_place(name, index, self._values)
        self._values += [None] * (place + 1 - len(self._values))
        self._values[place] = value
        return self

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
