import gzip
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.assets.svg.drawing import load_svg
from sketchkit.core import constants as c
from sketchkit.core.errors import SketchError

DATA = Path(__file__).parent / "data"
KINDS = (DATA / "kinds.svg").read_bytes()


def drawing(folder, body, attributes='width="100" height="100"'):
    path = folder / "drawing.svg"
    path.write_text(f"<svg {attributes}>{body}</svg>")
    return load_svg(path)


def every(node):
    yield node
    for child in node.children:
        yield from every(child)


def named(node, name):
    return next(found for found in every(node) if found.name == name)


@pytest.fixture(scope="module")
def kinds():
    return load_svg(DATA / "kinds.svg")


def test_a_drawing_has_its_size_and_fits_its_view_box_in(kinds):
    assert (kinds.width, kinds.height) == (200, 200)
    assert kinds.root.matrix[:8] == (2, 0, 0, 0, 0, 2, 0, 0)


# Children, kinds and numbers are those of getChildCount(), getKind() and getParams().


def test_definitions_gradients_and_texts_count_as_children_and_titles_do_not(kinds):
    assert len(kinds.root.children) == 15
    assert [child.kind for child in named(kinds.root, "definitions").children] == [c.GROUP, c.RECT]
    assert [child.kind for child in named(kinds.root, "words").children] == [c.GROUP]


@pytest.mark.parametrize(
    ("name", "kind", "numbers"),
    [
        ("defined", c.RECT, (90, 90, 10, 10)),
        ("disc", c.ELLIPSE, (35, 55, 10, 10)),
        ("egg", c.ELLIPSE, (49, 57, 12, 6)),
        ("stick", c.LINE, (65, 55, 75, 65)),
        ("round", c.RECT, (90, 55, 8, 10, 2)),
        ("flat", c.GROUP, ()),
        ("picture", c.RECT, (1, 2, 10, 10)),
    ],
)
def test_simple_shapes_are_numbers(kinds, name, kind, numbers):
    node = named(kinds.root, name)

    assert (node.kind, node.numbers) == (kind, numbers)


def test_a_shape_of_a_group_within_a_group_has_its_name(kinds):
    (inner,) = named(kinds.root, "nested").children
    (deep,) = inner.children

    assert (inner.name, deep.name) == (None, "deep")


def test_names_that_illustrator_has_changed_are_put_right(kinds):
    assert named(kinds.root, "a b").matrix[:8] == (2, 0, 0, 3, 0, 2, 0, 4)


def test_what_is_not_drawn_is_remarked_upon_with_its_line(kinds):
    assert kinds.remarks == (
        "kinds.svg, line 19: <text> is not drawn; a drawing program can turn it into paths.",
    )


def test_without_a_size_the_view_box_gives_it_and_its_origin_does_not_count(tmp_path):
    svg = drawing(tmp_path, "", 'viewBox="10 20 30,40"')

    assert (svg.width, svg.height, svg.root.matrix) == (30, 40, None)


def test_a_view_box_is_moved_to_the_corner(tmp_path):
    svg = drawing(tmp_path, "", 'width="2in" height="50%" viewBox="10 20 90 50"')

    assert (svg.width, svg.height) == (180, 50)
    assert svg.root.matrix[:8] == (2, 0, 0, -20, 0, 1, 0, -20)


def test_without_any_size_it_is_1_and_remarked_upon(tmp_path):
    svg = drawing(tmp_path, "", "")

    assert (svg.width, svg.height) == (1, 1)
    assert svg.remarks == (
        "drawing.svg, line 1: The drawing has no width and height; 1 is taken for both.",
    )


def test_styles_are_handed_down_through_groups(tmp_path):
    svg = drawing(
        tmp_path,
        '<g stroke="#102030" stroke-width="3"><g fill="none"><rect id="r" width="1" height="1"/>'
        "</g></g>",
    )

    style = named(svg.root, "r").style
    assert (style.fill, style.stroke, style.stroke_weight) == (None, 0xFF102030, 3)


def test_a_hidden_element_is_in_the_tree(tmp_path):
    svg = drawing(tmp_path, '<g id="g" display="none"><circle r="3"/></g>')

    assert not named(svg.root, "g").is_visible
    assert len(named(svg.root, "g").children) == 1


def test_a_fill_finds_the_gradient_that_came_before_it(tmp_path):
    gradient = '<linearGradient id="dawn" x2="10"><stop offset="1" stop-color="red"/>'
    svg = drawing(
        tmp_path,
        '<circle id="early" fill="url(#dawn)"/>'
        f'{gradient}</linearGradient><circle id="late" fill="url(#dawn)"/>',
    )

    early, late = named(svg.root, "early").style, named(svg.root, "late").style
    assert early.fill_gradient is None
    assert late.fill_gradient.geometry == (0, 0, 10, 0)
    assert early.fill == late.fill == 0  # not seen in P2D
    assert svg.remarks == (
        "drawing.svg, line 1: url(#dawn) is no gradient that stands before it, and is not drawn.",
    )


