import builtins
import importlib.util
import os
import sys
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

from sketchkit.assets.movies.encoder import MovieError
from sketchkit.assets.movies.movie import Movie, is_movie
from tests.assets.movies.films import filmed, flat, pictures, shaded

needs_av = pytest.mark.skipif(importlib.util.find_spec("av") is None, reason="PyAV is not here")


def decoded(path: Path) -> list[np.ndarray]:
    import av

    with av.open(str(path)) as container:
        return [frame.to_ndarray(format="rgb24") for frame in container.decode(video=0)]


@pytest.mark.parametrize("ending", ["png", "apng", "webp"])
def test_frames_of_few_colours_come_back_exactly(tmp_path: Path, ending: str) -> None:
    frames = [flat(number) for number in range(8)]

    filmed(tmp_path / f"film.{ending}", frames, 60)

    found = pictures(tmp_path / f"film.{ending}")
    assert all(np.array_equal(frame, seen) for frame, (seen, _) in zip(frames, found, strict=True))
    assert sum(lasts for _, lasts in found) == pytest.approx(8 * 1000 / 60, abs=0.6)


def test_gif_of_few_colours_is_exact(tmp_path: Path) -> None:
    frames = [flat(number) for number in range(8)]

    filmed(tmp_path / "film.gif", frames, 25)

    found = pictures(tmp_path / "film.gif")
    assert all(np.array_equal(frame, seen) for frame, (seen, _) in zip(frames, found, strict=True))
    assert [lasts for _, lasts in found] == [40] * 8


def test_png_of_many_colours_is_exact(tmp_path: Path) -> None:
    frames = [shaded(number) for number in range(3)]

    filmed(tmp_path / "film.png", frames, 30)

    found = pictures(tmp_path / "film.png")
    assert all(np.array_equal(frame, seen) for frame, (seen, _) in zip(frames, found, strict=True))


def test_webp_of_many_colours_is_close(tmp_path: Path) -> None:
    frames = [shaded(number) for number in range(3)]

    filmed(tmp_path / "film.webp", frames, 30)

    for frame, (seen, _) in zip(frames, pictures(tmp_path / "film.webp"), strict=True):
        assert np.abs(frame.astype(int) - seen).mean() < 3  # of 255; it loses a little


def test_gif_of_many_colours_is_right_on_average(tmp_path: Path) -> None:
    frames = [shaded(number) for number in range(3)]

    filmed(tmp_path / "film.gif", frames, 10)

    for frame, (seen, _) in zip(frames, pictures(tmp_path / "film.gif"), strict=True):
        error = seen.astype(int) - frame
        blocks = error[:48, :64].reshape(6, 8, 8, 8, 3).mean(axis=(1, 3))  # as Bayer's pattern
        assert np.abs(blocks).max() < 8
        assert not error[:10].any()  # a flat area stays exact


def test_gif_does_not_flicker_where_nothing_changes(tmp_path: Path) -> None:
    still, other = shaded(0), shaded(0)
    other[20:30, 20:30] = 0

    filmed(tmp_path / "film.gif", [still, other, still], 10)

    first, second, _ = (seen for seen, _ in pictures(tmp_path / "film.gif"))
    changed = np.zeros((48, 64), bool)
    changed[20:30, 20:30] = True
    assert not (first != second).any(axis=2)[~changed].any()


def test_equal_frames_are_one_that_lasts(tmp_path: Path) -> None:
    frames = [flat(0)] * 5 + [flat(9)] * 2

    for ending in ("gif", "webp", "png"):
        filmed(tmp_path / f"film.{ending}", frames, 25)
        assert [lasts for _, lasts in pictures(tmp_path / f"film.{ending}")] == [200, 80]


def test_gif_keeps_time_at_30_frames_a_second(tmp_path: Path) -> None:
    remark = filmed(tmp_path / "film.gif", [flat(number) for number in range(30)], 30)

    lasts = [lasts for _, lasts in pictures(tmp_path / "film.gif")]
    assert (len(lasts), sum(lasts), set(lasts), remark) == (30, 1000, {30, 40}, None)


def test_gif_of_60_frames_a_second_leaves_frames_out_and_says_so(tmp_path: Path) -> None:
    remark = filmed(tmp_path / "film.gif", [flat(number) for number in range(30)], 60)

    found = pictures(tmp_path / "film.gif")
    assert [lasts for _, lasts in found] == [20] * 25
    assert np.array_equal(found[5][0], flat(6))  # at 0.1 s
    assert "at most 50 frames a second: 5 of 30" in str(remark)


