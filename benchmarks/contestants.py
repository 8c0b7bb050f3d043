"""Who takes part: sketchkit, and of Processing's Java core and py5 what is installed here."""

from __future__ import annotations

import os
import platform
import shutil
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from benchmarks.workloads import file_of

FOLDER = Path(__file__).parent
LONGEST_S = 120  # for one workload, start-up included
SCREEN = ("-screen", "0", "1280x1024x24", "+extension", "GLX")
SYSTEMS = {"Linux": "linux", "Windows": "windows"}  # JOGL's names
PROCESSORS = {"x86_64": "amd64", "AMD64": "amd64", "arm64": "aarch64"}


@dataclass(frozen=True)
class Times:
    """The frames of one run: milliseconds inside `draw()`, and until all was drawn."""

    calls_ms: Sequence[float]
    total_ms: Sequence[float]


@dataclass(frozen=True)
class Contestant:
    """One that draws the workloads.

    Attributes
    ----------
    name : str
        As it stands in the table.
    command : tuple of str
        What runs it; `{workload}`, `{file}`, `{samples}` and `{seconds}` are filled in.
    """

    name: str
    command: tuple[str, ...]

    def run(self, workload: str, samples: int, seconds: float) -> Times | None:
        """Draw a workload and return its times; None if it took longer than LONGEST_S.

        Raises
        ------
        RuntimeError
            If it printed no times.
        """
        values = {
            "workload": workload,
            "file": str(file_of(workload)),
            "samples": str(samples),
            "seconds": str(seconds),
        }
        words = [word.format_map(values) for word in self.command]
        try:
            done = subprocess.run(
                words,
                capture_output=True,
                text=True,
                timeout=LONGEST_S,
                cwd=FOLDER.parent,
                check=False,
            )
        except subprocess.TimeoutExpired:
            return None
        frames = [line.split()[1:] for line in done.stdout.splitlines() if line[:6] == "frame "]
        if not frames:
            raise RuntimeError(f"{self.name} has not drawn {workload}:\n{done.stderr.strip()}")
        calls, totals = zip(*frames, strict=True)
        return Times(tuple(map(float, calls)), tuple(map(float, totals)))


def sketchkit(renderer: str = "gl") -> Contestant:
    """Return sketchkit, as this Python imports it."""
    name = "sketchkit" if renderer == "gl" else f"sketchkit {renderer}"
    program = (sys.executable, "-m", "benchmarks.sketchkit_frames")
    return Contestant(name, (*program, "{workload}", "{samples}", "{seconds}", renderer))


def py5(python: Path) -> Contestant | None:
    """Return py5, if that Python has it."""
    if _py5_folder(python) is None:
        return None
    program = str(FOLDER / "py5_frames.py")
    return Contestant("py5", (str(python), program, "{file}", "{samples}", "{seconds}"))


def processing(python: Path, java: str, classes: Path) -> Contestant | None:
    """Return Processing's own core in Java, from the py5 package of a Python.

    Parameters
    ----------
    python : Path
        A Python that has py5.
    java : str
        The command that runs Java; its compiler `javac` is looked for beside it.
    classes : Path
        A folder for the compiled program.
    """
    package = _py5_folder(python)
    found = shutil.which(java)
    if package is None or found is None:
        return None
    compiler = shutil.which(str(Path(found).with_name("javac"))) or shutil.which("javac")
    if compiler is None:
        return None
    jars = package / "jars"
    source = FOLDER / "java" / "Bench.java"
    subprocess.run(
        [compiler, "-cp", str(jars / "core.jar"), "-d", str(classes), str(source)], check=True
    )
    return Contestant(
        "Processing",
        (
            found,
            f"-Djava.library.path={package / 'natives' / _native_folder()}",
            "-Djogamp.gluegen.UseTempJarCache=false",
            "-cp",
            os.pathsep.join([str(jars / "*"), str(classes)]),
            "Bench",
            "{workload}",
            "{samples}",
            "{seconds}",
        ),
    )


@contextmanager
def display() -> Iterator[None]:
    """Provide an X display for the windows of the others, if there is none and Xvfb is here."""
    if os.environ.get("DISPLAY") or sys.platform != "linux" or not shutil.which("Xvfb"):
        yield
        return
    reading, writing = os.pipe()
    words = ["Xvfb", "-displayfd", str(writing), *SCREEN]
    with subprocess.Popen(words, pass_fds=[writing], stderr=subprocess.DEVNULL) as server:
        os.close(writing)
        with os.fdopen(reading) as answer:
            os.environ["DISPLAY"] = ":" + answer.readline().strip()
        try:
            yield
        finally:
            del os.environ["DISPLAY"]
            server.terminate()


def _py5_folder(python: Path) -> Path | None:
    """Return where a Python's py5 lies, without importing it: that starts Java."""
    find = "from importlib.util import find_spec as f; s = f('py5'); print(s.origin if s else '')"
    try:
        done = subprocess.run([python, "-c", find], capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return None
    return Path(done.stdout.strip()).parent if done.stdout.strip() else None


def _native_folder() -> str:
    system, machine = platform.system(), platform.machine()
    if system == "Darwin":
        return "macosx-universal"
    return f"{SYSTEMS.get(system, system)}-{PROCESSORS.get(machine, machine)}"
