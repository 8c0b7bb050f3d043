"""From a pixel to the line that drew it, frame by frame, with the CPU renderer."""

from __future__ import annotations

from pathlib import Path

import pytest

from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.runtime.explore.inspection import (
    Inspection,
    OutsideError,
    as_value,
    inspect,
    report,
)
from sketchkit.runtime.headless import Launch
from tests.runtime.sketches import Remarks, written


def looked_at(
    folder: Path, text: str, *places: tuple[int, int], frame: int = 1
) -> list[Inspection]:
    launch = Launch(written(folder, text), Remarks().tell)
    return inspect(launch, frame, places, CpuBackend())


def lines(found: list[Inspection]) -> list[int]:
    return [own.answer.line if own.answer else 0 for own in found]


def others(found: Inspection) -> list[tuple[int, str]]:
    return [(own.line, reason) for own, reason in found.beneath()]


FLAT = """\
def setup():
    size(100, 100)
def mark(x):
    rect(x, 10, 20, 20)
def draw():
    background(255)
    noStroke()
    fill(255, 0, 0)
    for i in range(3):
        mark(10 + 30 * i)
    fill(0, 0, 255, 128)
    rect(0, 20, 100, 5)
"""


def test_call_is_named_with_the_functions_that_led_to_it(tmp_path: Path) -> None:
    [found] = looked_at(tmp_path, FLAT, (45, 12))

    assert found.answer is not None
    assert [(site.line, site.function) for site in found.answer.sites] == [
        (4, "mark"),
        (10, "draw"),
    ]
    assert found.answer.which == (2, 3)
    assert found.answer.paint.fill == (255, 0, 0, 255)


def test_what_is_translucent_leaves_what_is_beneath_visible(tmp_path: Path) -> None:
    [found] = looked_at(tmp_path, FLAT, (15, 22))

    assert lines([found]) == [12]
    assert others(found) == [
        (4, "visible, 50 % of the colour"),
        (6, "hidden: painted over by sketch.py, line 4: rect(x, 10, 20, 20)"),
    ]


def test_background_is_what_is_left(tmp_path: Path) -> None:
    assert lines(looked_at(tmp_path, FLAT, (1, 1))) == [6]


def test_recursion_is_counted(tmp_path: Path) -> None:
    text = """\
        def dot(n):
            if n == 0:
                square(10, 10, 50)
            else:
                dot(n - 1)
        def setup():
            size(100, 100)
        def draw():
            dot(3)
        """

    [found] = looked_at(tmp_path, text, (30, 30))

    assert found.answer is not None
    assert [(site.line, site.times) for site in found.answer.sites] == [(3, 1), (5, 3), (9, 1)]


def test_line_of_a_module_beside_the_sketch_is_named(tmp_path: Path) -> None:
    written(tmp_path, "def blot():\n    square(10, 10, 50)\n", "blots.py")

    [found] = looked_at(tmp_path, "import blots\nsize(100, 100)\nblots.blot()\n", (30, 30), frame=0)

    assert found.answer is not None
    assert [site.place for site in found.answer.sites] == ["blots.py, line 2", "sketch.py, line 3"]


SOLID = """\
def setup():
    size(100, 100, P3D)
def draw():
    background(255)
    noStroke()
    fill(255, 0, 0)
    rect(20, 20, 60, 60)
    pushMatrix()
    translate(0, 0, -20)
    fill(0, 255, 0)
    rect(0, 0, 100, 100)
    popMatrix()
    hint(DISABLE_DEPTH_TEST)
    translate(0, 0, -40)
    fill(0, 0, 255)
    rect(50, 50, 20, 20)
"""


def test_what_lies_behind_in_depth_is_said_to(tmp_path: Path) -> None:
    [found] = looked_at(tmp_path, SOLID, (30, 30))

    assert lines([found]) == [7]
    assert (11, "hidden: behind sketch.py, line 7: rect(20, 20, 60, 60)") in others(found)


def test_without_depth_test_the_last_call_wins(tmp_path: Path) -> None:
    [found] = looked_at(tmp_path, SOLID, (55, 55))

    assert lines([found]) == [16]
    assert found.answer is not None
    assert found.answer.depth.startswith("not compared")
    assert found.answer.doing == "moved by (0, 0, -40)"


def test_matrix_is_told_without_the_camera(tmp_path: Path) -> None:
    text = """\
        size(100, 100, P3D)
        lights()
        translate(50, 50, 10)
        rotateY(radians(30))
        scale(2)
        with pushMatrix():
            box(20)
        """

    [found] = looked_at(tmp_path, text, (50, 50), frame=0)

    assert found.answer is not None
    assert found.answer.doing == "moved by (50, 50, 10), turned by 30 degrees about y, scaled by 2"
    assert found.answer.nesting == 1
    assert found.answer.lights is not None
    assert len(found.answer.lights) == 2


CANVASES = """\
def setup():
    global pg
    size(100, 100)
    pg = createGraphics(40, 40)
def draw():
    background(200)
    with pg:
        pg.background(0, 0, 90)
        pg.noStroke()
        pg.rect(10, 10, 20, 20)
    image(pg, 50, 0)
    with pg:
        pg.background(90, 0, 0)
    image(pg, 50, 50)
"""


def test_canvas_is_looked_into_as_it_was_when_it_was_drawn(tmp_path: Path) -> None:
    found = looked_at(tmp_path, CANVASES, (65, 15), (52, 2), (65, 65))

    inner = [own.inner for own in found if own.inner]

    assert lines(found) == [11, 11, 14]
    assert lines(inner) == [10, 8, 13]
    assert [own.place for own in inner] == [(15, 15), (2, 2), (15, 15)]


