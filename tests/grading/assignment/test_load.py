import dataclasses
import pickle
import re
from pathlib import Path
from textwrap import dedent

import pytest
from PIL import Image

from sketchkit.grading.assignment.assignment import Limits
from sketchkit.grading.assignment.errors import AssignmentError
from sketchkit.grading.assignment.load import load
from sketchkit.grading.checks.beside import PictureRule

SKETCH = "def draw():\n    rect(10, 10, 20, 20)\n"
PLAIN = """
    title = "A square"

    [[checks]]
    kind = "image"
    points = 2.5
    frames = "1,3"
"""
EVENTS = '{"events": [{"frame": 2, "press": "left"}]}'


def assignment(folder: Path, text: str = PLAIN) -> Path:
    """Make an assignment with a reference, one made of pictures, events and data."""
    (folder / "reference").mkdir(parents=True)
    (folder / "reference" / "square.py").write_text(SKETCH)
    (folder / "pictures").mkdir()
    for number in (1, 2):
        Image.new("RGB", (4, 4)).save(folder / "pictures" / f"frame-{number:04d}.png")
    (folder / "empty").mkdir()
    (folder / "events.json").write_text(EVENTS)
    (folder / "assignment.toml").write_text(dedent(text).lstrip("\n"), encoding="utf-8")
    return folder


def refusal(folder: Path, text: str) -> str:
    """Return what is said of an assignment."""
    with pytest.raises(AssignmentError) as refused:
        load(assignment(folder / "a", text))
    return str(refused.value)


def test_what_is_left_out_is_as_usual(tmp_path: Path) -> None:
    found = load(assignment(tmp_path / "a"))

    assert (found.title, found.renderer, found.seed) == ("A square", "cpu", 0)
    assert found.limits == Limits()
    assert found.data is None
    (check,) = found.checks
    assert (check.name, check.slug, check.kind, check.points) == ("image", "1-image", "image", 2.5)
    assert (check.frames, check.events, check.references) == ((1, 3), "", ("reference",))
    assert isinstance(check.options, PictureRule)


def test_everything_that_can_be_said(tmp_path: Path) -> None:
    folder = assignment(
        tmp_path / "a",
        """
        title = "Ein Würfel"
        renderer = "gl"
        seed = 7
        data = "files"
        frames = "1-5:2"
        input = "events.json"
        reference = ["reference", "pictures"]

        [limits]
        cpu_s = 5
        wall_s = 7.5
        memory_mb = 256
        output_mb = 8

        [[checks]]
        name = "Schöne Größe / 1"
        kind = "image"
        points = 3
        frames = [1, 2]
        expect = "A square."
        metric = "pixels"
        tolerance = { step = 4, share = 0.5 }
        combine = "best"
        curve = "all or nothing"

        [[checks]]
        name = "No events"
        kind = "trace"
        points = 1
        input = ""
        frames = 4
        kinds = { rect = 1 }
        """,
    )
    (folder / "files").mkdir()

    found = load(folder)

    assert (found.renderer, found.seed, found.points) == ("gl", 7, 4)
    assert found.limits == Limits(5, 7.5, 256, 8)
    assert found.data == folder / "files"
    first, second = found.checks
    assert first.slug == "1-schone-groe-1"
    assert (first.frames, first.events, first.expect) == ((1, 2), "events.json", "A square.")
    assert first.references == found.references == ("reference", "pictures")
    assert (second.frames, second.events) == ((4,), "")


def test_data_folder_is_found_by_itself(tmp_path: Path) -> None:
    folder = assignment(tmp_path / "a")
    (folder / "data").mkdir()

    assert load(folder).data == folder / "data"


def test_assignment_travels_to_other_processes(tmp_path: Path) -> None:
    found = load(assignment(tmp_path / "a"))

    assert pickle.loads(pickle.dumps(found)) == found


def test_digest_hangs_on_contents_and_not_on_the_place(tmp_path: Path) -> None:
    one, other = (load(assignment(tmp_path / name)) for name in "ab")

    assert one.digest == other.digest
    assert dataclasses.replace(one, folder=other.folder) == other


