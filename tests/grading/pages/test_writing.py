import base64
import hashlib
import io
import re
import sys

import numpy as np
import pytest
from PIL import Image

from sketchkit.core.errors import SketchError
from sketchkit.grading.pages import writing

VALUES = {
    "title": "a.png and b.png",
    "is_alike": False,
    "verdict": "They are not alike.",
    "figures": [("FLIP, mean", "0.200", "at most 0.010")],
    "label": "a.png",
    "submitted_uri": "a.png",
    "expected_uri": "b.png",
    "heat_uri": "",
    "caption": "Turned upside down.",
}


def test_texts_are_escaped() -> None:
    text = writing.page("diff.html.j2", **VALUES | {"caption": "<script>alert(1)</script>"})

    assert "<script>alert" not in text
    assert "&lt;script&gt;alert(1)" in text


def test_address_cannot_leave_its_attribute() -> None:
    text = writing.page("diff.html.j2", **VALUES | {"submitted_uri": '" onerror="alert(1)'})

    assert 'onerror="' not in text


def test_page_allows_its_own_script_and_style_by_hash() -> None:
    text = writing.page("diff.html.j2", **VALUES)

    policy = re.search(r'Content-Security-Policy" content="([^"]*)"', text)
    assert policy
    for element in ("script", "style"):
        (inside,) = re.findall(f"<{element}>(.*?)</{element}>", text, re.DOTALL)
        digest = base64.b64encode(hashlib.sha256(inside.encode()).digest()).decode()
        allowed = policy[1].replace("&#39;", "'").replace("&#34;", '"')
        assert f"{element}-src 'sha256-{digest}'" in allowed


def test_missing_value_is_an_error() -> None:
    values = {name: value for name, value in VALUES.items() if name != "caption"}

    with pytest.raises(Exception, match="caption"):
        writing.page("diff.html.j2", **values)


def test_picture_that_is_missing_is_said_to_be() -> None:
    text = writing.page("diff.html.j2", **VALUES | {"submitted_uri": ""})

    assert "No picture was drawn." in text
    assert 'data-view="slider"' not in text.split("<script>")[0]


def test_address_holds_the_whole_picture() -> None:
    pixels = np.arange(24, dtype=np.uint8).reshape(2, 4, 3)

    kind, _, text = writing.data_uri(pixels).partition(",")

    assert kind == "data:image/png;base64"
    assert np.array_equal(np.asarray(Image.open(io.BytesIO(base64.b64decode(text)))), pixels)


def test_without_jinja_it_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "jinja2", None)
    writing._renderer.cache_clear()

    with pytest.raises(SketchError, match=r"sketchkit\[grade\]"):
        writing.page("diff.html.j2", **VALUES)