def test_part_of_a_group_is_traced_to_where_it_was_made(tmp_path: Path) -> None:
    text = """\
        def setup():
            global group
            size(100, 100, P2D)
            group = createShape(GROUP)
            group.addChild(createShape(RECT, 0, 0, 20, 20))
            group.addChild(createShape(RECT, 40, 0, 20, 20))
        def draw():
            background(255)
            shape(group, 10, 10)
        """

    found = looked_at(tmp_path, text, (20, 20), (60, 20))

    assert lines(found) == [9, 9]
    assert [own.answer.made[0].line for own in found if own.answer] == [5, 6]


def test_shape_is_told_from_its_beginShape_on(tmp_path: Path) -> None:
    text = """\
        size(100, 100)
        beginShape()
        vertex(10, 10)
        vertex(90, 10)
        vertex(90, 90)
        endShape()
        """

    [found] = looked_at(tmp_path, text, (70, 30), frame=0)

    assert found.answer is not None
    assert (found.answer.began, found.answer.line) == (2, 6)


def test_pixels_that_were_set_lead_to_their_line(tmp_path: Path) -> None:
    text = """\
        size(100, 100)
        background(0)
        circle(80, 80, 20)
        loadPixels()
        for i in range(100):
            pixels[i] = color(255, 0, 0)
        updatePixels()
        set(50, 50, color(0, 255, 0))
        """

    found = looked_at(tmp_path, text, (5, 0), (50, 50), (80, 80), (5, 5), frame=0)

    assert lines(found) == [6, 8, 3, 2]


def test_pixels_that_are_set_at_once_lead_to_their_line(tmp_path: Path) -> None:
    text = """\
        size(100, 100)
        background(0)
        loadPixels()
        np_pixels[10:20] = 255
        pixels[3:6] = [color(255, 0, 0)] * 3
        updatePixels()
        """

    assert lines(looked_at(tmp_path, text, (5, 15), (5, 0), (6, 0), frame=0)) == [6, 5, 2]


def test_filter_is_the_call_that_changed_the_pixel(tmp_path: Path) -> None:
    text = "size(100, 100)\nbackground(0)\nrect(10, 10, 50, 50)\nfilter(INVERT)\n"

    assert lines(looked_at(tmp_path, text, (30, 30), frame=0)) == [4]


def test_letters_lead_to_their_text(tmp_path: Path) -> None:
    text = 'size(100, 100)\nbackground(255)\ntextSize(80)\nfill(0)\ntext("I", 40, 80)\n'

    [found] = looked_at(tmp_path, text, (49, 50), frame=0)

    assert lines([found]) == [5]


def test_trail_without_background_is_found_in_its_frame(tmp_path: Path) -> None:
    text = """\
        def setup():
            size(100, 100)
        def draw():
            square(frameCount * 20, 10, 15)
        """

    found = looked_at(tmp_path, text, (25, 15), (85, 15), frame=4)

    assert [own.answer.frame for own in found if own.answer] == [1, 4]


def test_hidden_by_clip_and_by_alpha_are_told_apart(tmp_path: Path) -> None:
    text = """\
        size(100, 100)
        background(255)
        noStroke()
        clip(0, 0, 10, 10)
        rect(0, 0, 100, 100)
        noClip()
        fill(0, 0)
        rect(0, 0, 100, 100)
        """

    [found] = looked_at(tmp_path, text, (50, 50), frame=0)

    assert lines([found]) == [2]
    assert others(found)[:2] == [
        (8, "invisible: its alpha is 0 here"),
        (5, "hidden: cut off by clip()"),
    ]


def test_smooth_edge_belongs_to_whom_most_of_its_samples_show(tmp_path: Path) -> None:
    text = """\
        size(100, 100, P2D)
        background(255)
        noStroke()
        translate({x}, 0)
        rotate(0.0001)
        rect(0, 0, 50, 90)
        """

    [mostly] = looked_at(tmp_path, text.format(x=10.1), (10, 50), frame=0)
    [hardly] = looked_at(tmp_path, text.format(x=10.7), (10, 50), frame=0)

    assert lines([mostly, hardly]) == [6, 2]


@pytest.mark.parametrize("sketch", ["table_and_lamp", "textured_cube", "tree", "poster"])
def test_pixels_are_painted_as_the_renderer_paints_them(sketch: str) -> None:
    path = Path(__file__).parents[3] / "sketches" / f"{sketch}.py"
    places = [(37 * i % 300, 53 * i % 200) for i in range(40)]

    found = inspect(Launch(path, Remarks().tell), 2, places, CpuBackend())

    assert [own.found.color[:3] for own in found] == [own.color[:3] for own in found]


def test_report_names_the_call_first(tmp_path: Path) -> None:
    [found] = looked_at(tmp_path, FLAT, (15, 12))

    said = report(found, "sketch.py")

    assert said[0] == "sketch.py, frame 1, pixel 15, 12: 255, 0, 0 (#FF0000)"
    assert said[2] == "Drawn by sketch.py, line 4: rect(x, 10, 20, 20)    (in mark())"
    assert said[3] == "    mark() was called in draw(), sketch.py, line 10"


def test_json_has_the_same(tmp_path: Path) -> None:
    [found] = looked_at(tmp_path, FLAT, (15, 12))

    value = as_value(found)

    drawn = value["drawn_by"]
    assert isinstance(drawn, dict)
    assert (drawn["line"], drawn["function"], drawn["fill"]) == (4, "mark", (255, 0, 0, 255))
    assert value["color"] == [255, 0, 0, 255]


def test_pixel_outside_is_refused(tmp_path: Path) -> None:
    with pytest.raises(OutsideError, match="100 x 100"):
        looked_at(tmp_path, FLAT, (100, 0))
