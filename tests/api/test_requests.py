from concurrent.futures import Future

import numpy as np
import pytest
from PIL import Image

from sketchkit.api.requests import RequestedImage
from sketchkit.api.sketch import Sketch
from sketchkit.assets.paths import set_sketch_folder, sketch_folder
from sketchkit.assets.pictures.images import Picture
from sketchkit.core.clock import RealClock
from sketchkit.core.constants import ARGB, RGB
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from sketchkit.stubs import blank_canvas
from tests.api.sketches import new_sketch

RED = np.full((3, 5, 4), (255, 0, 0, 255), np.uint8)


def test_an_image_that_is_not_there_yet_has_no_size_and_shows_nothing():
    image = RequestedImage(Future())

    assert (image.width, image.height, image.format) == (0, 0, ARGB)
    assert not image._texture().data[..., 3].any()


def test_an_image_that_has_come_is_as_if_loaded():
    coming = Future()
    image = RequestedImage(coming)
    before = image._texture()

    coming.set_result(Picture(RED))

    assert (image.width, image.height, image.format) == (5, 3, RGB)
    assert image.get(4, 2) == 0xFFFF0000
    assert image._texture() is not before


def test_what_cannot_be_loaded_is_told_once_and_has_a_size_of_minus_one():
    coming = Future()
    coming.set_exception(SketchError("There is no file cat.png."))
    image = RequestedImage(coming)

    with pytest.warns(SketchWarning, match=r"no file cat\.png"):
        assert image.width == -1

    assert image.height == -1


def test_without_a_window_it_is_loaded_at_once(tmp_path):
    before = sketch_folder()
    set_sketch_folder(tmp_path)
    Image.fromarray(RED).save(tmp_path / "red.png")

    image = new_sketch().requestImage("red.png")

    set_sketch_folder(before)
    assert image.width == 5


def test_in_a_window_it_is_loaded_beside_the_sketch(tmp_path):
    before = sketch_folder()
    set_sketch_folder(tmp_path)
    Image.fromarray(RED).save(tmp_path / "red.png")
    sketch = Sketch(blank_canvas(), clock=RealClock())

    image = sketch.requestImage("red.png")
    image._coming.result(timeout=60)

    set_sketch_folder(before)
    assert image.width == 5
