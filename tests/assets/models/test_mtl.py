import pytest

from sketchkit.assets.models.mtl import read_mtl
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from tests.assets.models.model_files import DATA, written


def materials_of(folder, text):
    return read_mtl(written(folder, "a.mtl", text))


def test_colours_and_numbers_of_a_material():
    brick = read_mtl(DATA / "house.mtl")[1]

    assert brick.ambient == (0.1, 0.2, 0.3)
    assert brick.diffuse == (0.8, 0.2, 0.1)
    assert brick.specular == (0.9, 0.7, 0.5)
    assert (brick.shininess, brick.opacity, brick.texture) == (30, 0.5, None)


def test_options_of_a_texture_are_passed_over_and_tr_is_what_is_not_opaque():
    sign = read_mtl(DATA / "house.mtl")[2]

    assert sign.texture == DATA / "sign.png"
    assert sign.opacity == 0.75


def test_what_is_not_said_is_processings_gray():
    plaster = read_mtl(DATA / "house.mtl")[0]

    assert plaster.ambient == plaster.specular == (0.5, 0.5, 0.5)
    assert (plaster.shininess, plaster.opacity) == (0, 1)


@pytest.mark.parametrize("before", ["# made by hand\n", "\n", "Kd 1 0 0\n"])
def test_a_line_before_the_first_newmtl_makes_a_material(tmp_path, before):
    names = [material.name for material in materials_of(tmp_path, before + "newmtl red\n")]

    assert names == ["material0", "red"]


def test_lines_with_too_few_numbers_change_nothing(tmp_path):
    (red,) = materials_of(tmp_path, "newmtl red\nKd 1 0\nNs\nd\nmap_Kd\n")

    assert (red.diffuse, red.shininess, red.opacity) == ((0.5, 0.5, 0.5), 0, 1)


@pytest.mark.parametrize("line", ["Kd 1 x 0", "Ns x", "d x", "Tr x"])
def test_a_number_that_cannot_be_read_is_told_with_its_line(tmp_path, line):
    with pytest.raises(SketchError, match=r"a\.mtl, line 2: 'x' is no number"):
        materials_of(tmp_path, f"newmtl red\n{line}\n")


def test_a_missing_texture_is_a_warning(tmp_path):
    with pytest.warns(SketchWarning, match=r"a\.mtl, line 2: there is no picture gone\.png"):
        (red,) = materials_of(tmp_path, "newmtl red\nmap_Kd gone.png\n")

    assert red.texture is None


@pytest.mark.parametrize(
    "words",
    ["my wood.png", "-o 0.5 my wood.png", "-bm 1 -s 1 2 3 my wood.png", "textures\\my wood.png"],
)
def test_the_name_of_a_texture_may_have_spaces(tmp_path, words):
    written(tmp_path, "my wood.png", b"picture")

    (red,) = materials_of(tmp_path, f"newmtl red\nmap_Kd {words}\n")

    assert red.texture.name == "my wood.png"


def test_a_picture_as_library_is_refused(tmp_path):
    with pytest.raises(SketchError, match="so it is no MTL file"):
        materials_of(tmp_path, (DATA / "sign.png").read_bytes())
