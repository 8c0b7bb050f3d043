from pathlib import Path

import pytest

from sketchkit.runtime import filming
from sketchkit.runtime.filming import Filming
from tests.assets.movies.films import flat, pictures


@pytest.fixture
def said(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """What is told; and there is no PyAV, so that films are GIFs."""
    monkeypatch.setattr(filming.importlib.util, "find_spec", lambda name: None)
    return []


def test_film_lasts_as_long_as_it_was_shown(tmp_path: Path, said: list[str]) -> None:
    shooting = Filming(tmp_path, said.append)

    shooting.toggle(20)
    for number, now_s in enumerate((7.0, 7.05, 7.2, 7.21)):
        shooting.add(flat(number), now_s)
    shooting.toggle(20)

    # The second is shown from 0.05 to 0.2 s. The last one came too soon after the third.
    assert [lasts for _, lasts in pictures(tmp_path / "movie-0001.gif")] == [50, 150, 50]
    assert said == ["Filming movie-0001.gif. The same key ends it.", "movie-0001.gif: 0.2 seconds."]


def test_films_are_numbered(tmp_path: Path, said: list[str]) -> None:
    (tmp_path / "movie-0001.mp4").touch()
    shooting = Filming(tmp_path, said.append)

    for _ in range(2):
        shooting.toggle(30)
        shooting.add(flat(0), 0)
        shooting.stop()

    names = sorted(path.name for path in tmp_path.iterdir())
    assert names == ["movie-0001.mp4", "movie-0002.gif", "movie-0003.gif"]


def test_nothing_is_filmed_before_it_begins(tmp_path: Path, said: list[str]) -> None:
    shooting = Filming(tmp_path, said.append)

    shooting.add(flat(0), 0)
    shooting.stop()

    assert (shooting.is_on, list(tmp_path.iterdir()), said) == (False, [], [])


def test_film_that_cannot_be_written_is_told(tmp_path: Path, said: list[str]) -> None:
    (tmp_path / "file").touch()
    shooting = Filming(tmp_path / "file", said.append)

    shooting.toggle(30)

    assert not shooting.is_on
    assert said[0].startswith("movie-0001.gif cannot be written: ")
