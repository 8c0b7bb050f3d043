"""A run of a sketch: recorded beside its code, drawn anew without it; the evidence of both.

Nothing that the sketch's process says is taken for true but that it has drawn what its tape holds:
and that is drawn here, by another process.
"""

from __future__ import annotations

import contextlib
import hashlib
import io
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import cast

from PIL import Image

from sketchkit.assets.output import write_file
from sketchkit.grading.evidence import RunEvidence, SourceFacts, Trace
from sketchkit.grading.inside.orders import (
    EVENTS,
    LARGEST_SIDE,
    SUBMISSION,
    TAPE,
    RecordOrder,
    RedrawOrder,
    written,
)
from sketchkit.grading.results import Status, from_json
from sketchkit.grading.sandbox.job import Ending, Job, Limits
from sketchkit.grading.sandbox.level import Level
from sketchkit.grading.sandbox.run import run
from sketchkit.tape.messages import Message, TapeError, read_messages

RECORD = "sketchkit.grading.inside.record"
REDRAW = "sketchkit.grading.inside.redraw"
ASIDE = frozenset({"forget", "remark"})  # messages that say nothing of what is drawn
MOST_REMARKS = 50
MOST_FOUND = 8 << 20  # bytes of text at once: names in it are the submission's


@dataclass(frozen=True)
class Request:
    """What is to be found out about a sketch.

    Attributes
    ----------
    folder : Path
        With the sketch and all that belongs to it.
    sketch : str
        Its file, relative to the folder.
    renderer : str
    seed : int
    frames, traces : tuple of int
        Frames whose pictures, and whose traces, are wanted.
    varied : tuple of int
        Frames whose pictures are wanted in other ways of drawing as well.
    watched : tuple of str
        Values that are wanted, up to frame `last`.
    last : int
        The last frame that is run.
    events : Path or None
        What happens with mouse and keys.
    is_twice : bool
        Whether it is run twice, to see whether it draws the same.
    limits : Limits
    """

    folder: Path
    sketch: str
    renderer: str
    seed: int
    frames: tuple[int, ...]
    last: int
    traces: tuple[int, ...] = ()
    varied: tuple[int, ...] = ()
    watched: tuple[str, ...] = ()
    events: Path | None = None
    is_twice: bool = True
    limits: Limits = field(default_factory=Limits)


@dataclass
class Found:
    """What a redrawing has brought to light.

    Attributes
    ----------
    pictures : dict of (variant, frame) to bytes
        PNG files; the drawing itself is the variant "".
    """

    pictures: dict[tuple[str, int], bytes] = field(default_factory=dict)
    traces: dict[int, Trace] = field(default_factory=dict)
    values: dict[str, tuple[float, ...]] = field(default_factory=dict)
    remarks: list[str] = field(default_factory=list)
    source: SourceFacts = field(default_factory=SourceFacts)
    renderer: dict[str, str] = field(default_factory=dict)
    mistake: str = ""
    end: int | None = None
    damage: str = ""
    is_told: bool = False


@dataclass(frozen=True)
class Outcome:
    """A run, and what it says beyond itself.

    Attributes
    ----------
    evidence : RunEvidence
    source : SourceFacts
    renderer : dict of str to str
        What has drawn, in its own words.
    """

    evidence: RunEvidence
    source: SourceFacts
    renderer: dict[str, str]


def carry_out(request: Request, pictures: Path, workshop: Path, level: Level) -> Outcome:
    """Run a sketch behind the wall.

    Parameters
    ----------
    request : Request
    pictures : Path
        A folder for the pictures.
    workshop : Path
        A folder for what is needed meanwhile.
    level : Level
        The walls.

    Raises
    ------
    SandboxError
        If nothing can be run here.
    """
    tape = workshop / "tape"
    ending = _record(request, tape, level)
    found, drawn = _redraw(request, tape, workshop / "found", level)
    is_deterministic = None
    if request.is_twice and found.end is not None:
        again = workshop / "tape-again"
        _record(request, again, level)
        is_deterministic = _is_same(request, tape, again, found, level)
        again.unlink(missing_ok=True)
    tape.unlink(missing_ok=True)
    status, explanation = _verdict(ending, drawn, found)
    frames, variants = _keep(found.pictures, pictures)
    evidence = RunEvidence(
        status,
        explanation,
        frames=frames,
        variants=variants,
        traces=found.traces,
        values=found.values,
        remarks=tuple(dict.fromkeys(found.remarks)),
        console=ending.console,
        is_deterministic=is_deterministic,
        seconds=round(ending.cpu_s + drawn.cpu_s, 2),
    )
    return Outcome(evidence, found.source, found.renderer)


