"""An assignment as plain values; `load` reads it from its folder."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path


@dataclass(frozen=True)
class Limits:
    """What a submission's run may use.

    Attributes
    ----------
    cpu_s, wall_s : float, seconds
        Of the processor, and by the clock on the wall, which also holds what only sleeps.
    memory_mb, output_mb : int, megabytes
        Of memory, and of what is written: files and printed text together.
    """

    cpu_s: float = 20.0
    wall_s: float = 60.0
    memory_mb: int = 1024
    output_mb: int = 64


@dataclass(frozen=True)
class Check:
    """One thing that an assignment asks for.

    Attributes
    ----------
    name : str
        As students read it; unique.
    slug : str
        A file name that stands for it; unique.
    kind : str
        A key of `checks.kinds.KINDS`.
    points : float
        Marks possible; > 0.
    options : object
        What its kind reads from the file, of the kind's own class.
    frames : tuple of int
        Which it looks at, rising; empty for a kind that looks at none.
    events : str
        The file of mouse and keys that is replayed, relative to the assignment; "" for none.
    references : tuple of str
        Those that are accepted, relative to the assignment.
    expect : str
        The instructor's sentence on what is to be seen, told to whoever loses marks; or "".
    """

    name: str
    slug: str
    kind: str
    points: float
    options: object
    frames: tuple[int, ...] = ()
    events: str = ""
    references: tuple[str, ...] = ("reference",)
    expect: str = ""


@dataclass(frozen=True)
class Assignment:
    """What is asked for, and how it is judged.

    Attributes
    ----------
    folder : Path
        Where it lies.
    title : str
    renderer : str
        "cpu", the same on any machine, or "gl", for shaders.
    seed : int
        Where random() and noise() begin.
    limits : Limits
    checks : tuple of Check
    data : Path or None
        A folder whose files each sketch is given.
    digest : str
        Changes with anything that may change a result: the file, references, events, data.
    """

    folder: Path
    title: str
    renderer: str = "cpu"
    seed: int = 0
    limits: Limits = field(default_factory=Limits)
    checks: tuple[Check, ...] = ()
    data: Path | None = None
    digest: str = ""

    @property
    def references(self) -> tuple[str, ...]:
        """The names of all references, each once, in the order of the checks."""
        return tuple(dict.fromkeys(name for check in self.checks for name in check.references))

    @property
    def points(self) -> float:
        """Marks possible."""
        return sum(check.points for check in self.checks)
