"""StringDict: texts, found by their keys."""

from __future__ import annotations

from collections.abc import Iterable

from sketchkit.api.data.dicts.value_dict import ValueDict
from sketchkit.api.data.faults import wrong_kind
from sketchkit.data.json_writing import quote


class StringDict(ValueDict[str | None]):
    """Texts that are found by their keys.

    Parameters
    ----------
    keys : optional
        A dictionary, a row of a table, a list of pairs, or a list of keys with a list of values
        behind it.
    values : list, optional
        The texts of the keys.

    Examples
    --------
    >>> capitals = StringDict({"France": "Paris"})
    >>> capitals.set("Austria", "Vienna")
    >>> capitals.sortKeys()
    >>> println(capitals)
    StringDict size=2 { "Austria": "Vienna", "France": "Paris" }
    >>> capitals.get("Peru") is None
    True
    """

    def __init__(self, keys: object = None, values: Iterable[object] | None = None) -> None:
        super().__init__(keys, values)

    def _read(self, item: object) -> str | None:
        return None if item is None else str(item)

    def _taken(self, name: str, value: object, key: str) -> str | None:
        if value is None or isinstance(value, str):
            return value
        raise wrong_kind(name, "text", value, f"str({value!r}) makes text of it.", place=key)

    def _text(self, value: str | None) -> str:
        return "null" if value is None else value

    def _quoted(self, value: str | None) -> str:
        return quote(value or "")

    def _rank(self, value: str | None) -> str:
        return (value or "").lower()
