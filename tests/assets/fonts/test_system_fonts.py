import shutil
from pathlib import Path

import pytest

from sketchkit.assets.fonts import system_fonts
from sketchkit.assets.fonts.files import file_of

REGULAR = Path(file_of(""))


@pytest.fixture
def fonts(tmp_path, monkeypatch):
    """A computer that has two fonts, and a file that is none."""
    for style in ("Regular", "Bold"):
        name = f"SourceSansPro-{style}.ttf"
        shutil.copy(REGULAR.with_name(name), tmp_path / name)
    (tmp_path / "broken.ttf").write_text("abc")
    monkeypatch.setattr(system_fonts, "font_folders", lambda: [tmp_path])
    system_fonts._fonts.cache_clear()
    yield tmp_path
    system_fonts._fonts.cache_clear()


def test_names_have_the_style_unless_it_is_the_plain_one(fonts):
    assert system_fonts.font_names() == ["Source Sans Pro", "Source Sans Pro Bold"]


@pytest.mark.parametrize(
    "name", ["Source Sans Pro Bold", "SourceSansPro-Bold", "source sans PRO bold"]
)
def test_a_font_is_found_by_its_name(fonts, name):
    assert system_fonts.font_file(name) == str(fonts / "SourceSansPro-Bold.ttf")


def test_what_there_is_not_is_not_found(fonts):
    assert system_fonts.font_file("Wingdings") is None


@pytest.mark.parametrize("platform", ["linux", "darwin", "win32"])
def test_each_system_has_folders_of_its_own_and_of_the_user(platform):
    folders = system_fonts.font_folders(platform)

    assert len(folders) >= 2
    assert all(folder.name.lower() in ("fonts", ".fonts") for folder in folders)
