import pytest

from sketchkit.pymode.reading import text_of


@pytest.mark.parametrize(
    ("data", "text"),
    [
        pytest.param(b"x = 1\r\ny = 2\r\n", "x = 1\ny = 2\n", id="lines of Windows"),
        pytest.param(b"x = 1\ry = 2", "x = 1\ny = 2", id="lines of old Macs"),
        pytest.param(b"\xef\xbb\xbfx = 1", "x = 1", id="byte order mark"),
        pytest.param("x = 'é'".encode(), "x = 'é'", id="UTF-8 without a coding line"),
        pytest.param(b"# coding: latin-1\nx = '\xe9'", "# coding: latin-1\nx = 'é'", id="coding"),
        pytest.param(b"x = '\xe9'", "x = 'é'", id="neither UTF-8 nor a coding line"),
        pytest.param(
            b"if x:\n\ty = 1\n        z = 2", "if x:\n        y = 1\n        z = 2", id="tab"
        ),
        pytest.param(b"if x:\n    \ty = 1", "if x:\n        y = 1", id="tab behind spaces"),
        pytest.param(b'x = """\n\ta\n"""', 'x = """\n\ta\n"""', id="tab inside a text"),
        pytest.param(b"# it's\n\tx = 'a\tb'", "# it's\n        x = 'a\tb'", id="tab in a line"),
        pytest.param(b"x = 1 + \\  \n2", "x = 1 + \\\n2", id="spaces behind a backslash"),
        pytest.param(b'"""\\ \n"""', '"""\\ \n"""', id="backslash inside a text"),
    ],
)
def test_file_becomes_text_that_python_3_reads(data: bytes, text: str) -> None:
    assert text_of(data) == text


def test_unknown_encoding_is_a_syntax_error() -> None:
    with pytest.raises(SyntaxError, match="martian"):
        text_of(b"# coding: martian\n")
