"""Nothing drew: a picture of one colour, though shapes were drawn, and what the matter is."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from sketchkit.draw.recorder import WHOLE, Kind
from sketchkit.draw.vertex import U8
from sketchkit.imaging.flatness import ALIKE, is_flat
from sketchkit.runtime.explore.calls import Site, sites
from sketchkit.runtime.explore.cases import Case
from sketchkit.runtime.explore.describe import Surroundings, chain_of
from sketchkit.runtime.explore.log import FrameLog
from sketchkit.runtime.explore.noting import Chain
from sketchkit.runtime.explore.reasons import Verdict, reason_of

MOST_CALLS = 12  # that are looked at
MOST_TOLD = 3
MANY_ROWS = (Kind.LETTER, Kind.MESH)  # of a single call


@dataclass(frozen=True)
class Remark:
    """What to tell.

    Attributes
    ----------
    path : Path
        The file of the call that it is about.
    line : int
    text : str
        In further, indented lines the reasons.
    """

    path: Path
    line: int
    text: str


@dataclass(frozen=True)
class Unseen:
    """A call that does not show.

    Attributes
    ----------
    count : int
        How many times it was called in this way.
    """

    chain: Chain
    site: Site
    count: int
    reason: str


def remark_on(log: FrameLog, around: Surroundings, pixels: U8, frame: int) -> Remark | None:
    """Return what to tell about a picture, or None: it has more colours, or is meant to be so.

    Parameters
    ----------
    log : FrameLog
        What was drawn in the frame, and in `setup()`.
    pixels : (h, w, 3 or 4) uint8
        The picture.
    """
    if not is_flat(pixels):
        return None
    try:
        return _remark(log, around, pixels, frame)
    except Exception:  # whatever it may be: no remark is worth a sketch that stops
        return None


def _remark(log: FrameLog, around: Surroundings, pixels: U8, frame: int) -> Remark | None:
    red, green, blue = (int(channel) for channel in pixels[0, 0, :3])
    groups = _groups(log, around, frame) or _groups(log, around, 0)
    unseen = _unseen(groups, around, (red, green, blue))
    if unseen is None:
        return None
    unseen += _void(log, around)
    if not unseen:
        return None
    first, *others = unseen
    again = {1: "", 2: ", nor does the other one of this line"}.get(
        first.count, f", nor do the {first.count - 1} others of this line"
    )
    lines = [
        f"{first.site.text} does not show{again}: "
        f"the whole picture is one colour, {red}, {green}, {blue}.",
        f"    {first.reason}",
    ]
    for other in others[: MOST_TOLD - 1]:
        lines.append(f"    Nor does line {other.site.line}, {other.site.text}. {other.reason}")
    if len(others) > MOST_TOLD - 1:
        lines.append(f"    Nor do {len(others) - MOST_TOLD + 1} calls in other lines.")
    path = Path(first.chain[0].code.co_filename)
    return Remark(path, first.site.line, "\n".join(lines))


def _groups(log: FrameLog, around: Surroundings, frame: int) -> dict[Chain, tuple[Case, int]]:
    """Return the calls of a frame that have drawn something: their first row, and how many."""
    groups: dict[Chain, tuple[Case, int]] = {}
    for serial, step in log.steps.items():
        if step.frame != frame or step.records is None:
            continue
        kinds = step.records.table["kind"]
        for row in np.flatnonzero(~np.isin(kinds, WHOLE)).tolist():
            chain = step.records.call(row)
            case, count = groups.get(chain, (Case(log, around, serial, row), 0))
            is_another = not count or kinds[row] not in MANY_ROWS
            groups[chain] = case, count + is_another
    return groups


def _unseen(
    groups: dict[Chain, tuple[Case, int]], around: Surroundings, color: tuple[int, int, int]
) -> list[Unseen] | None:
    """Return the calls that do not show, without those that hide the others.

    None, and not even an empty list, if something should show in another colour than the picture
    has: then nothing is drawn at all, as when a sketch is traced, and nothing can be said.
    """
    found, culprits = [], set()
    for chain, (case, count) in list(groups.items())[:MOST_CALLS]:
        reason = reason_of(case)
        if reason.color and np.abs(np.subtract(reason.color[:3], color)).max() > 2 * ALIKE:
            return None
        if reason.verdict is Verdict.HIDDEN and chain:
            found.append(Unseen(chain, sites(chain, around.texts)[0], count, reason.text))
            if reason.culprit is not None:
                culprits.add(chain_of(case.log, reason.culprit))
    return [unseen for unseen in found if unseen.chain not in culprits]


def _void(log: FrameLog, around: Surroundings) -> list[Unseen]:
    """Return the calls that have drawn nothing at all; none if a hand may yet fill them."""
    if log.notes is None or around.waits:
        return []
    return [
        Unseen(chain, sites(chain, around.texts)[0], 1, reason)
        for chain, reason in log.notes.void_calls.items()
        if chain
    ]
