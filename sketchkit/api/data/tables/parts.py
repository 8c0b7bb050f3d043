"""What a table is made of, and how its rows and columns are found."""

from __future__ import annotations

from collections.abc import Iterator

from sketchkit.api.data.faults import PlaceError, no_name, whole
from sketchkit.core.errors import SketchError, kind_of, shown
from sketchkit.data.columns import Column, ColumnKind, Missing

Place = int | str  # of a column: its number from 0, or its title


class TableParts:
    """All the attributes that there are. Groups add methods, never attributes.

    `_source` is what messages call the table: the file that it was read from, or "This table".
    """

    _columns: list[Column]
    _count: int
    _has_titles: bool
    _missing: Missing
    _source: str

    def _titles(self) -> list[str]:
        return [column.title for column in self._columns if column.title is not None]

    def _column_place(self, name: str, column: Place) -> int:
        """Return the number of a column, or raise that there is none."""
        if isinstance(column, str):
            return self._titled_place(column)
        place = whole(name, column)
        if 0 <= place < len(self._columns):
            return place
        raise PlaceError(
            f"{self._source} has no column {place}.",
            got=f"{name}() for column {place}",
            hint=f"Its columns are 0 to {len(self._columns) - 1}."
            if self._columns
            else "It has no columns: addColumn() makes one.",
        )

    def _titled_place(self, title: str) -> int:
        if not self._has_titles:
            raise SketchError(
                f"{self._source} has no titles, so there is no column {title!r}.",
                hint='loadTable("data.csv", "header") takes them from its first line.',
            )
        for place in range(len(self._columns) - 1, -1, -1):
            if self._columns[place].title == title:
                return place
        raise no_name(self._source, "column", title, self._titles())

    def _cell(self, name: str, row: int, column: Place) -> tuple[Column, int]:
        """Return a column and the number of a row, which both exist."""
        return self._columns[self._column_place(name, column)], self._row_place(name, row)

    def _row_place(self, name: str, row: object) -> int:
        place = whole(name, row)
        if 0 <= place < self._count:
            return place
        raise PlaceError(
            f"{self._source} has no row {place}.",
            got=f"{name}() for row {place}",
            hint=f"Its rows are 0 to {self._count - 1}." if self._count else "It has no rows.",
        )

    def _reach(self, row: int, column: int) -> None:
        """Grow until there are a row and a column."""
        if row < 0 or column < 0:
            raise PlaceError(
                "Rows and columns are counted from 0.", got=f"row {row}, column {column}"
            )
        while len(self._columns) <= column:
            self._columns.append(Column([None] * self._count))
        if row >= self._count:
            self._resize(row + 1)

    def _resize(self, count: int) -> None:
        for column in self._columns:
            column.resize(count)
        self._count = count

    def _texts(self, row: int) -> list[str | None]:
        return [column.text(row, self._missing) for column in self._columns]

    def _all_texts(self) -> Iterator[list[str | None]]:
        return (self._texts(row) for row in range(self._count))


def kind_from(kind: object) -> ColumnKind:
    """Return the kind of a column that `Table.INT`, or its name "int", means.

    Raises
    ------
    SketchError
        If it means none.
    """
    try:
        return ColumnKind[kind.upper()] if isinstance(kind, str) else ColumnKind(kind)  # type: ignore[arg-type] # checked by being tried
    except (KeyError, ValueError):
        raise SketchError(
            "A column is a Table.STRING, INT, LONG, FLOAT, DOUBLE or CATEGORY.",
            got=f"{kind_of(kind)}: {shown(kind)}",
        ) from None
