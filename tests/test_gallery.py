"""Every sketch of the gallery does what its check line says.

`# check: compare frames=1,30`: OpenGL and the CPU draw the same frames. `# check: run`: for what no
two runs draw alike; it gets through its first frames. None may cause a remark.

Those in `shaders/` need OpenGL: the CPU refuses them, so that they are compared with the sheet of
small pictures beside them, `make_shader_sheet.py`.
"""

from __future__ import annotations

import ast
import re
from pathlib import Path
from typing import NamedTuple

import pytest

from sketchkit.api.events import KeyEvent, MouseEvent
from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.backends.gl.executor import GlBackend
from sketchkit.core.clock import VirtualClock
from sketchkit.core.constants import LEFT
from sketchkit.core.errors import SketchError
from sketchkit.draw.backend import Backend
from sketchkit.draw.renderer import Renderer
from sketchkit.draw.vertex import U8
from sketchkit.runtime.headless import Launch, opened, render
from sketchkit.runtime.report import StoppedError
from tests.goldens import share_within
from tests.make_shader_sheet import FRAME, SHADERS, cell_of, shader_sketches, small

GALLERY = Path(__file__).parents[1] / "sketches"
TOLERANCE = 2
LEAST_SHARE = 1 - 1 / 2000
FIRST_FRAMES = (1, 2, 3)

PLAIN_SKETCHES = sorted(GALLERY.glob("*.py"))

plain_sketches = pytest.mark.parametrize("sketch", PLAIN_SKETCHES, ids=lambda path: path.stem)
with_shaders = pytest.mark.parametrize("sketch", shader_sketches(), ids=lambda path: path.stem)
every_sketch = pytest.mark.parametrize(
    "sketch", PLAIN_SKETCHES + shader_sketches(), ids=lambda path: path.stem
)


class Check(NamedTuple):
    """What a check line asks for."""

    kind: str
    frames: tuple[int, ...]


def check_of(sketch: Path) -> Check:
    """Return what the second line of a sketch asks for."""
    line = sketch.read_text(encoding="utf-8").splitlines()[1]
    found = re.fullmatch(r"# check: (?:(run)|(compare) frames=(\d+(?:,\d+)*))", line)
    assert found, (
        f"the second line must be '# check: run' or '# check: compare frames=1,30': {line}"
    )
    frames = found[3] or ",".join(map(str, FIRST_FRAMES))
    return Check(found[1] or found[2], tuple(map(int, frames.split(","))))


def refuse(path: Path, line: int, text: str) -> None:
    raise AssertionError(f"{path.name}, line {line}: {text}")


def pictures(sketch: Path, frames: tuple[int, ...], backend: Backend) -> dict[int, U8]:
    """Return the frames by their numbers, (h, w, 3)."""
    return {frame.number: frame.pixels for frame in render(Launch(sketch, refuse), frames, backend)}


def test_gallery_is_there() -> None:
    assert len(PLAIN_SKETCHES) >= 10
    assert len(shader_sketches()) >= 20


@every_sketch
def test_first_line_is_a_title(sketch: Path) -> None:
    first_line = sketch.read_text(encoding="utf-8").splitlines()[0]

    assert re.fullmatch(r'"""[A-Z][\w ]+: .+\."""', first_line)


@every_sketch
def test_sketch_needs_no_import(sketch: Path) -> None:
    tree = ast.parse(sketch.read_text(encoding="utf-8"))

    assert not any(isinstance(node, ast.Import | ast.ImportFrom) for node in ast.walk(tree))


@plain_sketches
def test_sketch_passes_its_check(sketch: Path, gl_backend: GlBackend) -> None:
    check = check_of(sketch)

    on_gl = pictures(sketch, check.frames, gl_backend)

    assert len(on_gl) == len(check.frames)
    if check.kind == "compare":
        on_cpu = pictures(sketch, check.frames, CpuBackend())
        shares = {n: share_within(on_cpu[n], on_gl[n], TOLERANCE) for n in check.frames}
        assert min(shares.values()) >= LEAST_SHARE, shares


@with_shaders
def test_shader_sketch_shows_what_is_on_the_sheet(sketch: Path, gl_backend: GlBackend) -> None:
    check = check_of(sketch)

    on_gl = pictures(sketch, check.frames, gl_backend)

    assert FRAME in on_gl
    assert share_within(cell_of(sketch), small(on_gl[FRAME]), TOLERANCE) >= LEAST_SHARE


@with_shaders
def test_cpu_refuses_a_shader_in_one_sentence(sketch: Path) -> None:
    with pytest.raises(StoppedError) as stopped:
        pictures(sketch, (1,), CpuBackend())

    assert isinstance(stopped.value.__cause__, SketchError)
    assert stopped.value.__cause__.problem.startswith("The CPU renderer does not run shaders")


@with_shaders
def test_shader_sketch_is_small(sketch: Path) -> None:
    assert len(sketch.read_text(encoding="utf-8").splitlines()) <= 60


def test_every_shader_of_the_gallery_is_used() -> None:
    sketches = "".join(path.read_text(encoding="utf-8") for path in shader_sketches())

    assert [path.name for path in (SHADERS / "data").iterdir() if path.name not in sketches] == []


def test_drawing_follows_mouse_and_keys() -> None:
    launch = Launch(GALLERY / "drawing.py", refuse)
    with opened(launch, Renderer(CpuBackend()), VirtualClock()) as loop:
        canvas = loop.program.sketch.canvas
        loop.begin()
        loop.post(KeyEvent(KeyEvent.PRESS, key="2"))
        loop.post(MouseEvent(MouseEvent.PRESS, x=100, y=100, button=LEFT))
        loop.step()
        loop.post(MouseEvent(MouseEvent.DRAG, x=200, y=100, button=LEFT))
        loop.step()
        loop.step()
        painted = canvas.image_data()[100, 150, :3].tolist()
        loop.post(KeyEvent(KeyEvent.PRESS, key="c"))
        loop.step()
        cleared = canvas.image_data()[100, 150, :3].tolist()

    assert painted == [0xE0, 0x47, 0x5B]
    assert cleared == [252, 250, 244]
