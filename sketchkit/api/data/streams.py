"""Files read and written piece by piece: what `createReader()` and its sisters return."""

from __future__ import annotations

import io
from collections.abc import Iterable, Iterator
from types import TracebackType
from typing import Self

from sketchkit.api.data.saving import save_bytes, save_text
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import calling_place
from sketchkit.data.text_files import lines_of


class BufferedReader:
    """A text, read line by line; `createReader()` makes it.

    Examples
    --------
    >>> reader = createReader("poem.txt")
    >>> reader.readLine()
    'A rose'
    >>> for line in reader:
    ...     println(line)
    is a rose
    >>> reader.readLine() is None
    True
    """

    def __init__(self, text: str) -> None:
        self._lines = iter(lines_of(text))

    def readLine(self) -> str | None:
        """Return the next line without its end, or None after the last."""
        return next(self._lines, None)

    def close(self) -> None:
        """Do nothing: the file is closed already."""

    def __iter__(self) -> Iterator[str]:
        return self._lines

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        """Do nothing."""


class PrintWriter:
    """A text file that is being written; `createWriter()` makes it.

    The file is there after `flush()` or `close()`, and is never seen half written. `is_lost` says
    whether something was written since, `place` is the line of the sketch that made it.

    Examples
    --------
    >>> output = createWriter("places.txt")
    >>> output.println("10 20")
    >>> output.print("30 ")
    >>> output.println(40)
    >>> output.close()
    >>> loadStrings("places.txt")
    ['10 20', '30 40']
    """

    def __init__(self, filename: str) -> None:
        self.filename = filename
        self.is_lost = False
        self.place = calling_place()
        self._pieces: list[str] = []
        self._is_open = True

    @property
    def is_open(self) -> bool:
        """Whether more can be written."""
        return self._is_open

    def print(self, *values: object) -> None:
        """Write values with spaces between them."""
        self.write(" ".join(map(str, values)))

    def println(self, *values: object) -> None:
        """Write values with spaces between them, and end the line."""
        self.write(" ".join(map(str, values)) + "\n")

    def write(self, text: str) -> None:
        """Write a text."""
        if not self._is_open:
            raise SketchError(
                f"{self.filename} is closed.", hint="Write all of it before you call close()."
            )
        self._pieces.append(str(text))
        self.is_lost = True

    def flush(self) -> None:
        """Have the file hold all that was written so far."""
        save_text("createWriter", self.filename, "".join(self._pieces))
        self.is_lost = False

    def close(self) -> None:
        """Finish the file."""
        if self._is_open:
            self.flush()
        self._is_open = False

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, _: BaseException | None, __: TracebackType | None
    ) -> None:
        """Finish the file, unless something went wrong on the way."""
        if kind is None:
            self.close()


class OutputStream(io.BytesIO):
    """A file of bytes that is being written; `createOutput()` makes it.

    The file is there after `flush()` or `close()`, and is never seen half written. `is_lost` says
    whether something was written since, `place` is the line of the sketch that made it.

    Examples
    --------
    >>> output = createOutput("numbers.dat")
    >>> count = output.write(bytes([1, 2, 3]))
    >>> output.close()
    >>> list(loadBytes("numbers.dat"))
    [1, 2, 3]
    """

    def __init__(self, filename: str) -> None:
        super().__init__()
        self.filename = filename
        self.is_lost = False
        self.place = calling_place()

    @property
    def is_open(self) -> bool:
        """Whether more can be written."""
        return not self.closed

    def write(self, data: object, /) -> int:
        """Write bytes, a list of numbers from -128 to 255, or a single such number."""
        self.is_lost = True
        return super().write(bytes_of("write", [data] if isinstance(data, int) else data))

    def flush(self) -> None:
        """Have the file hold all that was written so far."""
        if not self.closed:
            save_bytes("createOutput", self.filename, self.getvalue())
            self.is_lost = False

    def close(self) -> None:
        """Finish the file."""
        self.flush()
        super().close()

    def __exit__(
        self, kind: type[BaseException] | None, _: BaseException | None, __: TracebackType | None
    ) -> None:
        """Finish the file, unless something went wrong on the way."""
        if kind is None:
            self.close()

    def __del__(self) -> None:
        """Lose what was not flushed, as Processing does; a file is written by being closed."""


def bytes_of(name: str, data: object) -> bytes:
    """Return bytes, or a list of numbers from -128 to 255, as bytes.

    Raises
    ------
    SketchError
        If it is none of these; `name` is the function's that it was given to.
    """
    if isinstance(data, bytes | bytearray | memoryview):
        return bytes(data)
    try:
        numbers = [int(number) for number in data] if isinstance(data, Iterable) else None
    except (TypeError, ValueError):
        numbers = None
    if numbers is None or not all(-128 <= number <= 255 for number in numbers):
        raise SketchError(f"{name}() takes bytes, or a list of numbers from -128 to 255.")
    return bytes(number & 0xFF for number in numbers)
