"""StringList: texts in a row."""

from __future__ import annotations

from sketchkit.api.data.dicts.int_dict import IntDict
from sketchkit.api.data.faults import wrong_kind
from sketchkit.api.data.lists.value_list import ValueList
from sketchkit.data.json_writing import quote
from sketchkit.data.ordering import sort_in_place


class StringList(ValueList[str | None]):
    """Texts in a row.

    Parameters
    ----------
    *items
        The texts, or one list of them.

    Notes
    -----
    A place that was never set is None.

    Examples
    --------
    >>> names = StringList("berta", "Anna")
    >>> names.append("carl")
    >>> names.sort()
    >>> println(names)
    StringList size=3 [ "Anna", "berta", "carl" ]
    >>> names.upper()
    >>> names.join(" ")
    'ANNA BERTA CARL'
    >>> StringList("a", "b", "a").getTally()["a"]
    2
    """

    _blank = None

    def _read(self, item: object) -> str | None:
        return None if item is None else str(item)

    def _taken(self, name: str, value: object) -> str | None:
        if value is None or isinstance(value, str):
            return value
        raise wrong_kind(name, "text", value, f"str({value!r}) makes text of it.")

    def _text(self, value: str | None) -> str:
        return "null" if value is None else value

    def _quoted(self, value: str | None) -> str:
        return quote(value or "")

    def sort(self) -> None:
        """Sort the texts by the alphabet; small and capital letters are the same."""
        sort_in_place(self._values, _without_capitals)

    def sortReverse(self) -> None:
        """Sort the texts against the alphabet; small and capital letters are the same."""
        sort_in_place(self._values, _without_capitals, reverse=True)

    def lower(self) -> None:
        """Make all letters small."""
        self._values = [value and value.lower() for value in self._values]

    def upper(self) -> None:
        """Make all letters capital."""
        self._values = [value and value.upper() for value in self._values]

    def getUnique(self) -> list[str]:
        """Return each text once."""
        return self.getTally().keyArray()

    def getTally(self) -> IntDict:
        """Return how often each text is there."""
        tally = IntDict()
        for value in self._values:
            tally.increment(value or "")
        return tally

    def getOrder(self) -> IntDict:
        """Return where each text is last."""
        order = IntDict()
        for place, value in enumerate(self._values):
            order.set(value or "", place)
        return order


def _without_capitals(value: str | None) -> str:
    return (value or "").lower()
