"""What went wrong, in a few lines: the student's file and line, the line itself, one sentence.

Python's traceback goes on into sketchkit; a student needs the innermost line of her own. Which
lines are hers is known exactly: they are the code whose names are the sketch's names.
"""

from __future__ import annotations

import itertools
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from types import FrameType, TracebackType
from typing import NamedTuple

from sketchkit.core.errors import SketchError
from sketchkit.core.notices import PACKAGE
from sketchkit.runtime.checks import EarlyError
from sketchkit.runtime.loader import Program
from sketchkit.runtime.mistakes.explain import explain
from sketchkit.runtime.mistakes.mistake import Mistake
from sketchkit.runtime.mistakes.syntax import explain_syntax
from sketchkit.runtime.source import Position, Source

CALLS_SHOWN = 3


@dataclass(frozen=True)
class Report:
    """A mistake as it is told to the student.

    Attributes
    ----------
    message : str
        What was wrong; in further, indented lines what was received and what to write.
    path : Path
        Her file.
    line : int
        From 1; 0 if it is none in particular.
    source_line : str
        The line itself.
    columns : (first, end), from 0
        The part of the line that is meant; equal if it is the whole line.
    calls : tuple of str
        Where the function that failed was called from, innermost first.
    traceback : str
        All that Python says.
    """

    message: str
    path: Path
    line: int = 0
    source_line: str = ""
    columns: tuple[int, int] = (0, 0)
    calls: tuple[str, ...] = ()
    traceback: str = ""

    @property
    def place(self) -> str:
        """File and line: `spinning.py, line 14`."""
        return f"{self.path.name}, line {self.line}" if self.line else self.path.name

    def __str__(self) -> str:
        parts = [f"{self.place}: {self.message}"]
        if self.source_line.strip():
            parts += ["", *self._excerpt()]
        if self.calls:
            parts += ["", *(f"    {call}" for call in self.calls)]
        return "\n".join(parts)

    def _excerpt(self) -> list[str]:
        text = self.source_line.rstrip().expandtabs(1)
        indent = len(text) - len(text.lstrip())
        first, end = self.columns
        margin = f"{self.line:>6} | "
        lines = [margin + text.lstrip()]
        if first < end:
            marks = " " * (first - indent) + "^" * (end - first)
            lines.append(" " * (len(margin) - 2) + "| " + marks)
        return lines


class StoppedError(Exception):
    """A sketch has stopped by a mistake.

    Attributes
    ----------
    report : Report
        What to tell its author.
    """

    def __init__(self, report: Report) -> None:
        super().__init__(str(report))
        self.report = report

    def _render_traceback_(self) -> list[str]:
        """Return what IPython shows of it: the message, without ways through sketchkit."""
        return str(self).splitlines()


@contextmanager
def reporting(path: Path, program: Program | None = None) -> Iterator[None]:
    """Make what a sketch raises in this block into `StoppedError`.

    Parameters
    ----------
    path : Path
        The sketch's file.
    program : Program, optional
        The sketch, when it runs already.

    Raises
    ------
    StoppedError
        For every mistake, and when the user stops it by Ctrl+C.
    """
    try:
        yield
    except (Exception, KeyboardInterrupt) as error:
        raise StoppedError(report_of(error, path, program)) from error


def report_of(error: BaseException, path: Path, program: Program | None = None) -> Report:
    """Return what to tell about an error.

    Parameters
    ----------
    error : BaseException
        As it was caught.
    path : Path
        The sketch's file.
    program : Program, optional
        The sketch that raised it.
    """
    trace = "".join(traceback.format_exception(error))
    if isinstance(error, SyntaxError):
        return _syntax_report(error, path, trace)
    if isinstance(error, EarlyError):
        text = Source(error.path, error.path.read_bytes()).line(error.line)
        return Report(error.message, error.path, error.line, text, traceback=trace)
    steps = list(_steps(error.__traceback__, program)) if program else []
    if program is None or not steps:
        return Report(_without_place(error), path, traceback=trace)
    last = steps[-1]
    source = program.sources[last.frame.f_code.co_filename]
    expression = source.expression_at(last.position)
    is_inside = _is_inside_sketchkit(error.__traceback__)
    mistake = Mistake(error, last.frame, expression, program.names, source, is_inside)
    return Report(
        explain(mistake),
        source.path,
        last.line,
        source.line(last.line),
        source.columns(last.position),
        tuple(_calls(steps)),
        trace,
    )


class Step(NamedTuple):
    """A line of the sketch that was being run when the error came."""

    frame: FrameType
    line: int
    position: Position | None


def _without_place(error: BaseException) -> str:
    """Return the message of an error that no line of the sketch has called forth."""
    message = explain(Mistake(error))
    if isinstance(error, SketchError | OSError | KeyboardInterrupt):
        return message
    return f"sketchkit itself has failed; this is not your mistake.\n    {message}"


def _steps(trace: TracebackType | None, program: Program) -> Iterator[Step]:
    """Yield the sketch's own lines, innermost last."""
    while trace is not None:
        frame = trace.tb_frame
        if frame.f_builtins is program.names and frame.f_code.co_filename in program.sources:
            yield Step(frame, trace.tb_lineno, _position(frame, trace.tb_lasti))
        trace = trace.tb_next


def _is_inside_sketchkit(trace: TracebackType | None) -> bool:
    """Tell whether a function of sketchkit raised it; what only stands before one is none."""
    frames = [frame for frame, _ in traceback.walk_tb(trace)]
    while frames and "__tracebackhide__" in frames[-1].f_code.co_varnames:
        frames.pop()
    return bool(frames) and frames[-1].f_code.co_filename.startswith(PACKAGE)


def _position(frame: FrameType, instruction: int) -> Position | None:
    parts = next(itertools.islice(frame.f_code.co_positions(), instruction // 2, None))
    line, end_line, column, end_column = parts
    if line is None or end_line is None or column is None or end_column is None:
        return None
    return Position(line, end_line, column, end_column)


def _calls(steps: list[Step]) -> Iterator[str]:
    """Yield where each function was called from, innermost first."""
    calls = [
        f"{called.frame.f_code.co_name}() was called at "
        f"{Path(caller.frame.f_code.co_filename).name}, line {caller.line}"
        for caller, called in itertools.pairwise(steps)
        if not called.frame.f_code.co_name.startswith("<")
    ]
    groups = [(call, len(list(same))) for call, same in itertools.groupby(reversed(calls))]
    for call, count in groups[:CALLS_SHOWN]:
        yield f"{call}, {count} times" if count > 1 else call


def _syntax_report(error: SyntaxError, path: Path, trace: str) -> Report:
    file = Path(error.filename) if error.filename else path
    return Report(
        explain_syntax(error),
        file,
        error.lineno or 0,
        error.text or "",
        _syntax_columns(error),
        traceback=trace,
    )


def _syntax_columns(error: SyntaxError) -> tuple[int, int]:
    if isinstance(error, IndentationError) or not error.offset:
        return 0, 0
    first = error.offset - 1
    is_one_line = error.end_lineno in (None, error.lineno)
    end = error.end_offset - 1 if is_one_line and error.end_offset else first
    return first, max(end, first + 1)
