"""Files as bytes, and files read or written piece by piece."""

from __future__ import annotations

import io
from collections.abc import Iterable
from typing import TypeVar

from sketchkit.api._sketch_parts import SketchParts
from sketchkit.api.data.saving import save_bytes
from sketchkit.api.data.sources import read_bytes, read_text
from sketchkit.api.data.streams import BufferedReader, OutputStream, PrintWriter, bytes_of
from sketchkit.core.notices import warn_once

File = TypeVar("File", PrintWriter, OutputStream)


class ByteFiles(SketchParts):
    """`loadBytes()`, `createWriter()` and the like. Names without a folder mean the sketch's."""

    def loadBytes(self, filename: str) -> bytearray:
        """Read a file of any kind.

        Parameters
        ----------
        filename : str
            Looked for in the sketch's `data` folder, then beside the sketch. Also an address,
            "https://...", where a window is shown.

        Returns
        -------
        bytearray
            Numbers from 0 to 255; Processing's are from -128 to 127, and `b & 0xff` makes these
            of them.

        See Also
        --------
        saveBytes, loadStrings

        Examples
        --------
        >>> list(loadBytes("poem.txt"))[:3]
        [65, 32, 114]
        """
        return bytearray(read_bytes("loadBytes", filename))

    def saveBytes(self, filename: str, data: bytes | Iterable[int]) -> None:
        """Write a file of any kind.

        Parameters
        ----------
        filename : str
            Written beside the sketch; folders that are missing are made.
        data : bytes, or list of int
            Numbers from -128 to 255.

        See Also
        --------
        loadBytes, saveStrings

        Examples
        --------
        >>> saveBytes("numbers.dat", [1, 2, 255])
        """
        save_bytes("saveBytes", filename, bytes_of("saveBytes", data))

    def saveStream(self, target: str, source: str | io.IOBase) -> bool:
        """Copy a file, or what an address holds.

        Parameters
        ----------
        target : str
            Written beside the sketch.
        source : str
            As for `loadBytes()`; or what `createInput()` has returned.

        See Also
        --------
        loadBytes, saveBytes

        Examples
        --------
        >>> saveStream("copy.txt", "poem.txt")
        True
        """
        data = source.read() if isinstance(source, io.IOBase) else read_bytes("saveStream", source)
        save_bytes("saveStream", target, bytes_of("saveStream", data))
        return True

    def createInput(self, filename: str) -> io.BytesIO:
        """Open a file of any kind, to read it piece by piece.

        Parameters
        ----------
        filename : str
            As for `loadBytes()`.

        Returns
        -------
        file
            As Python's own: `read(10)` gives up to ten bytes, `read()` all that are left.

        See Also
        --------
        createReader, createOutput

        Examples
        --------
        >>> createInput("poem.txt").read(6)
        b'A rose'
        """
        return io.BytesIO(read_bytes("createInput", filename))

    def createOutput(self, filename: str) -> OutputStream:
        """Begin a file of any kind, to write it piece by piece.

        Parameters
        ----------
        filename : str
            Written beside the sketch, when it is closed.

        See Also
        --------
        createWriter, createInput

        Examples
        --------
        >>> with createOutput("numbers.dat") as output:
        ...     count = output.write(bytes([1, 2, 3]))
        """
        return self._kept(OutputStream(filename))

    def createReader(self, filename: str) -> BufferedReader:
        """Open a text file, to read it line by line.

        Parameters
        ----------
        filename : str
            As for `loadBytes()`.

        See Also
        --------
        loadStrings, createWriter

        Examples
        --------
        >>> reader = createReader("poem.txt")
        >>> reader.readLine()
        'A rose'
        """
        return BufferedReader(read_text("createReader", filename))

    def createWriter(self, filename: str) -> PrintWriter:
        """Begin a text file, to write it piece by piece.

        Parameters
        ----------
        filename : str
            Written beside the sketch, when it is closed or flushed.

        See Also
        --------
        saveStrings, createReader

        Examples
        --------
        >>> output = createWriter("places.txt")
        >>> output.println("10 20")
        >>> output.close()
        """
        return self._kept(PrintWriter(filename))

    def remark_on_lost_files(self) -> None:
        """Say which files were begun, and neither closed nor flushed: the sketch is at its end."""
        for file in self._begun_files:
            if file.is_lost:
                warn_once(
                    f"{file.filename} is not written in full: close() it at the end.", file.place
                )

    def _kept(self, file: File) -> File:
        self._begun_files = [*(begun for begun in self._begun_files if begun.is_open), file]
        return file
