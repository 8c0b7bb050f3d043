"""Files that a sketch reads and writes, beside itself and in its `data` folder."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path

from sketchkit.api._sketch_parts import SketchParts
from sketchkit.api.data.saving import save_text
from sketchkit.api.data.sources import read_text
from sketchkit.api.data.streams import BufferedReader
from sketchkit.assets.output import picture_bytes, write_file
from sketchkit.data.text_files import lines_of


class Files(SketchParts):
    """`loadStrings()`, `saveFrame()` and the like. Names without a folder mean the sketch's own."""

    def loadStrings(self, filename: str | BufferedReader) -> list[str]:
        """Read a text file, as a list of its lines.

        Parameters
        ----------
        filename : str
            Looked for in the sketch's `data` folder, then beside the sketch. Also an address,
            "https://...", where a window is shown.

        Raises
        ------
        SketchError
            If there is no such file, or no network.

        See Also
        --------
        saveStrings, createReader, loadTable

        Notes
        -----
        What is not UTF-8 is read as Latin-1, and remarked on.

        Examples
        --------
        >>> for line in loadStrings("poem.txt"):
        ...     println(line)
        """
        if isinstance(filename, BufferedReader):
            return list(filename)
        return lines_of(read_text("loadStrings", filename))

    def saveStrings(self, filename: str, data: Iterable[object]) -> None:
        """Write a text file, one line for each item of a list.

        Parameters
        ----------
        filename : str
            Written beside the sketch; folders that are missing are made.
        data : list
            What is no text is written as `str()` gives it.

        See Also
        --------
        loadStrings

        Examples
        --------
        >>> saveStrings("scores.txt", ["anna 12", "ben 9"])
        """
        lines = [data] if isinstance(data, str) else data
        save_text("saveStrings", filename, "".join(f"{line}\n" for line in lines))

    def sketchPath(self, where: str = "") -> str:
        """Return the sketch's folder, or the full path of a file in it.

        Examples
        --------
        >>> println(sketchPath("notes.txt"))
        """
        return str(self.folder / where)

    def dataPath(self, where: str = "") -> str:
        """Return the sketch's `data` folder, or the full path of a file in it.

        Examples
        --------
        >>> println(dataPath("cat.png"))
        """
        return str(self.folder / "data" / where)

    def save(self, filename: str) -> None:
        """Write what has been drawn so far as a picture.

        Parameters
        ----------
        filename : str
            Written beside the sketch. Its ending says the kind: `.png`, `.jpg`, `.tif`, ...;
            without an ending it is a `.tif`.

        Raises
        ------
        SketchError
            If the ending is none of a picture.

        See Also
        --------
        saveFrame

        Examples
        --------
        >>> save("result.png")
        """
        path = Path(self.sketchPath(str(filename)))
        if not path.suffix:
            path = path.with_suffix(".tif")
        write_file(path, picture_bytes(self.canvas.image_data()[:, :, :3], path.suffix))

    def saveFrame(self, filename: str = "screen-####.tif") -> None:
        """Write what has been drawn so far as a picture, with the frame's number in its name.

        Parameters
        ----------
        filename : str
            From the first `#` to the last becomes `frameCount`, with zeros in front: `####` is
            0001 at first. A single `#` stays as it is. Without an ending it is a `.tif`.

        See Also
        --------
        save

        Examples
        --------
        >>> saveFrame("frames/spin-####.png")
        """
        self.save(numbered(str(filename), self.progress.frame_count))


def numbered(filename: str, frame: int) -> str:
    """Return a file name in which the frame's number stands from the first `#` to the last one.

    A single one stays, as in Processing.

    Examples
    --------
    >>> numbered("spin-####.png", 7)
    'spin-0007.png'
    """
    return re.sub("#.*#", lambda run: f"{frame:0{len(run.group())}}", filename, count=1)
