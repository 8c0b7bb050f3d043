"""Changes to many cells of a table at once, and what is counted and gathered from them."""

from __future__ import annotations

import re
from collections.abc import Callable

from sketchkit.api.data.dicts.float_dict import FloatDict
from sketchkit.api.data.dicts.int_dict import IntDict
from sketchkit.api.data.dicts.string_dict import StringDict
from sketchkit.api.data.lists.float_list import FloatList
from sketchkit.api.data.lists.int_list import IntList
from sketchkit.api.data.lists.string_list import StringList
from sketchkit.api.data.tables.cells import Cells
from sketchkit.api.data.tables.columns import Columns
from sketchkit.api.data.tables.finding import Finding
from sketchkit.api.data.tables.parts import Place
from sketchkit.api.data.tables.table_row import TableRow
from sketchkit.core.errors import SketchError, shown
from sketchkit.data import strings
from sketchkit.data.columns import ColumnKind


class Cleaning(Cells, Columns, Finding):
    """`trim()`, `removeTokens()`, `getTally()` and the like. Without a column they mean all."""

    def trim(self, column: Place | None = None) -> None:
        """Remove spaces around texts; without a column blank rows and columns at the edges, too.

        Parameters
        ----------
        column : int or str, optional
            The number, from 0, or the title; all columns if it is left out.

        Examples
        --------
        >>> table = Table([{"name": " Ida "}, {"name": ""}])
        >>> table.trim()
        >>> table.getStringColumn("name")
        ['Ida']
        """
        self._change("trim", column, strings.trim)
        if column is None:
            for each in self._columns:
                each.title = each.title and strings.trim(each.title)
            self._remove_blank_edges()

    def removeTokens(self, tokens: str, column: Place | None = None) -> None:
        """Remove single characters from texts, wherever they stand.

        Parameters
        ----------
        tokens : str
            The characters.
        column : int or str, optional
            The number, from 0, or the title; all columns if it is left out.

        Examples
        --------
        >>> table = Table([{"price": "$1,250"}])
        >>> table.removeTokens("$,")
        >>> table.getInt(0, "price")
        1250
        """
        nothing = str.maketrans("", "", tokens)
        self._change("removeTokens", column, lambda text: text.translate(nothing))

    def replace(self, orig: str | None, replacement: str | None, col: Place | None = None) -> None:
        """Replace texts that are the same as another in whole."""
        for place in self._places_of("replace", col):
            cells = self._columns[place]
            if cells.kind is ColumnKind.STRING:
                cells.cells = [replacement if cell == orig else cell for cell in cells.cells]

    def replaceAll(self, regex: str, replacement: str, column: Place | None = None) -> None:
        """Replace what fits a regular expression, wherever it stands in a text."""
        try:
            pattern = re.compile(regex)
        except (re.error, TypeError):
            problem = "replaceAll() takes a regular expression."
            raise SketchError(problem, got=shown(regex)) from None
        new = re.sub(r"\$(\d)", r"\\g<\1>", replacement.replace("\\", "\\\\"))  # as in Java
        self._change("replaceAll", column, lambda text: pattern.sub(new, text))

    def getUnique(self, column: Place) -> list[str]:
        """Return each text of a column once."""
        return self.getStringList(column).getUnique()

    def getTally(self, column: Place) -> IntDict:
        """Return how often each text of a column is there."""
        return self.getStringList(column).getTally()

    def getOrder(self, column: Place) -> IntDict:
        """Return the last row of each text of a column."""
        return self.getStringList(column).getOrder()

    def getStringList(self, column: Place) -> StringList:
        """Return a column as a StringList."""
        return StringList(self.getStringColumn(column))

    def getIntList(self, column: Place) -> IntList:
        """Return a column as an IntList."""
        return IntList(self.getIntColumn(column))

    def getFloatList(self, column: Place) -> FloatList:
        """Return a column as a FloatList."""
        return FloatList(self.getFloatColumn(column))

    def getStringDict(self, keyColumn: Place, valueColumn: Place) -> StringDict:
        """Return the texts of a column, found by those of another."""
        return StringDict(self._keys(keyColumn), self.getStringColumn(valueColumn))

    def getIntDict(self, keyColumn: Place, valueColumn: Place) -> IntDict:
        """Return the whole numbers of a column, found by the texts of another."""
        return IntDict(self._keys(keyColumn), self.getIntColumn(valueColumn))

    def getFloatDict(self, keyColumn: Place, valueColumn: Place) -> FloatDict:
        """Return the numbers of a column, found by the texts of another."""
        return FloatDict(self._keys(keyColumn), self.getFloatColumn(valueColumn))

    def getRowMap(self, column: Place) -> dict[str | None, TableRow]:
        """Return a dictionary of the rows, found by their texts in a column."""
        return dict(zip(self.getStringColumn(column), self.rows(), strict=True))

    def _keys(self, column: Place) -> list[str]:
        return [text or "" for text in self.getStringColumn(column)]

    def _change(self, name: str, column: Place | None, change: Callable[[str], str]) -> None:
        for place in self._places_of(name, column):
            cells = self._columns[place]
            if cells.kind is ColumnKind.STRING:
                cells.cells = [change(c) if isinstance(c, str) else c for c in cells.cells]

    def _places_of(self, name: str, column: Place | None) -> list[int]:
        if column is None:
            return list(range(len(self._columns)))
        return [self._column_place(name, column)]

    def _remove_blank_edges(self) -> None:
        while self._columns and not any(self.getStringColumn(len(self._columns) - 1)):
            self.removeColumn(len(self._columns) - 1)
        while self._columns and not any(self.getStringColumn(0)):
            self.removeColumn(0)
        while self._count and not any(self._texts(self._count - 1)):
            self.removeRow(self._count - 1)
        while self._count and not any(self._texts(0)):
            self.removeRow(0)