def _record(request: Request, tape: Path, level: Level) -> Ending:
    readable = {SUBMISSION: request.folder}
    if request.events is not None:
        readable[EVENTS] = request.events
    order = RecordOrder(
        request.sketch,
        request.last,
        request.renderer,
        request.seed,
        request.watched,
        request.events is not None,
    )
    return run(Job(RECORD, (written(order),), readable, tape, limits=request.limits), level)


def _redraw(request: Request, tape: Path, out: Path, level: Level) -> tuple[Found, Ending]:
    order = RedrawOrder(
        request.renderer,
        request.frames,
        request.traces,
        request.varied,
        request.watched,
        reads_source=True,
    )
    readable = {TAPE: tape, SUBMISSION: request.folder}
    ending = run(Job(REDRAW, (written(order),), readable, out, limits=request.limits), level)
    found = Found()
    with out.open("rb") as file, contextlib.suppress(TapeError):  # then nothing was told
        for message in read_messages(file, MOST_FOUND):
            _take(found, message)
    out.unlink()
    return found, ending


def _take(found: Found, message: Message) -> None:
    """Note what one message says."""
    value = cast("Mapping[str, object]", message.value)
    match message.kind:
        case "picture":
            frame = int(cast(int, value["frame"]))
            found.pictures[str(value["variant"]), frame] = message.body
        case "trace":
            found.traces[int(cast(int, value["frame"]))] = from_json(Trace, value["trace"])
        case "values":
            numbers = cast("dict[str, list[float]]", value)
            found.values = {name: tuple(column) for name, column in numbers.items()}
        case "remark" if len(found.remarks) < MOST_REMARKS:
            found.remarks.append(str(message.value))
        case "source":
            found.source = from_json(SourceFacts, value)
        case "renderer":
            found.renderer = {str(key): str(text) for key, text in value.items()}
        case "told":
            found.mistake, found.damage = str(value["mistake"]), str(value["damage"])
            found.end = cast("int | None", value["end"])
            found.is_told = True


def _is_same(request: Request, tape: Path, again: Path, found: Found, level: Level) -> bool:
    """Return whether two tapes draw the same; they are drawn only if they are not equal."""
    if digest(tape) == digest(again):
        return True
    other, _ = _redraw(request, again, again.with_suffix(".found"), level)
    return other.pictures == found.pictures and _texts(other.values) == _texts(found.values)


def _texts(values: Mapping[str, tuple[float, ...]]) -> str:
    return repr(values)  # NaN is unlike itself, but not its text


def digest(tape: Path) -> str:
    """Return what stands for all that a tape draws."""
    whole = hashlib.sha256()
    with tape.open("rb") as file:
        try:
            for message in read_messages(file):
                if message.kind not in ASIDE:
                    whole.update(bytes(message))
        except TapeError:
            whole.update(b"damaged")
    return whole.hexdigest()


def _verdict(ending: Ending, drawn: Ending, found: Found) -> tuple[Status, str]:
    """Return what became of a run, and why."""
    if ending.exceeded is not None:
        return Status.OVER_LIMIT, ending.sentence()
    if found.mistake:
        return Status.STOPPED, found.mistake
    if drawn.exceeded is not None:
        return Status.OVER_LIMIT, f"Drawing what it recorded took too much. {drawn.sentence()}"
    if not found.is_told:
        return Status.CRASHED, f"What it recorded could not be drawn. {drawn.sentence()}".strip()
    if found.damage:
        return Status.CRASHED, found.damage
    if found.end is None:
        how = ending.sentence() or "Its process ended by itself."
        return Status.CRASHED, f"It did not come to its end. {how}"
    return Status.GRADED, ""


def _keep(
    found: Mapping[tuple[str, int], bytes], folder: Path
) -> tuple[dict[int, Path], dict[str, dict[int, Path]]]:
    """Write pictures to a folder; return those of the drawing itself, and of its variants."""
    frames: dict[int, Path] = {}
    variants: dict[str, dict[int, Path]] = {}
    for (variant, frame), data in _proper(found):
        place = frames if not variant else variants.setdefault(variant, {})
        name = f"{variant.replace(' ', '-')}-" if variant else ""
        path = folder / f"{name}frame-{frame:04}.png"
        write_file(path, data)
        place[frame] = path
    return frames, variants


def _proper(
    found: Mapping[tuple[str, int], bytes],
) -> Iterator[tuple[tuple[str, int], bytes]]:
    """Yield what are pictures of a possible size; the size is looked at before they are read."""
    for key, data in sorted(found.items()):
        try:
            with Image.open(io.BytesIO(data), formats=["PNG"]) as picture:
                if max(picture.size) <= LARGEST_SIDE:
                    yield key, data
        except (OSError, ValueError, SyntaxError):  # Pillow raises the last one for broken PNGs
            continue
