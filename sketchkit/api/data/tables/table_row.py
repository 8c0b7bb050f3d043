"""TableRow: one row of a table."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from sketchkit.api.data.lists.value_list import Writes
from sketchkit.api.data.tables.parts import Place
from sketchkit.core.errors import SketchError
from sketchkit.data.columns import FRACTIONAL, WHOLE

if TYPE_CHECKING:
    from sketchkit.api.data.tables.rows import Rows
    from sketchkit.api.data.tables.table import Table


class TableRow:
    """A row of a table: what is set here is set there.

    Notes
    -----
    A column is its number, from 0, or its title. `row["age"]` is what the column holds.

    Examples
    --------
    >>> table = Table()
    >>> table.addColumn("name")
    >>> table.addColumn("age", Table.INT)
    >>> row = table.addRow()
    >>> row.setString("name", "Ida")
    >>> row["age"] = 12
    >>> row.getString("name"), row.getInt("age"), row["age"], row.getString("age")
    ('Ida', 12, 12, '12')
    """

    def __init__(self, table: Rows, row: int) -> None:
        self._table: Table = table  # type: ignore[assignment] # tables are of one class
        self._row = row

    def getString(self, column: Place) -> str | None:
        """Return a cell as text; None if it was never set.

        Parameters
        ----------
        column : int or str
            Its column: the number, from 0, or the title.

        Examples
        --------
        >>> row = loadTable("ages.csv", "header").getRow(0)
        >>> row.getString("name"), row.getString(1)
        ('Ida', '12')
        """
        return self._table.getString(self._row, column)

    def getInt(self, column: Place) -> int:
        """Return a cell as a whole number; 0 for text that is no number.

        Parameters
        ----------
        column : int or str
            Its column: the number, from 0, or the title.

        Examples
        --------
        >>> row = loadTable("ages.csv", "header").getRow(0)
        >>> row.getInt("age"), row.getInt("name")
        (12, 0)
        """
        return self._table.getInt(self._row, column)

    def getLong(self, column: Place) -> int:
        """Return a cell as a whole number of any size; 0 if it is none."""
        return self._table.getLong(self._row, column)

    def getFloat(self, column: Place) -> float:
        """Return a cell as a number; NaN for text that is no number.

        Parameters
        ----------
        column : int or str
            Its column: the number, from 0, or the title.

        Examples
        --------
        >>> row = loadTable("ages.csv", "header").getRow(1)
        >>> circle(50, 50, row.getFloat("age") * 2.5)
        """
        return self._table.getFloat(self._row, column)

    def getDouble(self, column: Place) -> float:
        """Return a cell as a number; NaN if it is none."""
        return self._table.getDouble(self._row, column)

    def setString(self, column: Place, value: str | None) -> None:
        """Set a cell to a text. A title that no column has adds a column.

        Parameters
        ----------
        column : int or str
            Its column: the number, from 0, or the title.
        value : str
            The text; None for a missing one.

        Examples
        --------
        >>> table = loadTable("ages.csv", "header")
        >>> table.getRow(0).setString("name", "Ida Noe")
        >>> table.getString(0, "name")
        'Ida Noe'
        """
        self._table.setString(self._row, column, value)

    def setInt(self, column: Place, value: int) -> None:
        """Set a cell to a whole number: as text, if the column has text.

        Parameters
        ----------
        column : int or str
            Its column: the number, from 0, or the title.
        value : int
            The number; a fraction is cut off.

        Examples
        --------
        >>> table = loadTable("ages.csv", "header")
        >>> for row in table.rows():
        ...     row.setInt("age", row.getInt("age") + 1)
        >>> table.getIntColumn("age")
        [13, 10]
        """
        self._table.setInt(self._row, column, value)

    setLong = setInt

    def setFloat(self, column: Place, value: float) -> None:
        """Set a cell to a number: as text, if the column has text.

        Parameters
        ----------
        column : int or str
            Its column: the number, from 0, or the title.
        value : float
            The number; in text seven digits of it are kept. `setDouble()` keeps all.

        Examples
        --------
        >>> row = loadTable("ages.csv", "header").getRow(0)
        >>> row.setFloat("age", 12.5)
        >>> row.getFloat("age")
        12.5
        """
        self._table.setFloat(self._row, column, value)

    def setDouble(self, column: Place, value: float) -> None:
        """Set a cell to a number: as text, if the column has text."""
        self._table.setDouble(self._row, column, value)

    def getColumnCount(self) -> int:
        """Return how many columns there are.

        Examples
        --------
        >>> row = loadTable("ages.csv", "header").getRow(0)
        >>> for i in range(row.getColumnCount()):
        ...     println(row.getString(i))
        Ida
        12
        """
        return self._table.getColumnCount()

    def getColumnTitle(self, column: int) -> str | None:
        """Return the title of a column; None if it has none.

        Parameters
        ----------
        column : int
            Its number, from 0.

        Examples
        --------
        >>> row = loadTable("ages.csv", "header").getRow(0)
        >>> row.getColumnTitle(0), row.getString(0)
        ('name', 'Ida')
        """
        return self._table.getColumnTitle(column)

    def getColumnTitles(self) -> list[str | None] | None:
        """Return all titles; None if the table has none."""
        return self._table.getColumnTitles()

    def getColumnType(self, column: Place) -> int:
        """Return what a column holds: `Table.STRING`, `Table.INT`, ..."""
        return self._table.getColumnType(column)

    def getColumnTypes(self) -> list[int]:
        """Return what each column holds: `Table.STRING`, `Table.INT`, ..."""
        return self._table.getColumnTypes()

    def print(self) -> None:
        """Print the cells with tabs between them."""
        print(self._line())

    def write(self, writer: Writes) -> None:
        """Write the cells, with tabs between them, to what `createWriter()` has made."""
        writer.write(self._line())

    def texts(self) -> list[str | None]:
        """Return the cells as texts."""
        return self._table.getStringRow(self._row)

    def items(self) -> list[tuple[str, str | None]]:
        """Return the titles, or numbers, of the columns with the cells as texts."""
        titles = self.getColumnTitles() or [None] * self.getColumnCount()
        names = [str(place) if t is None else t for place, t in enumerate(titles)]
        return list(zip(names, self.texts(), strict=True))

    def _line(self) -> str:
        return "\t".join("null" if text is None else text for text in self.texts())

    def __iter__(self) -> Iterator[object]:
        return (self[place] for place in range(self.getColumnCount()))

    def __len__(self) -> int:
        return self.getColumnCount()

    def __getitem__(self, column: Place) -> object:
        kind = self.getColumnType(column)
        if kind in WHOLE:
            return self.getLong(column)
        return self.getDouble(column) if kind in FRACTIONAL else self.getString(column)

    def __setitem__(self, column: Place, value: object) -> None:
        match value:
            case None | str():
                self.setString(column, value)
            case bool():
                self.setString(column, str(value))
            case int() if not self._is_fractional(column):
                self.setInt(column, value)
            case int() | float():
                self.setDouble(column, value)
            case _:
                raise SketchError("A cell holds text or a number.", got=type(value).__name__)

    def _is_fractional(self, column: Place) -> bool:
        return self.getColumnType(column) in FRACTIONAL

    def __repr__(self) -> str:
        return f"TableRow {dict(self.items())}"
