from __future__ import annotations

import io
from collections.abc import Iterator
from urllib.error import URLError

import pytest

from sketchkit.assets import network
from sketchkit.core.errors import SketchError


@pytest.fixture(autouse=True)
def allowed() -> Iterator[None]:
    network.allow_network(True)
    yield
    network.allow_network(False)


def test_answer_is_returned(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("urllib.request.urlopen", lambda request, timeout: io.BytesIO(b"hello"))

    assert network.fetch("loadStrings", "https://example.org/a.txt") == b"hello"


def test_no_answer_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(request: object, timeout: float) -> None:
        raise URLError("no route")

    monkeypatch.setattr("urllib.request.urlopen", fail)

    with pytest.raises(
        SketchError, match=r"loadStrings\(\) got nothing from example.org: no route"
    ):
        network.fetch("loadStrings", "https://example.org/a.txt")


@pytest.mark.parametrize("name", ["file:///etc/passwd", "a.txt", "ftp://example.org", 3])
def test_only_the_web_is_the_internet(name: object) -> None:
    assert not network.is_address(name)