def test_a_copy_is_a_group_with_the_shape_without_its_name(tmp_path):
    svg = drawing(
        tmp_path,
        '<defs><circle id="dot" r="2"/></defs><use id="u" xlink:href="#dot" x="5" y="6"/>',
    )

    copy = named(svg.root, "u")
    assert copy.matrix[:8] == (1, 0, 0, 5, 0, 1, 0, 6)
    assert [(child.kind, child.name) for child in copy.children] == [(c.ELLIPSE, None)]


@pytest.mark.parametrize(("reference", "is_visible"), [("dot", False), ("other", True)])
def test_definitions_are_drawn_as_in_processing_unless_they_are_copied(
    tmp_path, reference, is_visible
):
    svg = drawing(
        tmp_path, f'<defs id="d"><circle id="dot" r="2"/></defs><use href="#{reference}"/>'
    )

    assert named(svg.root, "d").is_visible == is_visible


def test_a_symbol_is_drawn_where_it_is_copied_in_the_size_of_the_copy(tmp_path):
    svg = drawing(
        tmp_path,
        '<symbol id="s" viewBox="0 0 10 10"><rect width="10" height="10"/></symbol>'
        '<use href="#s" x="5" y="6" width="20" height="30"/>',
    )

    (copy,) = svg.root.children
    assert copy.matrix[:8] == (1, 0, 0, 5, 0, 1, 0, 6)
    assert copy.children[0].matrix[:8] == (2, 0, 0, 0, 0, 3, 0, 0)


def test_a_drawing_in_the_drawing_is_a_group(tmp_path):
    svg = drawing(
        tmp_path, '<svg id="s" x="10%" y="5" width="50%" height="10" viewBox="0 0 25 10"/>'
    )

    assert named(svg.root, "s").matrix[:8] == (2, 0, 0, 10, 0, 1, 0, 5)


def test_a_gzipped_file_is_read_whatever_its_name(tmp_path):
    path = tmp_path / "drawing.svg"
    path.write_bytes(gzip.compress(KINDS))

    assert len(load_svg(path).root.children) == 15


@pytest.mark.parametrize(
    ("body", "problem"),
    [
        ('\n<path d="M 1 2 X 3"/>', "line 2: in <path>, its path cannot be read after 'M 1 2'."),
        ('<circle r="big"/>', "line 1: in <circle>, 'big' is no length: 10, 10px, 10mm or 10%"),
        ('<g transform="turn(3)"/>', "line 1: in <g>, 'turn(3)' is no transform."),
        ('<svg viewBox="1 2 3"/>', "line 1: in <svg>, viewBox takes four numbers: left, top,"),
        ('<g fill="#12x"/>', "line 1: in <g>, '#12x' is no colour: #c60, #cc6600 or rgb("),
        ("\n<g>\n", "line 3: an element is not closed before the one around it."),
        ('<g id="a"><use href="#a"/></g>', "line 1: <use> copies what it is part of."),
    ],
)
def test_what_is_wrong_is_told_with_file_and_line(tmp_path, body, problem):
    with pytest.raises(SketchError) as caught:
        drawing(tmp_path, body)

    assert caught.value.problem.startswith(f"{tmp_path / 'drawing.svg'}, {problem}")


def test_a_web_page_is_told_as_one(tmp_path):
    path = tmp_path / "tree.svg"
    path.write_text("<html></html>")

    with pytest.raises(SketchError, match="it is a web page, not an SVG file"):
        load_svg(path)


def test_copies_of_copies_of_copies_are_refused(tmp_path):
    laughs = "".join(f'<g id="a{n}">{10 * f"""<use href="#a{n - 1}"/>"""}</g>' for n in range(1, 9))

    with pytest.raises(SketchError, match="<use> makes more than 100000 copies"):
        drawing(tmp_path, f'<g id="a0"><rect/></g>{laughs}')


@given(
    cut=st.integers(0, len(KINDS)),
    length=st.integers(0, 12),
    put=st.text(alphabet="<>&\"'/ =#%.-0e9aZz;:(),ég", max_size=6),
)
def test_any_damage_is_read_or_told_as_one_sentence(tmp_path_factory, cut, length, put):
    path = tmp_path_factory.getbasetemp() / "damaged.svg"
    path.write_bytes(KINDS[:cut] + put.encode() + KINDS[cut + length :])

    problem, nodes = "", []
    try:
        nodes = list(every(load_svg(path).root))
    except SketchError as error:
        problem = error.problem

    assert nodes or problem.startswith(f"{path}, line ")
    assert "\n" not in problem
    assert all(np.isfinite(node.outline.vertices).all() for node in nodes if node.outline)
