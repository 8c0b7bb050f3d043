"""Many shapes go out in few draws, whatever changes between them."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import (
    ADD,
    BLEND,
    DISABLE_DEPTH_TEST,
    P2D,
    P3D,
    RGB,
    ROUND,
    SQUARE,
    TRIANGLES,
)
from tests.canvases import drawn, draws, new_canvas

MOST_DRAWS = 4
SIZE = (640, 480)


def rects(g: PGraphics) -> None:
    g.noStroke()
    for i in range(10_000):
        g.fill(i & 255, (i * 7) & 255, (i * 13) & 255)
        g.rect((i * 37) % 640, (i * 53) % 480, 8, 8)


def stroked_rects(g: PGraphics) -> None:
    for i in range(1_000):
        g.fill(i & 255, 0, 0)
        g.strokeWeight(1 + i % 3)
        g.rect((i * 37) % 640, (i * 53) % 480, 8, 8)


def ellipses(g: PGraphics) -> None:
    g.noStroke()
    for i in range(10_000):
        g.fill(i & 255, (i * 7) & 255, (i * 13) & 255)
        g.ellipse((i * 37) % 640, (i * 53) % 480, 2 + i % 40, 10)


def lines(g: PGraphics) -> None:
    g.strokeWeight(2)
    for i in range(10_000):
        g.strokeCap(ROUND if i % 2 else SQUARE)
        x, y = (i * 37) % 640, (i * 53) % 480
        g.line(x, y, x + 24, y + i % 17)


def turned_boxes(g: PGraphics) -> None:
    g.lights()
    for i in range(1_000):
        with g.pushMatrix():
            g.translate((i * 37) % 640, (i * 53) % 480, -(i % 50))
            g.rotateX(i * 0.01)
            g.fill(i & 255, 200, 100)
            g.shininess(1 + i % 5)
            g.box(12)


def triangles(g: PGraphics) -> None:
    for i in range(1_000):
        g.beginShape(TRIANGLES)
        for x, y in ((0, 0), (4, 0), (0, 4)):
            g.fill(i & 255, x, y)
            g.vertex(i % 640 + x, i % 480 + y)
        g.endShape()


def alternating_kinds(g: PGraphics) -> None:
    for i in range(500):
        x, y = (i * 37) % 640, (i * 53) % 480
        g.rect(x, y, 9, 5)
        g.circle(x, y, 7)
        g.line(x, y, x + 9, y)
        g.point(x, y)
        g.triangle(x, y, x + 5, y, x, y + 5)


@pytest.mark.parametrize(
    ("renderer", "workload"),
    [
        (P2D, rects),
        (P2D, stroked_rects),
        (P2D, ellipses),
        (P2D, lines),
        (P2D, triangles),
        (P2D, alternating_kinds),
        (P3D, rects),
        (P3D, lines),
        (P3D, turned_boxes),
        (P3D, alternating_kinds),
    ],
    ids=lambda value: value.__name__ if callable(value) else value[-2:],
)
def test_shapes_go_out_in_few_draws(renderer: str, workload: Callable[[PGraphics], None]) -> None:
    canvas = new_canvas(renderer, size=SIZE)
    canvas.background(200)
    workload(canvas)

    assert 1 <= len(draws(drawn(canvas))) <= MOST_DRAWS


def test_image_drawn_many_times_is_one_draw() -> None:
    canvas = new_canvas(P2D, size=SIZE)
    picture = canvas.createImage(8, 8, RGB)
    for i in range(1_000):
        canvas.tint(i & 255, 255, 128)
        canvas.image(picture, i % 640, i % 480, 32, 32)

    assert len(draws(drawn(canvas))) == 1


@pytest.mark.parametrize(
    "change",
    [
        lambda g: g.blendMode(ADD),
        lambda g: g.clip(10, 10, 50, 50),
        lambda g: g.hint(DISABLE_DEPTH_TEST),
        lambda g: g.ortho(),
        lambda g: g.lights(),
    ],
    ids=["blendMode", "clip", "hint", "ortho", "lights"],
)
def test_change_of_how_things_are_drawn_begins_a_draw(change: Callable[[PGraphics], None]) -> None:
    canvas = new_canvas(P3D)
    canvas.noStroke()
    canvas.rect(10, 10, 20, 20)
    change(canvas)
    canvas.rect(20, 20, 20, 20)

    assert len(draws(drawn(canvas))) == 2


@pytest.mark.parametrize(
    "change",
    [
        lambda g: g.hint(DISABLE_DEPTH_TEST),
        lambda g: g.blendMode(BLEND),
        lambda g: g.noClip(),
    ],
    ids=["hint", "blendMode", "noClip"],
)
def test_setting_what_is_set_already_begins_none(change: Callable[[PGraphics], None]) -> None:
    canvas = new_canvas(P2D)
    canvas.noStroke()
    canvas.rect(10, 10, 20, 20)
    change(canvas)
    canvas.rect(20, 20, 20, 20)

    assert len(draws(drawn(canvas))) == 1
