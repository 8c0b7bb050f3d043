"""Drawing into SVG and PDF files, besides the canvas."""

from __future__ import annotations

from sketchkit.api._sketch_parts import Recording, SketchParts
from sketchkit.api.files import numbered
from sketchkit.api.page_files import SHAPES, TRIANGLES, begin_recording, write_recording
from sketchkit.core.errors import SketchError


class Records(SketchParts):
    """What is drawn between a `begin` and its `end` goes into a file as well."""

    def beginRecord(self, renderer: str, filename: str) -> None:
        """Draw into a file as well, as shapes, until `endRecord()`.

        Parameters
        ----------
        renderer : SVG or PDF
            The kind of file.
        filename : str
            Written beside the sketch. `##` become `frameCount`: `"page-####.svg"` is a file for
            each frame.

        Raises
        ------
        SketchError
            If the kind is unknown, or a file is being recorded already.

        See Also
        --------
        endRecord, beginRaw, save

        Notes
        -----
        The file has the shapes themselves: they can be enlarged, changed in a drawing program,
        plotted and cut. Text becomes outlines, an image stays one. Colours and styles are those of
        the canvas, also if they were set before. Where vertices have colours of their own, a face
        has their mean. Source: Processing's reference, beginRecord().

        Examples
        --------
        >>> beginRecord(SVG, "circles.svg")
        >>> background(255)
        >>> for i in range(4):
        ...     circle(20 + 20 * i, 50, 10 + 10 * i)
        >>> endRecord()
        """
        self._begin_file("beginRecord", renderer, filename, SHAPES)

    def endRecord(self) -> None:
        """Write the file of `beginRecord()`; without it, that is done when the sketch ends.

        Raises
        ------
        SketchError
            If none is being recorded, or the file cannot be written.

        Examples
        --------
        >>> beginRecord(PDF, "cross.pdf")
        >>> line(20, 20, 80, 80)
        >>> line(80, 20, 20, 80)
        >>> endRecord()
        """
        self._end_file("beginRecord", "endRecord")

    def beginRaw(self, renderer: str, filename: str) -> None:
        """Draw into a file as well, as the triangles and lines on the screen, until `endRaw()`.

        Parameters
        ----------
        renderer : SVG or PDF
            The kind of file.
        filename : str
            Written beside the sketch. `##` become `frameCount`.

        Raises
        ------
        SketchError
            If the kind is unknown, or a file is being recorded already.

        See Also
        --------
        endRaw, beginRecord

        Notes
        -----
        It is meant for P3D: what is far comes first, so that what is near covers it. Where things
        pass through each other, no order is right. Light does not show: a face has the colour of
        its fill. Source: Processing's reference, beginRaw().

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> beginRaw(SVG, "box.svg")
        >>> translate(50, 50)
        >>> rotateY(0.6)
        >>> box(40)
        >>> endRaw()
        """
        self._begin_file("beginRaw", renderer, filename, TRIANGLES)

    def endRaw(self) -> None:
        """Write the file of `beginRaw()`; without it, that is done when the sketch ends.

        Raises
        ------
        SketchError
            If none is being recorded, or the file cannot be written.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> beginRaw(PDF, "ball-####.pdf")
        >>> translate(50, 50)
        >>> sphereDetail(8)
        >>> sphere(30)
        >>> endRaw()
        """
        self._end_file("beginRaw", "endRaw")

    def _begin_file(self, caller: str, renderer: object, filename: object, reader: str) -> None:
        if caller in self._recordings:
            end = caller.replace("begin", "end")
            raise SketchError(
                f"{caller}() while {self._recordings[caller].filename} is being recorded.",
                hint=f"Write {end}() before the next {caller}().",
            )
        name = filename
        if isinstance(filename, str):
            name = numbered(filename, self.progress.frame_count)
        self._recordings[caller] = begin_recording(self.canvas, renderer, name, reader)

    def _end_file(self, beginner: str, caller: str) -> None:
        recording = self._recordings.pop(beginner, None)
        if recording is None:
            raise SketchError(
                f"{caller}() without {beginner}().",
                hint=f'Write {beginner}(SVG, "drawing.svg") before what is to be in the file.',
            )
        self._finish(recording)

    def _finish(self, recording: Recording) -> None:
        self.canvas.end_reading(recording.reader)
        write_recording(recording, self.folder)

    def write_files(self) -> None:
        """Write the files that are still open, `size()`'s among them: the sketch is at its end."""
        for name in list(self._recordings):
            self._finish(self._recordings.pop(name))
