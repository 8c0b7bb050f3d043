"""The command as a whole process: what a terminal sees."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.runtime.sketches import written

ROOT = Path(__file__).parents[2]


def sketchkit(*args: str, folder: Path, **variables: str) -> subprocess.CompletedProcess[str]:
    kept = {name: value for name, value in os.environ.items() if "DISPLAY" not in name}
    return subprocess.run(
        [sys.executable, "-m", "sketchkit", *args],
        cwd=folder,
        env={**kept, "PYTHONPATH": str(ROOT), **variables},
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )


def test_without_a_display_render_is_named(tmp_path: Path) -> None:
    written(tmp_path, "size(10, 10)", "spinning.py")

    done = sketchkit("run", "spinning.py", folder=tmp_path)

    assert done.returncode == 2
    assert "sketchkit render spinning.py" in done.stderr
    assert len(done.stderr.splitlines()) == 1


@pytest.mark.parametrize("name", ["math", "copy", "inspect", "numpy"])
def test_files_beside_the_sketch_hide_nothing(tmp_path: Path, name: str) -> None:
    written(tmp_path, "raise SystemExit('hidden')", f"{name}.py")
    written(tmp_path, "size(10, 10)", "spinning.py")

    done = sketchkit("render", "spinning.py", "--renderer", "cpu", folder=tmp_path)

    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / "out" / "frame-0001.png").exists()


def test_cpu_renderer_loads_no_opengl(tmp_path: Path) -> None:
    text = """
        import sys
        loaded = {name.partition(".")[0] for name in sys.modules}
        print(sorted(loaded & {"moderngl", "glfw", "rich", "PIL"}))
    """
    written(tmp_path, text, "spinning.py")

    done = sketchkit("render", "spinning.py", "--renderer", "cpu", folder=tmp_path)

    assert done.stdout == "[]\n"
