from __future__ import annotations

import json
import os
from dataclasses import replace
from pathlib import Path

import pytest

from sketchkit.core.errors import SketchError
from sketchkit.grading.sandbox import inside
from sketchkit.grading.sandbox.job import Job, SandboxError
from sketchkit.grading.sandbox.level import Level
from sketchkit.grading.sandbox.plan import VARIABLE, Plan
from sketchkit.grading.sandbox.run import run
from tests.grading.sandbox.conftest import SHORT

COPY = """
import json, os
from sketchkit.grading.sandbox import inside
home = inside.copy_sketch()
found = sorted(str(path.relative_to(home)) for path in home.rglob("*"))
os.write(inside.OUTPUT, json.dumps(found).encode())
"""


@pytest.fixture
def sketch(tmp_path: Path) -> Path:
    """Return a folder as it is staged, and a link, which never is."""
    folder = tmp_path / "a sketch"
    (folder / "data").mkdir(parents=True)
    (folder / "data" / "näme.txt").write_text("x")
    (folder / "sketch.py").write_text("x = 1")
    (folder / "link").symlink_to("/etc/passwd")
    (folder / "folder").symlink_to("/etc")
    os.mkfifo(folder / "pipe")
    for path in (folder, folder / "data"):
        path.chmod(0o755)
    return folder


def test_the_sketch_is_copied_to_where_it_may_write(
    walled: Level, tmp_path: Path, sketch: Path
) -> None:
    output = tmp_path / "output"

    ending = run(Job("timeit", ("-n1", "-r1", COPY), {"/submission": sketch}, output), walled)

    assert ending.went_well, ending.console
    assert json.loads(output.read_bytes()) == ["data", "data/näme.txt", "sketch.py"]


def test_a_sketch_that_is_too_large_is_told(walled: Level, tmp_path: Path, sketch: Path) -> None:
    (sketch / "large.bin").write_bytes(bytes(5 << 20))
    job = Job("timeit", ("-n1", "-r1", COPY), {"/submission": sketch}, limits=SHORT)

    ending = run(replace(job, output=tmp_path / "output"), walled)

    assert "could not be copied" in ending.console
    assert "they may have 4 MB" in ending.console


def test_a_single_file_is_copied(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    source, home = tmp_path / "ball.py", tmp_path / "home"
    source.write_text("x = 1")
    home.mkdir()
    plan = Plan({"/submission": str(source), "/sketch": str(home)}, (), ())
    monkeypatch.setenv(VARIABLE, plan.to_json())

    inside.copy_sketch()

    assert [path.name for path in home.iterdir()] == ["ball.py"]


def test_a_copy_that_fails_is_a_sketchs_error(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "ball.py").write_text("x = 1")
    plan = Plan({"/submission": str(tmp_path), "/sketch": "/dev/null"}, (), ())
    monkeypatch.setenv(VARIABLE, plan.to_json())

    with pytest.raises(SketchError, match="could not be copied"):
        inside.copy_sketch()


def test_outside_of_the_sandbox_there_are_no_paths(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(VARIABLE, raising=False)

    with pytest.raises(SandboxError, match="only runs in the sandbox"):
        inside.path("/submission")


def test_a_plan_is_read_as_it_was_written() -> None:
    plan = Plan({"/a": "/b"}, ("/c",), ("/d",), SHORT, has_seccomp=True, output="5", ready=6)

    assert Plan.from_json(plan.to_json()) == plan
