"""Pictures in which nothing shows, and what is told about them."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent, indent

import pytest

from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.runtime.headless import Launch, render
from tests.runtime.sketches import Remarks, written

FLAT, SOLID = "size(200, 150)", "size(200, 150, P3D)"
IMAGE = "size(200, 150); global img; img = createImage(50, 50, ARGB)"
CANVAS = "size(200, 150); global pg; pg = createGraphics(50, 50)"
SHAPE = "size(200, 150); global s; s = createShape(RECT, 0, 0, 20, 20)"


def told(
    folder: Path, setup: str, draw: str, *, clear: str = "background(255)", frame: int = 1
) -> Remarks:
    body = indent(dedent(draw), "    ")
    text = f"def setup():\n    {setup}\ndef draw():\n    {clear}\n{body}\n"
    remarks = Remarks()
    list(render(Launch(written(folder, text), remarks.tell), [frame], CpuBackend()))
    return remarks


# The first line of draw() after its background() is line 5.
HIDDEN = {
    "text of the background's colour": (
        FLAT,
        "fill(255)\ntext('hello', 50, 50)",
        6,
        "the same colour, 255, 255, 255",
    ),
    "empty text": (FLAT, "text('', 50, 50)", 5, "Its text is empty"),
    "spaces": (FLAT, "text('  ', 50, 50)", 5, "Its text is only spaces"),
    "text nowhere": (FLAT, "text('a', float('nan'), 50)", 5, "NaN"),
    "endless rectangle": (FLAT, "rect(float('inf'), 10, 50, 50)", 5, "or infinite"),
    "invisible shape": (SHAPE, "s.setVisible(False)\nshape(s)", 6, "setVisible(False)"),
    "empty shape": (SHAPE, "t = createShape()\nt.beginShape()\nt.endShape()\nshape(t)", 8, "empty"),
    "shape without colours": (
        SHAPE,
        "noFill()\nnoStroke()\nshape(createShape(RECT, 0, 0, 9, 9), 9, 9)",
        7,
        "in force when it was made",
    ),
    "no vertex": (FLAT, "beginShape()\nendShape()", 6, "There is no vertex"),
    "two vertices": (
        FLAT,
        "beginShape()\nvertex(1, 1)\nvertex(50, 50)\nendShape()",
        8,
        "only 2 vertices",
    ),
    "two of three vertices": (
        FLAT,
        "noStroke()\nbeginShape(TRIANGLES)\nvertex(1, 1)\nvertex(50, 50)\nendShape()",
        9,
        "only 2 of the 3 vertices",
    ),
    "no arc": (FLAT, "arc(50, 50, 40, 40, 2, 1)", 5, "from 2 to 1"),
    "behind": (SOLID, "translate(100, 75, 400)\nbox(40)", 6, "behind the camera"),
    "too near": (
        SOLID,
        "noStroke()\ntranslate(100, 75, 128)\nrect(-5, -5, 9, 9)",
        7,
        "begins 12.99",
    ),
    "too far": (SOLID, "translate(100, 75, -5000)\nbox(500)", 6, "ends 1299.04"),
    "too far in parallel": (SOLID, "ortho()\ntranslate(0, 0, -5000)\nbox(9)", 7, "ends 1299.04"),
    "looking away": (
        SOLID,
        "camera(0, 0, 99, 0, 0, 999, 0, 1, 0)\nbox(20)",
        6,
        "behind the camera",
    ),
    "left": (FLAT, "rect(-100, 10, 50, 50)", 5, "left of the window: there its x is -100 to -50"),
    "right": (FLAT, "circle(300, 10, 50)", 5, "right of the window: there its x is 275 to 325"),
    "above": (FLAT, "fill(0)\ntext('hi', 10, -30)", 6, "above the window"),
    "below": (SOLID, "translate(100, 600)\nbox(40)", 6, "below the window"),
    "alpha 0": (
        FLAT,
        "noStroke()\nfill(255, 0, 0, 0)\nrect(9, 9, 50, 50)",
        7,
        "alpha of its colour is 0",
    ),
    "alpha 1": (FLAT, "noStroke()\nfill(0, 1)\ncircle(50, 50, 30)", 7, "all but transparent"),
    "stroke's alpha 0": (
        FLAT,
        "noFill()\nstroke(0, 0)\ncircle(50, 50, 30)",
        7,
        "alpha of its stroke",
    ),
    "nothing left": (
        FLAT,
        "noFill()\nnoStroke()\nrect(9, 9, 50, 50)",
        7,
        "noFill() and noStroke()",
    ),
    "line without stroke": (FLAT, "noStroke()\nline(0, 0, 99, 99)", 6, "noStroke() is in force"),
    "point without stroke": (SOLID, "noStroke()\npoint(9, 9)", 6, "noStroke() is in force"),
    "weight 0": (FLAT, "noFill()\nstrokeWeight(0)\nrect(9, 9, 9, 9)", 7, "nothing of it is left"),
    "scale 0": (SOLID, "translate(100, 75)\nscale(0)\nbox(40)", 7, "scale(0)"),
    "scale 0 in 2D": (FLAT, "scale(0)\nrect(0, 0, 40, 40)", 6, "scale(0)"),
    "no size": (FLAT, "noStroke()\nfill(0)\nrect(9, 9, 0, 40)", 7, "no size"),
    "radius 0": (SOLID, "noStroke()\nfill(0)\ntranslate(9, 9)\nsphere(0)", 8, "no size"),
    "edge on": (
        SOLID,
        "noStroke()\ntranslate(100, 75)\nrotateY(HALF_PI)\nfill(0)\nsquare(-20, -20, 40)",
        9,
        "edge",
    ),
    "smaller than a pixel": (
        FLAT,
        "noStroke()\nfill(0)\ncircle(50, 50, 0.01)",
        7,
        "smaller than a pixel",
    ),
    "same colour": (FLAT, "noStroke()\nrect(9, 9, 50, 50)", 6, "same colour, 255, 255, 255"),
    "same stroke": (FLAT, "noFill()\nstroke(255)\ncircle(50, 50, 30)", 7, "same colour"),
    "blend mode": (
        FLAT,
        "blendMode(ADD)\nnoStroke()\nfill(200)\nrect(9, 9, 50, 50)",
        8,
        "blendMode(ADD)",
    ),
    "NaN": (FLAT, "circle(float('nan'), 50, 20)", 5, "NaN"),
    "NaN of a vertex": (
        FLAT,
        "beginShape()\nfor i in range(4):\n    vertex(float('nan'), i)\nendShape()",
        8,
        "NaN",
    ),
    "NaN in the matrix": (SOLID, "translate(float('nan'), 0)\nbox(20)", 6, "NaN"),
    "painted over": (
        FLAT,
        "rect(9, 9, 50, 50)\nfill(255)\nnoStroke()\nrect(0, 0, width, height)",
        5,
        "line 8: rect(0, 0",
    ),
    "background after it": (
        FLAT,
        "rect(9, 9, 50, 50)\nbackground(255)",
        5,
        "line 6: background(255)",
    ),
    "clip": (
        FLAT,
        "clip(0, 0, 10, 10)\nrect(50, 50, 50, 50)",
        6,
        "clip(), which lets through 10 x 10",
    ),
    "depth": (
        SOLID,
        "noStroke()\nrect(-200, -200, 600, 600)\nfill(9)\ntranslate(100, 75, -20)\nbox(20)",
        9,
        "behind sketch.py, line 6",
    ),
    "transparent image": (IMAGE, "image(img, 9, 9)", 5, "image is transparent"),
    "canvas never shown": (
        CANVAS,
        "with pg:\n    pg.circle(20, 20, 20)",
        6,
        "never shown: image(pg",
    ),
    "empty canvas": (CANVAS, "with pg:\n    pg.push()\nimage(pg, 9, 9)", 7, "pg is transparent"),
    "beside its canvas": (
        CANVAS,
        "with pg:\n    pg.circle(99, 20, 9)\nimage(pg, 9, 9)",
        6,
        "right of its canvas",
    ),
    "kept shape": (SHAPE, "shape(s, 500, 10)", 5, "right of the window"),
    "in a loop": (
        FLAT,
        "for i in range(30):\n    circle(300 + i, 10, 5)",
        6,
        "nor do the 29 others",
    ),
}


@pytest.mark.parametrize(("setup", "draw", "line", "text"), HIDDEN.values(), ids=HIDDEN.keys())
def test_reason_is_told_at_the_line_of_the_call(
    tmp_path: Path, setup: str, draw: str, line: int, text: str
) -> None:
    [remark] = told(tmp_path, setup, draw)

    assert remark[1] == line
    assert "the whole picture is one colour, 255, 255, 255" in remark[2]
    assert text in remark[2]


@pytest.mark.parametrize(
    "light",
    ["ambientLight(0, 0, 0)", "directionalLight(255, 255, 255, 0, 0, 1)"],
    ids=["black light", "light from behind"],
)
def test_box_without_light_is_black_on_black(tmp_path: Path, light: str) -> None:
    draw = f"noStroke()\n{light}\ntranslate(100, 75)\nbox(40)"

    [(_, line, text)] = told(tmp_path, SOLID, draw, clear="background(0)")

    assert line == 8
    assert "No light reaches" in text


def test_all_calls_are_told_with_their_own_reasons(tmp_path: Path) -> None:
    draw = """\
        rect(-100, 10, 50, 50)
        noStroke()
        fill(0, 0)
        rect(10, 10, 10, 10)
        translate(0, 0, 500)
        fill(1)
        box(10)
        """

    [(_, line, text)] = told(tmp_path, SOLID, draw)

    assert line == 5
    assert "left of the window" in text
    assert "Nor does line 8, rect(10, 10, 10, 10). It is transparent" in text
    assert "Nor does line 11, box(10). It lies behind the camera" in text


def test_what_setup_drew_is_painted_over_by_draw(tmp_path: Path) -> None:
    [(_, line, text)] = told(tmp_path, f"{FLAT}; circle(50, 50, 20)", "pass")

    assert line == 2
    assert "line 4: background(255), in frame 1, after it was drawn in setup()" in text


@pytest.mark.parametrize("frame", [1, 2, 30])
def test_every_picture_that_is_asked_for_is_looked_at(tmp_path: Path, frame: int) -> None:
    assert len(told(tmp_path, FLAT, "rect(-100, 10, 50, 50)", frame=frame)) == 1


SILENT = {
    "background alone": (FLAT, "pass"),
    "shapes that show": (FLAT, "rect(9, 9, 50, 50)"),
    "one shape over all": (FLAT, "noStroke()\nfill(255, 0, 0)\nrect(0, 0, width, height)"),
    "set pixels": (
        FLAT,
        "loadPixels()\nfor i in range(30000):\n    pixels[i] = color(3, 4, 5)\nupdatePixels()",
    ),
    "inside of a box": (SOLID, "noStroke()\nfill(9, 9, 200)\ntranslate(100, 75, 130)\nbox(900)"),
    "flat canvas over all": (
        "size(200, 150); global pg; pg = createGraphics(200, 150)",
        "with pg:\n    pg.background(255, 0, 0)\nimage(pg, 0, 0)",
    ),
    "text that is still to be typed": (FLAT, "text('' if key == '1' else '', 50, 50)"),
    "text among others": (FLAT, "text('', 50, 50)\nrect(9, 9, 50, 50)"),
    "one pixel": (FLAT, "noStroke()\nfill(0)\nrect(100, 70, 1, 1)\nrect(-50, 0, 10, 10)"),
}


@pytest.mark.parametrize(("setup", "draw"), SILENT.values(), ids=SILENT.keys())
def test_nothing_is_told_if_all_is_meant_to_be_so(tmp_path: Path, setup: str, draw: str) -> None:
    assert told(tmp_path, setup, draw) == []


def test_static_picture_of_one_colour_is_meant(tmp_path: Path) -> None:
    remarks = Remarks()
    path = written(tmp_path, "size(200, 150)\nbackground(9)\n")

    list(render(Launch(path, remarks.tell), [0, 1], CpuBackend()))

    assert remarks == []


def test_it_is_told_once(tmp_path: Path) -> None:
    remarks = Remarks()
    path = written(tmp_path, "def setup():\n    size(99, 99)\ndef draw():\n    circle(-50, 0, 9)\n")

    list(render(Launch(path, remarks.tell), [1, 2, 3, 9], CpuBackend()))

    assert len(remarks) == 1
