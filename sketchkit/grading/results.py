"""What grading finds out, as plain data: reports are written from it, and `--resume` reads it back.

Everything here can be written as JSON and read again; `to_json` and `from_json` do both. No times
are among it: a batch that is taken up again gives the results of one that was not disturbed.
"""

from __future__ import annotations

import dataclasses
import math
import types
import typing
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from enum import Enum
from pathlib import Path
from typing import TypeVar, get_type_hints

T = TypeVar("T")


class Status(Enum):
    """What became of a submission."""

    GRADED = "graded"  # it ran to the end
    STOPPED = "stopped by a mistake"  # of its own: its frames before that are judged
    CRASHED = "crashed"  # its process ended by itself, or by a signal
    OVER_LIMIT = "over a limit"  # of time, memory or output
    REFUSED = "refused"  # it could not be run: no sketch, a broken archive
    FAILED = "could not be judged"  # the grader's fault, not the student's


@dataclass(frozen=True)
class Comparison:
    """Two pictures that were held beside each other.

    Attributes
    ----------
    label : str
        Which: "frame 30".
    submitted, expected, difference : Path or None
        PNG files, relative to the folder of results; `difference` is the heat map.
    flip_mean, flip_high : float
        FLIP's mean and its high percentile, 0 (equal) to 1.
    region : int
        Pixels of the largest connected region that differs.
    is_alike : bool
    reason : str
        In words; "" if they are alike.
    """

    label: str
    submitted: Path | None = None
    expected: Path | None = None
    difference: Path | None = None
    flip_mean: float = 0.0
    flip_high: float = 0.0
    region: int = 0
    is_alike: bool = True
    reason: str = ""


@dataclass(frozen=True)
class Curve:
    """Numbers over frames: a trajectory, and the band that it should stay within.

    Attributes
    ----------
    name : str
        Of the value, as the sketch calls it.
    frames, values, low, high : tuple of numbers, of one length
        `values` has NaN where the sketch had no such number.
    """

    name: str
    frames: tuple[int, ...]
    values: tuple[float, ...]
    low: tuple[float, ...]
    high: tuple[float, ...]


@dataclass(frozen=True)
class CheckResult:
    """How a submission did in one check.

    Attributes
    ----------
    name, kind : str
        As the assignment has them.
    score : float
        0 to 1, by the check's curve of marks.
    points, out_of : float
        Marks: earned, and possible.
    reasons : tuple of str
        Whole sentences, for the student.
    comparisons : tuple of Comparison
    curves : tuple of Curve
    """

    name: str
    kind: str
    score: float
    points: float
    out_of: float
    reasons: tuple[str, ...] = ()
    comparisons: tuple[Comparison, ...] = ()
    curves: tuple[Curve, ...] = ()


@dataclass(frozen=True)
class StudentResult:
    """All that is known about a submission.

    Attributes
    ----------
    name : str
        As it was handed in: spaces, Unicode and length kept.
    slug : str
        A file name that stands for it, of ASCII letters, digits, `-`, `_` and `.`; unique.
    status : Status
    explanation : str
        What became of it, in a sentence; "" if it was graded without incident.
    checks : tuple of CheckResult
    console : str
        What it printed, cut off at a length; untrusted text.
    remarks : tuple of str
        What sketchkit told its author.
    is_deterministic : bool or None
        Whether two runs drew the same; None if that was not tried.
    thumbnail : Path or None
        A picture of it, relative to the folder of results.
    sandbox : str
        The level it ran at, in words.
    """

    name: str
    slug: str
    status: Status
    explanation: str = ""
    checks: tuple[CheckResult, ...] = ()
    console: str = ""
    remarks: tuple[str, ...] = ()
    is_deterministic: bool | None = None
    thumbnail: Path | None = None
    sandbox: str = ""

    @property
    def points(self) -> float:
        """Marks earned."""
        return sum(check.points for check in self.checks)

    @property
    def out_of(self) -> float:
        """Marks possible."""
        return sum(check.out_of for check in self.checks)


@dataclass(frozen=True)
class ClassResult:
    """A class's results.

    Attributes
    ----------
    title : str
        The assignment's.
    students : tuple of StudentResult
        In the order of their names.
    record : dict of str to str
        What it was made with: sketchkit, Python, renderer, driver, seed, sandbox, date.
    """

    title: str
    students: tuple[StudentResult, ...]
    record: dict[str, str] = field(default_factory=dict)


def to_json(value: object) -> object:
    """Return a result as dictionaries, lists, texts and numbers.

    JSON has no NaN and no infinities: they are written as texts, "nan" and "inf", which
    `from_json` takes for numbers again.
    """
    match value:
        case Enum():
            return value.value
        case Path():
            return value.as_posix()
        case float() if not math.isfinite(value):
            return str(value)
        case tuple() | list():
            return [to_json(item) for item in value]
        case Mapping():
            return {str(key): to_json(item) for key, item in value.items()}
        case _ if dataclasses.is_dataclass(value) and not isinstance(value, type):
            fields = dataclasses.fields(value)
            return {field.name: to_json(getattr(value, field.name)) for field in fields}
        case _:
            return value


def from_json(kind: type[T], content: object) -> T:
    """Return a dataclass from what `to_json` made of it.

    Raises
    ------
    KeyError, TypeError, ValueError
        If the content is something else.
    """
    if not isinstance(content, Mapping):
        raise TypeError(f"a {kind.__name__} is written as a dictionary")
    hints = get_type_hints(kind)
    return kind(**{name: _read(hint, content[name]) for name, hint in hints.items()})


def _read(hint: object, content: object) -> object:
    origin, arguments = typing.get_origin(hint), typing.get_args(hint)
    if origin is types.UnionType:
        is_none = content is None and type(None) in arguments
        return None if is_none else _read(arguments[0], content)
    if origin is tuple:
        return tuple(_read(arguments[0], item) for item in typing.cast(Iterable[object], content))
    if origin is dict:
        entries = typing.cast(Mapping[str, object], content).items()
        return {_read(arguments[0], key): _read(arguments[1], item) for key, item in entries}
    assert isinstance(hint, type)
    if dataclasses.is_dataclass(hint):
        return from_json(hint, content)
    return content if isinstance(content, hint) else hint(content)