@pytest.mark.parametrize(
    ("name", "is_part"),
    [
        ("assignment.toml", True),
        ("reference/square.py", True),
        ("reference/other.txt", True),
        ("data/words.txt", True),
        ("results/old.json", False),
        ("reference/__pycache__/square.pyc", False),
    ],
)
def test_digest_changes_with_what_counts(tmp_path: Path, name: str, is_part: bool) -> None:
    folder = assignment(tmp_path / "a")
    before = load(folder).digest
    (folder / name).parent.mkdir(exist_ok=True)
    with (folder / name).open("a") as file:
        file.write("\n# more\n")

    assert (load(folder).digest != before) == is_part


HEAD = 'title = "A"\n[[checks]]\n'
IMAGE = HEAD + 'kind = "image"\npoints = 1\nframes = 1\n'
MOTION = HEAD + 'kind = "motion"\npoints = 1\nframes = 1\nvalues = "x"\n'

REFUSED = {
    "no TOML": ("title = A square", "line 1: This is no TOML: invalid value."),
    "no TOML, later": ('title = "A"\n[limits', "line 2: This is no TOML: "),
    "no title": ("seed = 1", "assignment.toml: An assignment needs title.\n    Write title ="),
    "misspelt title": (
        'titel = "A"',
        "line 1: titel is no key of an assignment.\n    Do you mean t",
    ),
    "wrong kind of title": ("title = 3", "line 1: title is a text, not 3."),
    "unknown key": (
        f"colour = 3\n{IMAGE}",
        "line 1: colour is no key of an assignment.\n    Its k",
    ),
    "renderer": (f'renderer = "gpu"\n{IMAGE}', "line 1: renderer is 'cpu' or 'gl', not 'gpu'."),
    "seed": (f"seed = 1.5\n{IMAGE}", "line 1: seed is a whole number, not 1.5."),
    "no data": (
        f'data = "emty"\n{IMAGE}',
        "line 1: There is no folder emty for data.\n    Do you m",
    ),
    "data elsewhere": (f'data = "../x"\n{IMAGE}', "line 1: data is a name within the assignment's"),
    "limits": (f"limits = 3\n{IMAGE}", "line 1: limits is a table, not 3."),
    "limit": (f"{IMAGE}[limits]\ncpu_s = 0", "line 7: cpu_s is more than 0, not 0."),
    "limit, misspelt": (
        f"{IMAGE}[limits]\ncpu = 9",
        "line 7: cpu is no key of limits.\n    Do you",
    ),
    "limit, no number": (
        f"{IMAGE}[limits]\nwall_s = true",
        "line 7: wall_s is a number, not true.",
    ),
    "limit, infinite": (f"{IMAGE}[limits]\nwall_s = inf", "line 7: wall_s is a number, not inf."),
    "little memory": (
        f"{IMAGE}[limits]\nmemory_mb = 1",
        "line 7: memory_mb is at least 64, not 1.",
    ),
    "no checks": ('title = "A"', "An assignment needs checks.\n    Write [[checks]], and below it"),
    "empty checks": ('title = "A"\nchecks = []', "line 2: There are no checks."),
    "checks, one table": ('title = "A"\n[checks]\nkind = "image"', "line 2: checks are tables."),
    "no kind": (HEAD, "line 2: A check needs kind."),
    "misspelt kind": (
        HEAD + 'kind = "imgae"',
        "line 3: There is no kind of check 'imgae'.\n    Do y",
    ),
    "unknown kind": (
        HEAD + 'kind = "style"',
        "line 3: There is no kind of check 'style'.\n    Kinds",
    ),
    "no points": (HEAD + 'kind = "image"\nframes = 1', "line 2: An image check needs points."),
    "misspelt points": (
        HEAD + 'kind = "image"\npoint = 3',
        "line 4: point is no key of an image check.\n    Do you mean points?",
    ),
    "points of 0": (HEAD + 'kind = "image"\npoints = 0', "line 4: points is more than 0, not 0."),
    "points as text": (
        HEAD + 'kind = "image"\npoints = "3"',
        "line 4: points is a number, not '3'.",
    ),
    "blank name": (
        HEAD + 'kind = "image"\nname = " "\npoints = 1',
        "line 4: A check's name is what",
    ),
    "two of one name": (
        IMAGE + IMAGE.removeprefix('title = "A"\n'),
        "line 6: There are two checks",
    ),
    "no frames": (HEAD + 'kind = "image"\npoints = 1', "line 2: An image check needs frames."),
    "frames": (IMAGE + "x = 1".replace("x", "shft"), "line 6: shft is no key of an image check."),
    "frames, no list": (
        HEAD + 'kind = "image"\npoints = 1\nframes = "one"',
        "line 5: frames: 'one' is none of 3, 1,30, 1-60 and 1-60:5.",
    ),
    "frames, empty": (
        f'frames = "9-1"\n{HEAD.strip()}\nkind = "image"\npoints = 1',
        "line 1: frames: 9-1 is an empty range",
    ),
    "frames, too far": (
        HEAD + 'kind = "image"\npoints = 1\nframes = 10_001',
        "line 5: Frame 10,001 is out of reach: the last one is 10,000.",
    ),
    "no such input": (
        IMAGE + 'input = "event.json"',
        "line 6: There is no file event.json.\n    Do you mean events.json?",
    ),
    "input elsewhere": (IMAGE + 'input = "/etc/hosts"', "line 6: input is a name within the assig"),
    "input, no list": (IMAGE + "input = 3", "line 6: input is a text, not 3."),
    "input, no events": (IMAGE + 'input = "assignment.toml"', "assignment.toml: "),
    "no such reference": (
        IMAGE + 'reference = "referense"',
        "line 6: There is no reference referense.\n    Do you mean reference?",
    ),
    "empty reference": (
        IMAGE + 'reference = ["reference", "empty"]',
        "line 6: The reference empty is no sketch, and has no frames.",
    ),
    "reference lacks a frame": (
        HEAD + 'kind = "image"\npoints = 1\nframes = "1-3"\nreference = "pictures"',
        "line 5: The reference pictures has no frame-0003.png.\n    Render it: sketchkit render",
    ),
    "reference of pictures": (
        MOTION + 'reference = "pictures"',
        "line 2: A motion check needs a sketch to compare with: the reference pictures is",
    ),
    "misspelt tolerance": (
        IMAGE + "tolerence = 3",
        "line 6: tolerence is no key of an image check.\n    Do you mean tolerance?",
    ),
    "tolerance": (IMAGE + "tolerance = 3", "line 6: tolerance is a table, not 3."),
    "within tolerance": (
        IMAGE + "tolerance = {maen = 3}",
        "line 6: maen is no key of the tolerance of metric 'flip'.\n    Do you mean mean?",
    ),
    "negative tolerance": (
        IMAGE + "tolerance = {mean = -1}",
        "line 6: mean is at least 0, not -1.",
    ),
    "metric": (IMAGE + 'metric = "ssim"', "line 6: metric is 'flip' or 'pixels', not 'ssim'."),
    "combine": (
        IMAGE + 'combine = "bets"',
        "line 6: combine is 'mean', 'best' or 'worst', not 'be",
    ),
    "expect": (IMAGE + "expect = 3", "line 6: expect is a text, not 3."),
    "shift": (
        IMAGE.replace("image", "sequence") + "shift = 500",
        "line 6: shift is at most 120 fr",
    ),
}


@pytest.mark.parametrize(("text", "words"), REFUSED.values(), ids=REFUSED.keys())
def test_mistake_is_told_with_its_line(tmp_path: Path, text: str, words: str) -> None:
    said = refusal(tmp_path, text)

    assert words in said
    assert re.fullmatch(r"assignment\.toml(, line \d+)?: .+\.(\n    .+[.?}\]\d\"a-z])?", said)


def test_folder_without_an_assignment_is_told_how_to_begin(tmp_path: Path) -> None:
    with pytest.raises(AssignmentError, match="There is no such file") as refused:
        load(tmp_path)

    assert (
        refused.value.hint == f"Write sketchkit grade init {tmp_path}: it makes one to begin with."
    )


def test_file_in_another_encoding_is_told(tmp_path: Path) -> None:
    (tmp_path / "assignment.toml").write_bytes('title = "Größe"'.encode("latin-1"))

    with pytest.raises(AssignmentError, match="not written in UTF-8"):
        load(tmp_path)
