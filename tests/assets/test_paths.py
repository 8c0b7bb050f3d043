from pathlib import Path

import pytest

from sketchkit.assets.paths import find_file, search_folders, set_sketch_folder, sketch_folder
from sketchkit.core.errors import SketchError


@pytest.fixture
def folder(tmp_path):
    before = sketch_folder()
    set_sketch_folder(tmp_path)
    (tmp_path / "data").mkdir()
    (tmp_path / "beside.txt").write_text("beside")
    (tmp_path / "data" / "inside.txt").write_text("inside")
    (tmp_path / "both.txt").write_text("beside")
    (tmp_path / "data" / "both.txt").write_text("inside")
    yield tmp_path
    set_sketch_folder(before)


@pytest.mark.parametrize(
    ("name", "text"),
    [("beside.txt", "beside"), ("inside.txt", "inside"), ("both.txt", "inside")],
)
def test_data_comes_before_the_sketchs_own_folder(folder, name, text):
    assert find_file("loadStrings", name).read_text() == text


def test_a_full_path_is_taken_as_it_is(folder, tmp_path_factory):
    elsewhere = tmp_path_factory.mktemp("elsewhere") / "far.txt"
    elsewhere.write_text("far")

    assert find_file("loadStrings", str(elsewhere)) == elsewhere


def test_a_missing_file_is_told_with_folders_and_the_nearest_name(folder):
    with pytest.raises(SketchError) as caught:
        find_file("loadImage", "insde.txt")

    assert all(str(place) in caught.value.problem for place in search_folders())
    assert caught.value.got == "loadImage('insde.txt')"
    assert caught.value.hint == "Do you mean 'inside.txt'?"


def test_without_a_near_name_the_data_folder_is_told(folder):
    with pytest.raises(SketchError, match="Put it into the sketch's data folder"):
        find_file("loadImage", "photograph.png")


def test_what_is_no_name_is_refused(folder):
    with pytest.raises(SketchError, match="takes the name of a file"):
        find_file("loadImage", 4)


def test_a_folder_is_no_file(folder):
    with pytest.raises(SketchError, match="no file data"):
        find_file("loadImage", "data")


def test_search_folders_follow_the_sketch(folder):
    assert search_folders() == [folder / "data", folder]
    assert isinstance(folder, Path)
