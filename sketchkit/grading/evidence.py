"""Evidence: what a submission's runs have shown, before anyone judges it.

It is made by sketchkit itself from what the sketch drew, call by call; the submission writes none
of it (see `sandbox` and `tape`). Checks look at this and at nothing else.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from sketchkit.grading.results import Status


@dataclass(frozen=True)
class Trace:
    """What one frame's draw lists show.

    Attributes
    ----------
    kinds : dict of str to int
        How often each kind was drawn: "rect", "ellipse", "box", "sphere", "line", "triangle",
        "quad", "point", "arc", "image", "shape" (beginShape), "mesh" (shape(), a retained part),
        "text". Kinds that were not drawn are not in it.
    nesting : int
        The deepest pushMatrix() within which something was drawn.
    lights : int
        The most lights that shone on one draw.
    retained : int
        Different retained shapes that were drawn.
    textures, canvases : int
        Different images, and `createGraphics()` canvases, that were drawn with, or on.
    shaders : dict of str to tuple of str
        Names of the sketch's own shaders in force, and of the uniforms it gave to each.
    draw_calls, vertices : int
    """

    kinds: dict[str, int] = field(default_factory=dict)
    nesting: int = 0
    lights: int = 0
    retained: int = 0
    textures: int = 0
    canvases: int = 0
    shaders: dict[str, tuple[str, ...]] = field(default_factory=dict)
    draw_calls: int = 0
    vertices: int = 0


@dataclass(frozen=True)
class SourceFacts:
    """What the syntax trees of a submission's Python files show.

    Attributes
    ----------
    calls : dict of str to int
        Names that are called and how often: "rect", and "pg.rect" as "rect" and as "pg.rect".
    functions, classes : tuple of str
        That are defined, methods as "Ball.update".
    names : tuple of str
        All that are read or assigned.
    statements : dict of str to int
        "for", "while", "if", "lambda", "import numpy", ...
    """

    calls: dict[str, int] = field(default_factory=dict)
    functions: tuple[str, ...] = ()
    classes: tuple[str, ...] = ()
    names: tuple[str, ...] = ()
    statements: dict[str, int] = field(default_factory=dict)


@dataclass(frozen=True)
class RunEvidence:
    """What one run of a sketch has shown: with one file of events, or none.

    Attributes
    ----------
    status : Status
    explanation : str
        Why it did not reach its end, in a sentence; "" if it did.
    frames : dict of int to Path
        Pictures by frameCount, PNG files made by the grader, absolute.
    traces : dict of int to Trace
    values : dict of str to tuple of float
        The watched names, frame by frame from frame 1; NaN where there was no number.
    remarks : tuple of str
    console : str
        The first of what it printed, standard output and errors.
    is_deterministic : bool or None
    seconds : float
        Processor time.
    variants : dict of str to dict of int to Path
        Of references alone: frames that were redrawn otherwise, by what was otherwise, to explain
        a difference in words ("lights off").
    """

    status: Status
    explanation: str = ""
    frames: dict[int, Path] = field(default_factory=dict)
    traces: dict[int, Trace] = field(default_factory=dict)
    values: dict[str, tuple[float, ...]] = field(default_factory=dict)
    remarks: tuple[str, ...] = ()
    console: str = ""
    is_deterministic: bool | None = None
    seconds: float = 0.0
    variants: dict[str, dict[int, Path]] = field(default_factory=dict)


@dataclass(frozen=True)
class Evidence:
    """All runs of a sketch, by the name of the events file ("" for the run without one)."""

    runs: dict[str, RunEvidence] = field(default_factory=dict)
    source: SourceFacts = field(default_factory=SourceFacts)
