"""A class as grading might find it: eighteen submissions, with pictures, some of them hostile."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw

from sketchkit.grading.results import (
    CheckResult,
    ClassResult,
    Comparison,
    Curve,
    Status,
    StudentResult,
)

TITLE = "Bouncing ball"
RECORD = {
    "sketchkit": "1.0",
    "Python": "3.11.9",
    "renderer": "cpu",
    "NumPy": "2.1.0",
    "seed": "42",
    "sandbox": "bubblewrap: no network, no files but its own",
    "date": "2026-05-04T10:30:00+00:00",
}
SANDBOX = "bubblewrap: no network, no files but its own"
SIZE = (320, 240)
FRAMES = (1, 30)

# Each runs, or loads something, where it is not escaped.
SCRIPT = "<script>document.title='PWNED'</script>"
HOSTILE = (
    SCRIPT,
    "</script></style></title></textarea><img src=x onerror=\"document.title='PWNED'\">",
    '"><svg onload="document.title=\'PWNED\'">',
    "' onmouseover='document.title=1' x='",
    "{{ 7 * 7 }}{% raw %}",
    "javascript:document.title='PWNED'",
    '=HYPERLINK("http://example.invalid/?"&A1,"click")',
    "@SUM(1+1)*cmd|' /C calc'!A0",
    "\t=1+1",
    "\x1b]0;title\x07\x1b[31mred\x1b[0m",
    "\u202egnp.exe\u2066",
    "nul\x00 bell\x07 del\x7f c1\x9b lone\udc80\ud800 not\ufffe\uffff",
    "]]><!-- &lt; &amp;amp; --> &",
    "a,b;c\"d'e\r\nf\ng\rh",
)


@dataclass(frozen=True)
class Look:
    """How a submission draws: what it got wrong."""

    sky: str = "#9cd3f0"
    ball: str = "#d8452e"
    radius: int = 28
    shift: int = 0
    has_ground: bool = True


LOOKS = {
    "Ada Brook": Look(),
    "Björk Jónsdóttir": Look(),
    "Chen Wei 陈伟": Look(radius=27),
    "Dara O'Neill": Look(shift=9),
    "Elif Şahin": Look(),
    "Fatima al-Zahra فاطمة الزهراء": Look(ball="#c8452e"),
    "Goran Nikolić": Look(),
    "Hana Kim": Look(has_ground=False),
    "Ines de la Cruz y Fernández-Villaverde del Prado": Look(),
    "Jonas Weber": Look(sky="#ffffff"),
    "Kofi Mensah": Look(),
    "Lena Virtanen": Look(),
    "Mohammed Aziz": Look(),
    "Nora Lind": Look(sky="#10131c", ball="#3050ff", radius=60, shift=70),
}


def make_class(folder: Path) -> ClassResult:
    """Draw a class's pictures into a folder of results, and return the results."""
    graded = [
        _graded(folder, name, look, number) for number, (name, look) in enumerate(LOOKS.items(), 1)
    ]
    by_name = {student.name: student for student in (*graded, *_unlucky(folder, len(graded)))}
    by_name["Kofi Mensah"] = replace(by_name["Kofi Mensah"], is_deterministic=False)
    return ClassResult(TITLE, tuple(by_name[name] for name in sorted(by_name)), RECORD)


def hostile_student(text: str, slug: str = "hostile") -> StudentResult:
    """Return a result with a text in every field that can hold one."""
    comparison = Comparison(text, None, None, None, 0.5, 0.9, 9, False, text)
    curve = Curve(text, (1, 2, 3), (0.0, math.nan, 9.0), (0.0,) * 3, (1.0,) * 3)
    check = CheckResult(text, text, 0.5, 1.0, 2.0, (text, text), (comparison,), (curve,))
    return StudentResult(
        text, slug, Status.STOPPED, text, (check,), text, (text,), False, None, text
    )


def hostile_class(texts: tuple[str, ...] = HOSTILE) -> ClassResult:
    """Return a class of which every field holds a hostile text."""
    students = tuple(hostile_student(text, f"hostile-{n}") for n, text in enumerate(texts))
    joined = " ".join(texts)
    return ClassResult(joined, students, {joined: joined})


