from pathlib import Path

from PIL import Image

from sketchkit.grading.assignment.assignment import Assignment
from sketchkit.grading.assignment.plan import runs
from sketchkit.grading.assignment.references import frames_evidence, frames_of, sketch_of
from sketchkit.grading.assignment.run import Run, merged
from tests.grading.checks.cases import check_of


def test_parts_of_one_run_are_joined() -> None:
    joined = merged(
        [
            Run("", (1, 30), (0, 2, 29), (1, 30), last_frame=30),
            Run("clicks.json", (5,), last_frame=5),
            Run("", (29, 30), (28,), traced=(9,), watched=("x",), last_frame=40),
            Run("", watched=("y", "x")),
        ]
    )

    assert joined == (
        Run("", (1, 29, 30), (0, 2, 28), (1, 30), (9,), ("x", "y"), 40),
        Run("clicks.json", (5,), last_frame=5),
    )


def test_checks_share_a_run() -> None:
    checks = (
        check_of("image", frames=(10,)),
        check_of("trace", "lights = 1", frames=(3,)),
        check_of("source", 'calls = "rect"'),
    )

    assert runs(Assignment(Path(), "A", checks=checks)) == (
        Run("", (10,), (0, 1, 8, 9, 11, 12), (10,), (3,), last_frame=12),
    )


def test_source_alone_needs_no_run() -> None:
    checks = (check_of("source", 'calls = "rect"'),)

    assert runs(Assignment(Path(), "A", checks=checks)) == ()


def test_sketch_of_a_reference(tmp_path: Path) -> None:
    (tmp_path / "box").mkdir()
    first, named = tmp_path / "box" / "a.py", tmp_path / "box" / "box.py"

    assert sketch_of(tmp_path / "box") is None
    first.touch()
    assert sketch_of(tmp_path / "box") == first
    named.touch()
    assert sketch_of(tmp_path / "box") == named
    assert sketch_of(first) == first


def test_two_files_of_other_names_are_no_sketch(tmp_path: Path) -> None:
    for name in ("a.py", "b.py"):
        (tmp_path / name).touch()

    assert sketch_of(tmp_path) is None


def test_frames_of_a_reference_serve_every_run(tmp_path: Path) -> None:
    for name in ("frame-0003.png", "frame-12345.png", "other.png"):
        Image.new("RGB", (2, 2)).save(tmp_path / name)

    evidence = frames_evidence(tmp_path, ("", "clicks.json"))

    assert frames_of(tmp_path).keys() == {3, 12345}
    assert evidence.runs["clicks.json"].frames == evidence.runs[""].frames == frames_of(tmp_path)
