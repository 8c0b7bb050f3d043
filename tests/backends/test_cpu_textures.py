from __future__ import annotations

import numpy as np
import pytest

from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.backends.cpu.textures import Texture
from sketchkit.draw.pipeline import Program
from sketchkit.draw.resources import Pixels, Target, Wrap
from sketchkit.draw.vertex import U8
from tests.backends.draw_lists import flat_pipeline, on, random_image, rect

WHITE = (255, 255, 255, 255)
IMAGE = random_image(np.random.default_rng(1), 16, 12, alpha=255)


def drawn(image: Pixels, width: float, height: float, tint: tuple[int, ...] = WHITE) -> U8:
    """Return what an image looks like, drawn at the top left of a target of 20 x 20."""
    target, backend = Target(20, 20), CpuBackend()
    pipeline = flat_pipeline(target, program=Program.TEXTURED, texture=image)
    backend.execute(on(target, rect(0, 0, width, height, tint), pipeline))
    return backend.read(target)


def sample(u: float, v: float, wrap: Wrap) -> list[int]:
    nothing_spanned = np.zeros(1, np.float32)
    colors = Texture(IMAGE).sample(np.array([[u], [v]], np.float32), nothing_spanned, wrap)
    return colors[:, 0].tolist()


def test_drawn_in_its_own_size_an_image_is_exact() -> None:
    assert np.array_equal(drawn(IMAGE, 16, 12)[:12, :16], IMAGE.data)


def test_drawn_in_half_its_size_each_pixel_is_the_mean_of_four() -> None:
    small = drawn(IMAGE, 8, 6)[:6, :8]

    fours = IMAGE.data.reshape(6, 2, 8, 2, 4).astype(float).mean(axis=(1, 3))
    assert np.abs(small - fours).max() <= 1  # rounded twice, once in each direction


def test_without_smaller_copies_pixels_between_are_skipped() -> None:
    stripes = np.zeros((16, 16, 4), np.uint8)
    stripes[:, ::4] = 255
    stripes[..., 3] = 255

    assert np.all(drawn(Pixels(stripes), 4, 4)[:4, :4, 0] == 64)
    assert np.all(drawn(Pixels(stripes, mipmaps=False), 4, 4)[:4, :4, 0] == 0)


@pytest.mark.parametrize(
    ("tint", "expected"),
    [((255, 255, 255, 255), (200, 100, 50)), ((128, 255, 0, 255), (100, 100, 0))],
)
def test_tint_multiplies(tint: tuple[int, ...], expected: tuple[int, ...]) -> None:
    image = Pixels(np.full((4, 4, 4), (200, 100, 50, 255), np.uint8))

    assert tuple(drawn(image, 20, 20, tint)[9, 9, :3]) == expected


@pytest.mark.parametrize(
    ("alpha", "tint", "expected"), [(128, WHITE, 100), (255, (255, 255, 255, 128), 100)]
)
def test_translucent_images_are_blended(alpha: int, tint: tuple[int, ...], expected: int) -> None:
    image = Pixels(np.full((4, 4, 4), (200, 200, 200, alpha), np.uint8))

    assert drawn(image, 20, 20, tint)[9, 9, 0] == expected


def test_clamped_textures_go_on_with_their_edge() -> None:
    assert sample(-3, 0.5 / 12, Wrap.CLAMP) == IMAGE.data[0, 0].tolist()
    assert sample(3, 11.5 / 12, Wrap.CLAMP) == IMAGE.data[11, 15].tolist()


def test_repeated_textures_begin_again() -> None:
    assert sample(-2 + 3.5 / 16, 1 + 2.5 / 12, Wrap.REPEAT) == IMAGE.data[2, 3].tolist()


def test_between_texels_colours_are_mixed() -> None:
    between = sample(4 / 16, 0.5 / 12, Wrap.CLAMP)

    mean = (IMAGE.data[0, 3].astype(float) + IMAGE.data[0, 4]) / 2
    assert np.abs(np.array(between) - mean).max() <= 0.5


def test_a_changed_image_is_copied_again() -> None:
    image, target, backend = Pixels(IMAGE.data.copy()), Target(16, 12), CpuBackend()
    pipeline = flat_pipeline(target, program=Program.TEXTURED, texture=image)
    commands = on(target, rect(0, 0, 16, 12, WHITE), pipeline)
    backend.execute(commands)

    image.data[..., :3] = 77
    image.version += 1
    backend.execute(commands)

    assert np.all(backend.read(target)[..., :3] == 77)


def test_an_image_is_opaque_if_every_pixel_is() -> None:
    data = IMAGE.data.copy()
    assert Texture(Pixels(data)).is_opaque

    data[3, 3, 3] = 254

    assert not Texture(Pixels(data)).is_opaque
