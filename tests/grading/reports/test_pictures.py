import base64
import io
from pathlib import Path

import pytest
from PIL import Image

from sketchkit.grading.reports.pictures import picture_uri, thumbnail_uri


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    results = tmp_path / "results"
    results.mkdir()
    Image.new("RGB", (640, 320), "#c02010").save(results / "red.png")
    Image.new("RGB", (4, 4)).save(tmp_path / "outside.png")
    (results / "broken.png").write_bytes((results / "red.png").read_bytes()[:60])
    (results / "text.png").write_text("<script>")
    return results


def content(uri: str, kind: str) -> bytes:
    head, _, data = uri.partition(",")
    assert head == f"data:image/{kind};base64"
    return base64.b64decode(data)


def test_picture_is_whole_in_its_address(folder: Path) -> None:
    uri = picture_uri(folder, Path("red.png"))

    assert content(uri, "png") == (folder / "red.png").read_bytes()


def test_thumbnail_is_small_and_looks_the_same(folder: Path) -> None:
    data = content(thumbnail_uri(folder, Path("red.png")), "webp")

    image = Image.open(io.BytesIO(data)).convert("RGB")

    assert image.size == (160, 80)
    assert max(abs(a - b) for a, b in zip(image.getpixel((80, 40)), (192, 32, 16), strict=True)) < 6
    assert len(data) < 2000


@pytest.mark.parametrize(
    "picture",
    [None, Path("none.png"), Path("../outside.png"), Path("text.png"), Path(".")],
    ids=["none", "missing", "outside", "no picture", "folder"],
)
def test_what_is_no_picture_of_the_results_has_no_address(
    folder: Path, picture: Path | None
) -> None:
    assert picture_uri(folder, picture) == ""
    assert thumbnail_uri(folder, picture) == ""


def test_broken_picture_has_no_thumbnail(folder: Path) -> None:
    assert thumbnail_uri(folder, Path("broken.png")) == ""