def _graded(folder: Path, name: str, look: Look, number: int) -> StudentResult:
    slug = f"student-{number:02}"
    pairs = tuple(_pair(folder, slug, look, frame) for frame in FRAMES)
    differs = not all(pair.is_alike for pair in pairs)
    share = 1.0 if not differs else 0.0 if look.radius > 40 else 0.5
    reasons = () if not differs else tuple(f"{p.label}: {p.reason}" for p in pairs if p.reason)
    motion = _curve(look)
    is_steady = look.shift == 0
    moves = CheckResult(
        "Motion of the ball",
        "motion",
        1.0 if is_steady else 0.25,
        3.0 if is_steady else 0.75,
        3.0,
        () if is_steady else ("The ball leaves its path in frames 21 to 40: it falls too fast.",),
        curves=(motion,),
    )
    has_loop = number % 5 != 3
    loop = CheckResult(
        "Uses a loop",
        "source",
        float(has_loop),
        float(has_loop),
        1.0,
        () if has_loop else ("The 12 stripes are drawn one by one. A for loop draws them all.",),
    )
    pictures = CheckResult("Pictures", "image", share, 6 * share, 6.0, reasons, pairs)
    return StudentResult(
        name,
        slug,
        Status.GRADED,
        checks=(pictures, moves, loop),
        console="frame 1: x = 40\nframe 2: x = 44\n" if number % 2 else "",
        remarks=("smooth() was called after something had been drawn.",) if number == 4 else (),
        is_deterministic=True,
        thumbnail=pairs[-1].submitted,
        sandbox=SANDBOX,
    )


def _unlucky(folder: Path, count: int) -> list[StudentResult]:
    """Return who crashed, timed out, was refused, or made the grader fail."""
    first = _pair(folder, "stopped", Look(), 1)
    missing = Comparison(
        "frame 30", None, first.expected, None, 1.0, 1.0, 76800, False, "It stopped in frame 17."
    )
    stopped = (
        CheckResult("Pictures", "image", 0.5, 3.0, 6.0, (missing.reason,), (first, missing)),
        CheckResult("Motion of the ball", "motion", 0.0, 0.0, 3.0, ("It stopped in frame 17.",)),
        CheckResult("Uses a loop", "source", 1.0, 1.0, 1.0),
    )
    trace = "sketch.py, line 14: rect() takes 4, 5 or 8 numbers.\n    Got 3: rect(10, 20, 30)."
    loud = "\x1b[31mred\x1b[0m " + HOSTILE[1] + "\n" + "spam and eggs " * 400
    return [
        StudentResult(
            "Otto Stein", "stopped", Status.STOPPED, trace, stopped, "x = 17\n", (), True,
            first.submitted, SANDBOX,
        ),
        StudentResult(
            SCRIPT, "script", Status.OVER_LIMIT, "It needed more than 10 s of processor time.",
            tuple(replace(check, score=0.0, points=0.0, reasons=(HOSTILE[2],), comparisons=())
                  for check in stopped), loud, (), None, None, SANDBOX,
        ),
        StudentResult(
            "Petra \u202eafter", "refused", Status.REFUSED,
            "The archive holds a file outside of its folder: ../../etc/passwd.", sandbox=SANDBOX,
        ),
        StudentResult(
            "Quentin Roy", "failed", Status.FAILED, "The renderer could not be started.",
            sandbox=SANDBOX,
        ),
    ]  # fmt: skip


def _pair(folder: Path, slug: str, look: Look, frame: int) -> Comparison:
    submitted, expected = _draw(look, frame), _draw(Look(), frame)
    difference = np.abs(np.asarray(submitted, np.int16) - np.asarray(expected, np.int16)).max(
        axis=2
    )
    names = [f"pictures/{slug}-{frame}-{kind}.png" for kind in ("drawn", "expected", "difference")]
    heat = np.stack([difference, difference // 2, 60 - difference // 5], axis=2).astype(np.uint8)
    (folder / "pictures").mkdir(parents=True, exist_ok=True)
    for name, picture in zip(names, (submitted, expected, Image.fromarray(heat)), strict=True):
        picture.save(folder / name)
    differing = int((difference > 0).sum())
    reason = f"A region of {differing} pixels differs, around the ball." if differing else ""
    mean = float(difference.mean()) / 255
    paths = [Path(name) for name in names]
    return Comparison(
        f"frame {frame}", paths[0], paths[1], paths[2], mean, mean, differing, not differing, reason
    )


def _draw(look: Look, frame: int) -> Image.Image:
    picture = Image.new("RGB", SIZE, look.sky)
    draw = ImageDraw.Draw(picture)
    if look.has_ground:
        draw.rectangle((0, 190, *SIZE), fill="#4f8a3c")
        for stripe in range(12):
            draw.line((stripe * 30, 190, stripe * 30 - 20, 240), fill="#78b060", width=4)
    x, y = 60 + frame * 5 + look.shift, 150 - 90 * abs(math.sin(frame / 12))
    r = look.radius
    draw.ellipse((x - r, y - r, x + r, y + r), fill=look.ball, outline="#401008", width=3)
    return picture


def _curve(look: Look) -> Curve:
    frames = tuple(range(1, 61))
    path = [150 - 90 * abs(math.sin(frame / 12)) for frame in frames]
    values = [
        y + (look.shift * 2 if 21 <= f <= 40 else 1) for f, y in zip(frames, path, strict=True)
    ]
    if look.shift > 20:
        values[8:13] = [math.nan] * 5
    return Curve("y", frames, tuple(values), tuple(y - 6 for y in path), tuple(y + 6 for y in path))
