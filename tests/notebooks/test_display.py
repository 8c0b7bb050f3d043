import io

import numpy as np
import pytest
from PIL import Image

import sketchkit
from tests.notebooks.test_rendering import cell

MAKING = """
def setup():
    global me, picture, page, disc, solid, empty
    size(30, 20, {renderer})
    background(10, 20, 30)
    me = this
    picture = createImage(5, 4, ARGB)
    picture.set(1, 2, color(255, 0, 0, 128))
    page = createGraphics(6, 7)
    with page:
        page.background(0, 0, 200)
    disc = createShape(ELLIPSE, 500, 500, 100, 50)
    disc.setFill(color(255, 0, 0))
    disc.setStroke(False)
    solid = createShape(BOX, 1000) if {is_3d} else None
    empty = createShape(GROUP)
"""


def made(renderer: str = "P2D") -> dict[str, object]:
    """Return a notebook's names after a run: its objects outlive it."""
    namespace = cell(MAKING.format(renderer=renderer, is_3d=renderer == "P3D"))
    sketchkit.render(namespace, frames=0, renderer="cpu")
    return namespace


def seen(thing: object) -> np.ndarray:
    with Image.open(io.BytesIO(thing._repr_png_())) as image:
        return np.asarray(image)


def test_sketch_shows_its_canvas() -> None:
    picture = seen(made()["me"])

    assert picture.shape == (20, 30, 3)
    assert (picture == (10, 20, 30)).all()


def test_image_shows_itself_with_its_alpha() -> None:
    picture = seen(made()["picture"])

    assert picture.shape == (4, 5, 4)
    assert picture[2, 1].tolist() == [255, 0, 0, 128]


def test_canvas_shows_itself() -> None:
    picture = seen(made()["page"])

    assert picture.shape == (7, 6, 4)
    assert picture[0, 0].tolist() == [0, 0, 200, 255]


def test_flat_shape_fills_most_of_a_small_canvas() -> None:
    picture = seen(made()["disc"])

    red = (picture == (255, 0, 0)).all(axis=2)
    columns, rows = np.flatnonzero(red.any(axis=0)), np.flatnonzero(red.any(axis=1))
    assert len(columns) == pytest.approx(240 * 0.85, abs=2)  # the disc is twice as wide as high
    assert len(rows) == pytest.approx(240 * 0.85 / 2, abs=2)
    assert columns.mean() == pytest.approx(119.5, abs=1)


def test_solid_is_seen_whole_and_lit() -> None:
    picture = seen(made("P3D")["solid"])

    assert (picture[[0, -1]] == 255).all()
    assert (picture[:, [0, -1]] == 255).all()
    assert len(np.unique(picture[60:180, 60:180].reshape(-1, 3), axis=0)) > 3  # its sides differ


def test_empty_shape_is_white() -> None:
    assert (seen(made()["empty"]) == 255).all()
