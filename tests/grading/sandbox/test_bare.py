"""Where there is no bubblewrap: what the other walls hold by themselves."""

from __future__ import annotations

import os
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from sketchkit.grading.sandbox import bare
from sketchkit.grading.sandbox.job import Exceeded, Job, SandboxError
from sketchkit.grading.sandbox.level import Level
from sketchkit.grading.sandbox.run import run
from tests.grading.sandbox.conftest import SHORT, Attacked, attacked

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="these are Linux's")

ALL = Level(seccomp=True, landlock=True, limits=True)
LIMITS = Level(limits=True)
HEAD = """
import json, os, socket
from pathlib import Path
from sketchkit.grading.sandbox import inside
def say(found): os.write(inside.OUTPUT, json.dumps(found).encode())
def tried(attempt):
    try: return attempt()
    except OSError as error: return type(error).__name__
"""


@pytest.fixture(autouse=True)
def _ordinary_user(monkeypatch: pytest.MonkeyPatch) -> None:
    """The attacks here are harmless, and the tests may run as root."""
    monkeypatch.setattr(bare, "is_root", lambda: False)


def bare_attack(tmp_path: Path, code: str, level: Level = ALL, **given: Path) -> Attacked:
    return attacked(tmp_path, level, HEAD + code, replace(SHORT, wall_s=5), **given)


@pytest.mark.parametrize(
    "attempt",
    [
        "os.fork",
        "socket.socket",
        "lambda: os.kill(os.getppid(), 0)",
        "lambda: os.kill(-1, 0)",
        "os.setsid",
        "lambda: Path(REFERENCE).read_text()",
        "lambda: os.listdir(Path(REFERENCE).parent)",
        "lambda: Path('/etc/passwd').read_text()",
        "lambda: Path(f'/proc/{os.getppid()}/environ').read_text()",
        "lambda: Path(REFERENCE).write_text('x')",
        "lambda: Path('/tmp/sketchkit-left-behind').write_text('x')",
        "lambda: inside.path('/submission').write_text('x')",
        "lambda: os.symlink('/etc/passwd', inside.path('/sketch') / 'link')",
    ],
)
def test_seccomp_and_landlock_refuse(tmp_path: Path, attempt: str) -> None:
    folder = tmp_path / "elsewhere"
    folder.mkdir()
    reference = folder / "reference.py"
    reference.write_text("the solution")

    code = f"REFERENCE = {str(reference)!r}\nsay(tried({attempt}))"

    assert bare_attack(tmp_path, code).said == "PermissionError"


def test_its_own_folder_is_there_and_gone_afterwards(tmp_path: Path) -> None:
    code = """
home = inside.path("/sketch")
(home / "locked").mkdir()
(home / "locked" / "x").write_text("x")
(home / "locked").chmod(0)
say([str(home), os.getcwd(), os.environ["HOME"], str(inside.path("/tmp"))])
"""
    home, working, environment_home, temporary = bare_attack(tmp_path, code).said

    assert home == working
    assert environment_home == temporary
    assert not Path(home).parent.exists()


def test_what_is_given_can_be_read(tmp_path: Path) -> None:
    tape = tmp_path / "tape"
    tape.write_text("recorded")

    code = "say(inside.path('/tape').read_text())"

    assert bare_attack(tmp_path, code, tape=tape).said == "recorded"


def test_the_environment_is_not_the_graders(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SECRET", "of the grader")

    assert "SECRET" not in bare_attack(tmp_path, "say(sorted(os.environ))", LIMITS).said


def test_limits_alone_end_what_takes_too_long(tmp_path: Path) -> None:
    limits = replace(SHORT, cpu_s=1, wall_s=10)

    ending = attacked(tmp_path, LIMITS, "while True: pass", limits).ending

    assert ending.exceeded is Exceeded.CPU


def test_limits_alone_bound_memory(tmp_path: Path) -> None:
    assert bare_attack(tmp_path, "bytearray(1 << 40)", LIMITS).ending.exceeded is Exceeded.MEMORY


def test_time_is_bounded_for_what_it_has_started_too(tmp_path: Path) -> None:
    """Without seccomp it can fork; its group of processes is ended with it."""
    code = "import time\nos.fork()\nwhile True: time.sleep(9)"

    ending = attacked(tmp_path, LIMITS, HEAD + code, replace(SHORT, wall_s=1)).ending

    assert ending.exceeded is Exceeded.WALL


def test_root_runs_nothing_without_a_namespace(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(bare, "is_root", lambda: True)
    output = tmp_path / "output"

    with pytest.raises(SandboxError, match="not run as root without a user namespace"):
        run(Job("timeit", ("-n", "1", "pass"), output=output), ALL)


def test_a_wall_that_is_counted_on_must_be_up(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The job does not begin: here a variable stands for a kernel without Landlock."""
    package = tmp_path / "places"
    package.mkdir()
    (package / "sitecustomize.py").write_text(
        "import ctypes, os\n"
        "from sketchkit.grading.sandbox import landlock\n"
        "def restrict(*_): raise OSError('no Landlock here')\n"
        "landlock.restrict = restrict\n"
    )
    monkeypatch.setattr(
        "sketchkit.grading.sandbox.surroundings._not_found_by_itself",
        lambda: [package, Path(bare.__file__).parents[3]],
    )

    with pytest.raises(SandboxError, match="not up: Landlock"):
        run(Job("timeit", ("-n", "1", "print('ran')")), ALL)


def test_this_process_is_not_what_was_locked_down() -> None:
    assert os.access("/etc/passwd", os.R_OK)
    assert "Seccomp:\t0" in Path("/proc/self/status").read_text()
