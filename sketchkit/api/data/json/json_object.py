"""JSONObject: values that are found by their keys, as JSON has them."""

from __future__ import annotations

from collections.abc import (
    ItemsView,
    Iterator,
    KeysView,
    Mapping,
    MutableMapping,
    ValuesView,
)
from typing import cast

from sketchkit.api.data.dicts.value_dict import ValueDict
from sketchkit.api.data.faults import fraction, whole, wrong_kind
from sketchkit.api.data.json.json_array import JSONArray
from sketchkit.api.data.json.object_reading import ObjectReading
from sketchkit.api.data.json.values import JSONValue, finite, held, parsed, single
from sketchkit.data.json_writing import quote


class JSONObject(ObjectReading, MutableMapping[str, object], plain=dict):
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

    def setString(self, key: str, value: str | None) -> JSONObject:
        """Set the text of a key, and return the object.

        Parameters
        ----------
        key : str
            The key.
        value : str
            The text; None is JSON's null.

        Examples
        --------
        >>> animal = JSONObject()
        >>> animal.setString("species", "Goat")
        {"species":"Goat"}
        """
        if value is not None and not isinstance(value, str):
            hint = f"str({value!r}) makes text of it."
            raise wrong_kind("setString", "text", value, hint, place=key)
        return self.put(key, value)

    def setInt(self, key: str, value: int) -> JSONObject:
        """Set the whole number of a key, and return the object.

        Parameters
        ----------
        key : str
            The key.
        value : int
            The number; a fraction is cut off.

        Examples
        --------
        >>> animal = JSONObject()
        >>> animal.setInt("legs", 4)
        {"legs":4}
        """
        return self.put(key, whole("setInt", value, place=key))

    setLong = setInt

    def setFloat(self, key: str, value: float) -> JSONObject:
        """Set the number of a key, and return the object.

        Parameters
        ----------
        key : str
            The key.
        value : float
            The number; it is kept in 32 bits. `setDouble()` keeps all digits.

        Examples
        --------
        >>> animal = JSONObject()
        >>> animal.setFloat("weight", 4.5)
        {"weight":4.5}
        """
        return self.put(key, single("setFloat", fraction("setFloat", value, place=key)))

    def setDouble(self, key: str, value: float) -> JSONObject:
        """Set a number, and return the object."""
        return self.put(key, finite("setDouble", fraction("setDouble", value, place=key)))

    def setBoolean(self, key: str, value: bool) -> JSONObject:
        """Set the truth value of a key, and return the object.

        Parameters
        ----------
        key : str
            The key.
        value : bool
            True or False.

        Examples
        --------
        >>> animal = JSONObject()
        >>> animal.setBoolean("tame", True)
        {"tame":true}
        """
        return self.put(key, bool(value))

    def setJSONObject(self, key: str, value: object) -> JSONObject:
        """Set the object of a key, and return the object that it stands in.

        Parameters
        ----------
        key : str
            The key.
        value : JSONObject or dict
            The object.

        Examples
        --------
        >>> place = JSONObject()
        >>> place.setInt("x", 10)
        {"x":10}
        >>> ball = JSONObject()
        >>> ball.setJSONObject("place", place)
        {"place":{"x":10}}
        """
        return self._put_part("setJSONObject", key, value, JSONObject, "a dictionary")

    def setJSONArray(self, key: str, value: object) -> JSONObject:
        """Set the array of a key, and return the object that it stands in.

        Parameters
        ----------
        key : str
            The key.
        value : JSONArray or list
            The array.

        Examples
        --------
        >>> game = JSONObject()
        >>> game.setJSONArray("scores", JSONArray([30, 10]))
        {"scores":[30,10]}
        """
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

    def keys(self) -> KeysView[str]:
        """Return the keys, in the order in which they came."""
        return self._values.keys()

    def values(self) -> ValuesView[object]:
        """Return the values, in the order of the keys."""
        return self._values.values()

    def items(self) -> ItemsView[str, object]:
        """Return pairs of a key and its value."""
        return self._values.items()

    def keyIterator(self) -> Iterator[str]:
        """Return what `next()` takes the keys of, one after the other."""
        return iter(self._values)

    def _put_part(
        self, name: str, key: str, value: object, kind: type[JSONValue], plain: str
    ) -> JSONObject:
        part = held(name, value)
        if part is not None and not isinstance(part, kind):
            raise wrong_kind(name, f"a {kind.__name__} or {plain}", value, place=key)
        return self.put(key, part)

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
