import gzip

import pytest

from sketchkit.assets.svg.elements import GZIP, SvgError, read_elements


def elements(folder, content):
    path = folder / "drawing.svg"
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return read_elements(path)


def refused(folder, content):
    with pytest.raises(SvgError) as caught:
        elements(folder, content)
    return str(caught.value), caught.value.line


def test_elements_know_their_lines_and_their_texts(tmp_path):
    root = elements(tmp_path, "<svg>\n<g/>\n\n<style>a</style></svg>")

    assert [(child.tag, child.line, child.text) for child in root.children] == [
        ("g", 2, ""),
        ("style", 4, "a"),
    ]


def test_the_prefix_of_svg_is_left_out(tmp_path):
    root = elements(tmp_path, "<svg:svg><svg:g/><inkscape:grid/></svg:svg>")

    assert [root.tag, *(child.tag for child in root.children)] == ["svg", "g", "inkscape:grid"]


def test_plain_entities_such_as_illustrators_are_read(tmp_path):
    root = elements(
        tmp_path,
        '<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/svg11.dtd" '
        '[<!ENTITY blue "#0000ff">]><svg fill="&blue;"/>',
    )

    assert root.get("fill") == "#0000ff"


def test_a_file_in_an_old_encoding_is_read(tmp_path):
    text = '<?xml version="1.0" encoding="windows-1252"?><svg id="Tür"/>'

    assert elements(tmp_path, text.encode("windows-1252")).get("id") == "Tür"


@pytest.mark.parametrize(
    ("declarations", "problem"),
    [
        pytest.param(
            '<!ENTITY x SYSTEM "file:///etc/hostname">',
            "the entity x lies in another file, which is not fetched",
            id="external",
        ),
        pytest.param(
            '<!ENTITY a "ha">\n<!ENTITY x "&a;&a;&a;">',
            "the entity x is more than a short text, and is not read",
            id="billion laughs",
        ),
        pytest.param(
            f'<!ENTITY x "{"ha" * 1000}">',
            "the entity x is more than a short text, and is not read",
            id="quadratic",
        ),
        pytest.param(
            '<!ENTITY % x "ha">',
            "the entity x is more than a short text, and is not read",
            id="parameter",
        ),
        pytest.param(
            '<!ENTITY % x SYSTEM "http://example.com/x">',
            "the entity x lies in another file, which is not fetched",
            id="external parameter",
        ),
    ],
)
def test_entities_that_fetch_or_multiply_are_refused(tmp_path, declarations, problem):
    said, line = refused(tmp_path, f"<!DOCTYPE svg [{declarations}]><svg>&x;</svg>")

    assert (said, line) == (problem, 1 + declarations.count("\n"))


@pytest.mark.parametrize(
    ("content", "problem", "line"),
    [
        ("", "it ends before the drawing is complete", 1),
        ("hello", "it is not XML", 1),
        ("<svg>\n<g></svg>", "an element is not closed before the one around it", 2),
        ("<svg>\n<g", "it ends before the drawing is complete", 2),
        ("<svg>\n a & b</svg>", "it is not XML: a < or & too many, or a quote missing", 2),
        ('<svg id="a" id="b"/>', "an element has the same attribute twice", 1),
        ("<svg>&nope;</svg>", "it uses an entity, &name;, that it does not define", 1),
        ("<svg/><svg/>", "its XML is broken: junk after document element", 1),
        ("<svg>" + "<g>" * 100, "more than 100 elements are nested", 1),
        (
            '<?xml version="1.0" encoding="klingon"?><svg/>',
            "its text cannot be read: unknown encoding: klingon",
            1,
        ),
    ],
)
def test_what_is_no_xml_is_told_with_its_line(tmp_path, content, problem, line):
    assert refused(tmp_path, content) == (problem, line)


@pytest.mark.parametrize(
    "content",
    [gzip.compress(b"<svg/>")[:-9], GZIP + b"no gzip at all", gzip.compress(b" " * (65 << 20))],
    ids=["cut", "no gzip", "bomb"],
)
def test_a_broken_or_huge_archive_is_refused(tmp_path, content):
    said, line = refused(tmp_path, content)

    assert said.startswith(("it cannot be read: ", "it is larger than 64 MB"))
    assert line == 0
