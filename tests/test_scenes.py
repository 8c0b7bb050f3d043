"""Every scene on every renderer: as text, on the CPU, with OpenGL, and against Processing's.

`tests/scenes/make_processing_goldens.py` says how Processing's pictures are made.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from sketchkit.assets.paths import set_sketch_folder, sketch_folder
from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.backends.gl.executor import GlBackend
from sketchkit.backends.listing import ListingBackend
from sketchkit.core.errors import SketchError
from sketchkit.draw.backend import Backend
from sketchkit.draw.vertex import U8
from sketchkit.runtime.headless import Launch
from sketchkit.runtime.headless import render as runtime_render
from tests.canvases import new_canvas
from tests.goldens import Goldens
from tests.scenes import SCENES, TOPICS, Scene, registry
from tests.scenes.make_processing_goldens import write

GL_SHARE = 1 - 1 / 2000
PROCESSING_TOLERANCE = 2


@pytest.fixture(autouse=True)
def _folder_of_scenes() -> Iterator[None]:
    """Let scenes find their files."""
    before = sketch_folder()
    set_sketch_folder(registry.FOLDER)
    yield
    set_sketch_folder(before)


every_scene = pytest.mark.parametrize("scene", SCENES.values(), ids=SCENES)
ON_CPU = {name: scene for name, scene in SCENES.items() if not scene.runs_glsl}
ON_GL_ALONE = {name: scene for name, scene in SCENES.items() if scene.runs_glsl}
every_scene_on_cpu = pytest.mark.parametrize("scene", ON_CPU.values(), ids=ON_CPU)
every_scene_of_shaders = pytest.mark.parametrize("scene", ON_GL_ALONE.values(), ids=ON_GL_ALONE)


def render(scene: Scene, backend: Backend) -> U8:
    """Return the picture of a scene, (h, w, 4)."""
    canvas = new_canvas(scene.renderer, backend, scene.size, scene.samples)
    scene.draw(canvas)
    return canvas.image_data()


@cache
def on_cpu(scene: Scene) -> U8:
    return render(scene, CpuBackend())


@every_scene
def test_draw_list_is_as_before(scene: Scene, goldens: Goldens) -> None:
    backend = ListingBackend()

    render(scene, backend)

    goldens.check_text(f"trace/{scene.name}.txt", "".join(backend.texts))


@every_scene_on_cpu
def test_cpu_picture_is_as_before(scene: Scene, goldens: Goldens) -> None:
    picture = on_cpu(scene)

    goldens.check_picture(f"image/{scene.name}.png", picture)


@every_scene_on_cpu
def test_gl_agrees_with_the_cpu(scene: Scene, goldens: Goldens, gl_backend: GlBackend) -> None:
    picture = render(scene, gl_backend)

    goldens.check_near(
        f"image/{scene.name}.png",
        picture,
        tolerance=scene.gl_tolerance,
        least_share=GL_SHARE,
        label="gl",
    )


@every_scene_on_cpu
def test_cpu_agrees_with_processing(scene: Scene, goldens: Goldens) -> None:
    picture = on_cpu(scene)

    goldens.check_near(
        f"processing/{scene.name}.png",
        picture,
        tolerance=PROCESSING_TOLERANCE,
        least_share=scene.processing_share,
        label="cpu",
    )


@every_scene
def test_gl_agrees_with_processing(scene: Scene, goldens: Goldens, gl_backend: GlBackend) -> None:
    picture = render(scene, gl_backend)

    goldens.check_near(
        f"processing/{scene.name}.png",
        picture,
        tolerance=PROCESSING_TOLERANCE,
        least_share=scene.processing_share,
        label="gl",
    )


@every_scene_on_cpu
def test_scene_as_a_sketch_draws_the_same(scene: Scene, tmp_path: Path) -> None:
    write(tmp_path, [scene])
    sketch = tmp_path / f"{scene.name}.py"

    (frame,) = runtime_render(Launch(sketch, refuse), [1], CpuBackend())

    assert np.array_equal(frame.pixels, on_cpu(scene)[:, :, :3])


@every_scene_of_shaders
def test_gl_picture_is_as_before(scene: Scene, goldens: Goldens, gl_backend: GlBackend) -> None:
    picture = render(scene, gl_backend)

    goldens.check_own_near(
        f"image/{scene.name}.png",
        picture,
        tolerance=scene.gl_tolerance,
        least_share=GL_SHARE,
        label="gl",
    )


@every_scene_of_shaders
def test_cpu_refuses_shaders_in_one_sentence(scene: Scene) -> None:
    with pytest.raises(SketchError, match="does not run shaders"):
        render(scene, CpuBackend())


@every_scene_of_shaders
def test_scene_of_shaders_as_a_sketch_draws_the_same(
    scene: Scene, tmp_path: Path, gl_backend: GlBackend
) -> None:
    write(tmp_path, [scene])
    sketch = tmp_path / f"{scene.name}.py"

    (frame,) = runtime_render(Launch(sketch, refuse), [1], gl_backend)

    assert np.array_equal(frame.pixels, render(scene, gl_backend)[:, :, :3])


def refuse(path: Path, line: int, text: str) -> None:
    raise AssertionError(f"{path.name}, line {line}: {text}")


def test_every_file_of_scenes_is_a_topic() -> None:
    folder = Path(registry.__file__).parent
    others = {"__init__", "registry", "make_processing_goldens"}

    topics = {path.stem for path in folder.glob("*.py")} - others

    assert topics == {topic.__name__.rpartition(".")[2] for topic in TOPICS}


@pytest.mark.parametrize("folder", ["trace", "image", "processing"])
def test_every_golden_belongs_to_a_scene(folder: str) -> None:
    kept = {path.stem for path in (Path(__file__).parent / "golden" / folder).iterdir()}

    assert kept <= set(SCENES)
