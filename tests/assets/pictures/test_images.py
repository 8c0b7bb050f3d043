import numpy as np
import OpenEXR
import pytest
from PIL import Image

from sketchkit.assets.pictures.images import load_picture
from sketchkit.assets.pictures.radiance import radiance_bytes
from sketchkit.core.errors import SketchError

RED, CLEAR = (255, 0, 0, 255), (0, 0, 0, 0)


def saved(folder, name, picture, **options):
    path = folder / name
    picture.save(path, **options)
    return path


@pytest.mark.parametrize("suffix", ["png", "bmp", "tga", "gif", "webp", "tif"])
def test_every_kind_gives_rgba_top_row_first(tmp_path, suffix):
    picture = Image.new("RGB", (3, 2), (0, 0, 0))
    picture.putpixel((2, 0), RED[:3])
    options = {"lossless": True} if suffix == "webp" else {}

    data = load_picture(saved(tmp_path, f"a.{suffix}", picture, **options)).data

    assert data.shape == (2, 3, 4)
    assert tuple(data[0, 2]) == RED
    assert tuple(data[1, 0]) == (0, 0, 0, 255)


def test_jpeg_is_read_nearly_as_written(tmp_path):
    path = saved(tmp_path, "a.jpg", Image.new("RGB", (16, 16), (200, 100, 50)), quality=95)

    data = load_picture(path).data.astype(int)

    assert np.abs(data - (200, 100, 50, 255)).max() <= 2  # JPEG's own rounding


@pytest.mark.parametrize(
    ("mode", "value", "expected"),
    [
        pytest.param("L", 90, (90, 90, 90, 255), id="gray"),
        pytest.param("LA", (90, 40), (90, 90, 90, 40), id="gray and alpha"),
        pytest.param("1", 1, (255, 255, 255, 255), id="one bit"),
        pytest.param("RGBA", (10, 20, 30, 40), (10, 20, 30, 40), id="straight alpha stays"),
        pytest.param("I;16", 0xABCD, (0xAB, 0xAB, 0xAB, 255), id="16 bits are cut off"),
    ],
)
def test_modes_of_png(tmp_path, mode, value, expected):
    path = saved(tmp_path, "a.png", Image.new(mode, (2, 2), value))

    assert tuple(load_picture(path).data[0, 0]) == expected


def test_a_palette_with_a_transparent_colour(tmp_path):
    picture = Image.new("P", (2, 1))
    picture.putpalette([0, 0, 0, 255, 0, 0])
    picture.putpixel((1, 0), 1)

    data = load_picture(saved(tmp_path, "a.png", picture, transparency=0)).data

    assert tuple(data[0, 0]) == CLEAR
    assert tuple(data[0, 1]) == RED


def test_cmyk_becomes_rgb(tmp_path):
    path = saved(tmp_path, "a.jpg", Image.new("CMYK", (8, 8), (0, 255, 255, 0)), quality=95)

    red, green, blue, alpha = load_picture(path).data[4, 4].tolist()

    assert red > 240
    assert max(green, blue) < 15
    assert alpha == 255


def test_of_an_animation_the_first_frame(tmp_path):
    frames = [Image.new("RGB", (4, 4), color) for color in ((255, 0, 0), (0, 255, 0))]
    path = saved(tmp_path, "a.gif", frames[0], save_all=True, append_images=frames[1:])

    assert tuple(load_picture(path).data[0, 0]) == RED


def test_what_is_no_picture_is_told_with_its_path(tmp_path):
    path = tmp_path / "poem.png"
    path.write_text("roses are red")

    with pytest.raises(SketchError) as caught:
        load_picture(path)

    assert caught.value.problem == f"{path} is no picture that can be read."


def test_a_cut_picture_is_told_as_broken(tmp_path):
    noise = np.random.default_rng(0).integers(0, 255, (64, 64, 3), np.uint8)
    path = saved(tmp_path, "a.png", Image.fromarray(noise))
    path.write_bytes(path.read_bytes()[:3000])

    with pytest.raises(SketchError, match=r"a\.png is broken"):
        load_picture(path)


def test_radiance_is_floats_and_bytes_cut_to_one(tmp_path):
    path = tmp_path / "a.hdr"
    floats = np.array([[[0.5, 4.0, 0.0], [1.0, 0.5, 100.0]]], np.float32)
    path.write_bytes(radiance_bytes(floats))

    picture = load_picture(path)

    assert (picture.floats == floats).all()
    assert picture.data[0].tolist() == [[128, 255, 0, 255], [255, 128, 255, 255]]


def test_exr_is_floats_too(tmp_path):
    floats = np.array([[[0.5, 4.0, 0.0], [1.0, 0.5, 100.0]]], np.float32)
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    OpenEXR.File(header, {"RGB": floats}).write(str(tmp_path / "a.exr"))

    picture = load_picture(tmp_path / "a.exr")

    assert (picture.floats == floats).all()


def test_a_cut_radiance_picture_is_told_as_broken(tmp_path):
    path = tmp_path / "a.hdr"
    path.write_bytes(radiance_bytes(np.ones((9, 9, 3), np.float32))[:-5])

    with pytest.raises(SketchError, match=r"a\.hdr is broken: it ends too early"):
        load_picture(path)