@needs_av
@pytest.mark.parametrize("size", [(64, 48), (61, 41)], ids=["even", "odd"])
def test_mp4_comes_back_nearly_as_it_was(tmp_path: Path, size: tuple[int, int]) -> None:
    frames = [shaded(number, size) for number in range(12)]

    filmed(tmp_path / "film.mp4", frames, 24)

    found = decoded(tmp_path / "film.mp4")
    assert found[0].shape == (size[1] + size[1] % 2, size[0] + size[0] % 2, 3)
    for frame, seen in zip(frames, found, strict=True):
        # Half the colours' resolution is lost by the format, so only the mean is held small.
        assert np.abs(frame.astype(int) - seen[: size[1], : size[0]]).mean() < 5


@needs_av
def test_mp4_keeps_pure_colours(tmp_path: Path) -> None:
    colours = [(255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 255, 255), (0, 0, 0), (128, 64, 32)]
    frames = [np.full((32, 32, 3), colour, np.uint8) for colour in colours]

    filmed(tmp_path / "film.mp4", frames, 24)

    for frame, seen in zip(frames, decoded(tmp_path / "film.mp4"), strict=True):
        assert np.abs(frame.astype(int) - seen).max() <= 4


@needs_av
def test_mp4_is_what_every_player_takes(tmp_path: Path) -> None:
    import av

    filmed(tmp_path / "film.mp4", [flat(number) for number in range(6)], 29.97)

    with av.open(str(tmp_path / "film.mp4")) as container:
        stream = container.streams.video[0]
        assert (stream.codec_context.name, stream.pix_fmt) == ("h264", "yuv420p")
        assert abs(stream.average_rate - Fraction(2997, 100)) < Fraction(1, 100)


@needs_av
def test_mp4_begins_with_its_index_and_plays(tmp_path: Path) -> None:
    import av

    path = tmp_path / "film.mp4"
    filmed(path, [flat(number) for number in range(40)], 30)

    data = path.read_bytes()
    with av.open(str(path)) as container:
        frames = [frame.to_ndarray(format="rgb24") for frame in container.decode(video=0)]
    assert data.index(b"moov") < data.index(b"mdat")
    assert len(frames) == 40
    assert np.abs(frames[39][:41, :61].astype(int) - flat(39)).mean() < 5


def test_frames_of_another_size_are_fitted(tmp_path: Path) -> None:
    red = np.full((10, 10, 3), (255, 0, 0), np.uint8)

    filmed(tmp_path / "film.png", [red, np.full((5, 20, 4), 255, np.uint8)], 10)

    (_, (second, _)) = pictures(tmp_path / "film.png")
    assert second.shape == (10, 10, 3)
    assert (second[:5] == 255).all()
    assert not second[5:].any()


@pytest.mark.parametrize("ending", [pytest.param("mp4", marks=needs_av), "gif", "webp", "png"])
def test_unfinished_film_leaves_nothing(tmp_path: Path, ending: str) -> None:
    movie = Movie(tmp_path / f"film.{ending}", 30)
    movie.add(flat(0))

    movie.__exit__(ValueError, ValueError(), None)

    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(sys.platform == "win32", reason="there the file has a name until it is closed")
def test_killed_film_leaves_nothing(tmp_path: Path) -> None:
    child = os.fork()
    if child == 0:
        Movie(tmp_path / "film.gif", 30).add(flat(0))
        os._exit(9)
    os.waitpid(child, 0)

    assert list(tmp_path.iterdir()) == []


def test_old_film_stays_until_the_new_one_is_whole(tmp_path: Path) -> None:
    path = tmp_path / "film.gif"
    path.write_bytes(b"old")

    movie = Movie(path, 30)
    movie.add(flat(0))
    before = path.read_bytes()
    movie.finish()

    assert before == b"old"
    assert path.read_bytes().startswith(b"GIF89a")


def test_missing_av_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = builtins.__import__

    def without_av(name: str, *args: object) -> object:
        if name == "av":
            raise ImportError(name)
        return whole(name, *args)

    monkeypatch.setattr(builtins, "__import__", without_av)
    with pytest.raises(MovieError) as told, Movie(tmp_path / "film.mp4", 30) as movie:
        movie.add(flat(0))

    assert "pip install 'sketchkit[video]'" in str(told.value)


def test_unknown_ending_is_told(tmp_path: Path) -> None:
    with pytest.raises(MovieError, match=r"ends in \.mp4, \.gif, \.webp, \.png or \.apng"):
        Movie(tmp_path / "film.avi", 30)


def test_folder_is_no_film(tmp_path: Path) -> None:
    (tmp_path / "out.gif").mkdir()

    assert not is_movie(tmp_path / "out.gif")
    assert is_movie(tmp_path / "film.GIF")
    assert not is_movie(tmp_path / "out")
