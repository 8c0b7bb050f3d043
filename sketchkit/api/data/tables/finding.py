"""The rows of a table that hold a text, or fit a regular expression."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

from sketchkit.api.data.tables.parts import Place
from sketchkit.api.data.tables.rows import Rows
from sketchkit.api.data.tables.table_row import TableRow
from sketchkit.core.errors import SketchError, shown
from sketchkit.data import strings


class Finding(Rows):
    """`findRow()`, `matchRows()` and the like."""

    def findRowIndex(self, value: str | None, column: Place) -> int:
        """Return the number of the first row with a text in a column, or -1."""
        return next(self._places(column, lambda text: text == value), -1)

    def findRowIndices(self, value: str | None, column: Place) -> list[int]:
        """Return the numbers of all rows with a text in a column."""
        return list(self._places(column, lambda text: text == value))

    def findRow(self, value: str | None, column: Place) -> TableRow | None:
        """Return the first row with a text in a column; None if there is none.

        Parameters
        ----------
        value : str
            The text, as it stands in the whole cell: numbers are given as text, too.
        column : int or str
            The number, from 0, or the title.

        See Also
        --------
        findRows, matchRow

        Examples
        --------
        >>> table = loadTable("ages.csv", "header")
        >>> table.findRow("Ben", "name").getInt("age"), table.findRow("Zoe", "name")
        (9, None)
        """
        place = self.findRowIndex(value, column)
        return None if place < 0 else TableRow(self, place)

    def findRows(self, value: str | None, column: Place) -> list[TableRow]:
        """Return a list of all rows with a text in a column.

        Parameters
        ----------
        value : str
            The text, as it stands in the whole cell: numbers are given as text, too.
        column : int or str
            The number, from 0, or the title.

        See Also
        --------
        findRow, matchRows

        Examples
        --------
        >>> table = loadTable("ages.csv", "header")
        >>> row = table.addRow(["Cleo", 12])
        >>> [row.getString("name") for row in table.findRows("12", "age")]
        ['Ida', 'Cleo']
        """
        return self.rows(self.findRowIndices(value, column))

    def findRowIterator(self, value: str | None, column: Place) -> Iterator[TableRow]:
        """Return what `next()` takes those rows of, one after the other."""
        return iter(self.findRows(value, column))

    def matchRowIndex(self, regexp: str, column: Place) -> int:
        """Return the number of the first row whose text fits a regular expression, or -1."""
        return next(self._places(column, _fits(regexp)), -1)

    def matchRowIndices(self, regexp: str, column: Place) -> list[int]:
        """Return the numbers of all rows whose text fits a regular expression."""
        return list(self._places(column, _fits(regexp)))

    def matchRow(self, regexp: str, column: Place) -> TableRow | None:
        """Return the first row whose text in a column fits a regular expression, or None.

        Parameters
        ----------
        regexp : str
            The expression, as for `match()`.
        column : int or str
            The number, from 0, or the title.

        Raises
        ------
        SketchError
            If it is no regular expression.

        See Also
        --------
        matchRows, findRow, match

        Examples
        --------
        >>> table = loadTable("ages.csv", "header")
        >>> table.matchRow("^B", "name").getInt("age")
        9
        """
        place = self.matchRowIndex(regexp, column)
        return None if place < 0 else TableRow(self, place)

    def matchRows(self, regexp: str, column: Place) -> list[TableRow]:
        """Return a list of all rows whose text in a column fits a regular expression.

        Parameters
        ----------
        regexp : str
            The expression, as for `match()`.
        column : int or str
            The number, from 0, or the title.

        Raises
        ------
        SketchError
            If it is no regular expression.

        See Also
        --------
        matchRow, findRows, match

        Examples
        --------
        >>> table = loadTable("ages.csv", "header")
        >>> [row.getString("name") for row in table.matchRows("^[A-M]", "name")]
        ['Ida', 'Ben']
        """
        return self.rows(self.matchRowIndices(regexp, column))

    def matchRowIterator(self, value: str, column: Place) -> Iterator[TableRow]:
        """Return what `next()`, or a loop, takes those rows of, one after the other.

        Parameters
        ----------
        value : str
            The expression, as for `match()`.
        column : int or str
            The number, from 0, or the title.

        See Also
        --------
        matchRows

        Examples
        --------
        >>> table = loadTable("ages.csv", "header")
        >>> for row in table.matchRowIterator("e", "name"):
        ...     println(row.getString("name"))
        Ben
        """
        return iter(self.matchRows(value, column))

    def _places(self, column: Place, is_wanted: Callable[[str | None], bool]) -> Iterator[int]:
        cells = self._columns[self._column_place("findRow", column)]
        return (row for row in range(self._count) if is_wanted(cells.text(row, self._missing)))


def _fits(regexp: str) -> Callable[[str | None], bool]:
    try:
        strings.match("", regexp)
    except (re.error, TypeError):
        raise SketchError("A row is matched by a regular expression.", got=shown(regexp)) from None
    return lambda text: text is not None and strings.match(text, regexp) is not None
