import sys
from pathlib import Path

import pytest

from tests.runtime.sketches import Remarks, begun, mistake, play, written


def test_names_need_no_import(tmp_path: Path) -> None:
    sketch = written(tmp_path, "a = radians(180) == PI\nb = PVector(3, 4).mag()")

    namespace = play(sketch)

    assert namespace["a"] is True
    assert namespace["b"] == 5


def test_own_names_are_the_only_ones_that_dir_shows(tmp_path: Path) -> None:
    sketch = written(tmp_path, "x = 3\nnames = [n for n in dir() if not n.startswith('_')]")

    assert play(sketch)["names"] == ["x"]


def test_module_is_main(tmp_path: Path) -> None:
    sketch = written(tmp_path, "import __main__\nis_main = __name__ == '__main__'\nme = __main__")

    namespace = play(sketch)

    assert namespace["is_main"] is True
    assert vars(namespace["me"])["__file__"] == str(sketch)


def test_star_import_gives_the_same_names_and_leaves_live_values_alive(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        from sketchkit import *
        import sketchkit
        seen = []
        def draw():
            seen.append((frameCount, sketchkit.frameCount, rect is sketchkit.rect))
        """,
    )

    assert play(sketch, 2)["seen"] == [(1, 1, True), (2, 2, True)]


def test_unknown_name_from_sketchkit_is_told_with_the_nearest(tmp_path: Path) -> None:
    text = mistake(written(tmp_path, "from sketchkit import elipse"))

    assert "sketchkit has no elipse" in text
    assert "ellipse?" in text


def test_live_values_are_those_of_the_moment(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        before = width
        def setup():
            size(320, 240)
            global after
            after = width, height
        def draw():
            global now
            now = frameCount, width
        """,
    )

    namespace = play(sketch, 3)

    assert namespace["before"] == 100
    assert namespace["after"] == (320, 240)
    assert namespace["now"] == (3, 320)


def test_own_variable_wins_over_a_live_value_and_is_told_once(tmp_path: Path) -> None:
    remarks = Remarks()
    sketch = written(tmp_path, "\nmouseX = 5\ndef draw():\n    global seen\n    seen = mouseX\n")

    namespace = play(sketch, 3, remarks)

    assert namespace["seen"] == 5
    assert [(line, text.split()[0]) for _, line, text in remarks] == [(2, "mouseX")]


def test_own_variable_that_agrees_with_the_live_value_is_not_told(tmp_path: Path) -> None:
    remarks = Remarks()
    sketch = written(
        tmp_path, "width, height = 300, 200\nsize(width, height)\ndef draw():\n    pass\n"
    )

    play(sketch, 1, remarks)

    assert remarks == []


@pytest.mark.parametrize(
    "data",
    [
        pytest.param(b"\xef\xbb\xbfx = 'gr\xc3\xbcn'\n", id="byte order mark"),
        pytest.param(b"if True:\r\n    x = 'gr\xc3\xbcn'\r\n", id="CRLF"),
        pytest.param(b"# coding: latin-1\nx = 'gr\xfcn'\n", id="coding line"),
    ],
)
def test_sources_as_editors_write_them(tmp_path: Path, data: bytes) -> None:
    sketch = tmp_path / "sketch.py"
    sketch.write_bytes(data)

    assert play(sketch)["x"] == "gr\u00fcn"


def test_sibling_module_sees_names_and_live_values(tmp_path: Path) -> None:
    written(
        tmp_path,
        """
        start = width
        def look():
            return frameCount, width, TWO_PI
        """,
        "helpers.py",
    )
    sketch = written(
        tmp_path,
        """
        import helpers
        def setup():
            size(50, 60)
        def draw():
            global seen
            seen = helpers.look()
        """,
    )

    namespace = play(sketch, 2)

    assert namespace["seen"] == (2, 50, pytest.approx(6.2831853))
    assert "helpers" not in sys.modules


def test_sibling_modules_of_two_sketches_are_not_mixed_up(tmp_path: Path) -> None:
    for name in ("one", "two"):
        written(tmp_path, f"me = '{name}'", f"{name}/helpers.py")
        written(tmp_path, "import helpers\nme = helpers.me", f"{name}/sketch.py")

    assert [play(tmp_path / name / "sketch.py")["me"] for name in ("one", "two")] == ["one", "two"]


@pytest.mark.parametrize("statement", ["import parts.wheel", "from parts.wheel import spokes"])
def test_modules_in_a_folder_see_names_too(tmp_path: Path, statement: str) -> None:
    written(tmp_path, "spokes = int(TWO_PI)", "parts/wheel.py")

    assert play(written(tmp_path, f"{statement}\nok = True"))["ok"] is True


def test_folder_that_a_sketch_adds_to_its_path_has_modules_with_names(tmp_path: Path) -> None:
    written(tmp_path, "half = PI / 2", "lib/angles.py")
    text = f"import sys\nsys.path.append({str(tmp_path / 'lib')!r})\nimport angles\nx = angles.half"
    path = list(sys.path)

    namespace = play(written(tmp_path, text, "sketch/sketch.py"))

    assert namespace["x"] == pytest.approx(1.5707963)
    assert sys.path == path


def test_relative_files_are_the_sketch_folders_own(tmp_path: Path) -> None:
    written(tmp_path, "hello", "data/a.txt")
    written(tmp_path, "there", "b.txt")
    here = Path.cwd()
    sketch = written(tmp_path, "with open('a.txt') as f: a = f.read()\nb = loadStrings('b.txt')")

    namespace = play(sketch)

    assert (namespace["a"], namespace["b"]) == ("hello", ["there"])
    assert Path.cwd() == here


def test_value_and_handler_share_a_name(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        calls = []
        def keyPressed():
            calls.append(1)
        def draw():
            global seen
            seen = bool(keyPressed), keyPressed == False, str(keyPressed)
            keyPressed()
        """,
    )

    namespace = play(sketch, 1)

    assert namespace["seen"] == (False, True, "False")
    assert namespace["calls"] == [1]


@pytest.mark.parametrize("name", ["math", "random", "statistics", "numpy"])
def test_file_that_hides_a_module_is_refused_when_it_is_imported(tmp_path: Path, name: str) -> None:
    written(tmp_path, "x = 1", f"{name}.py")

    text = mistake(written(tmp_path, f"size(10, 10)\nimport {name}"))

    assert text.startswith("sketch.py, line 2: Your file " + name)
    assert f"my_{name}.py" in text


def test_file_with_the_name_of_a_module_that_python_hardly_needs_is_the_sketchs(
    tmp_path: Path,
) -> None:
    written(tmp_path, "class Wave:\n    height = 3", "wave.py")

    assert play(written(tmp_path, "from wave import Wave\nx = Wave.height"))["x"] == 3


def test_file_with_the_name_of_a_module_does_not_bite_as_long_as_nobody_imports_it(
    tmp_path: Path,
) -> None:
    written(tmp_path, "x = 1", "math.py")
    sketch = written(tmp_path, "import helpers\nx = helpers.x")
    written(tmp_path, "import fractions\nx = int(fractions.Fraction(3))", "helpers.py")

    assert play(sketch)["x"] == 3


def test_sketch_with_the_name_of_a_module_is_refused_only_if_it_imports_it(tmp_path: Path) -> None:
    assert play(written(tmp_path, "x = random(1)", "random.py"))["x"] < 1

    text = mistake(written(tmp_path, "import random", "random.py"))

    assert "random.py hides" in text


def test_remark_of_the_api_is_told_once_for_each_place(tmp_path: Path) -> None:
    remarks = Remarks()
    sketch = written(tmp_path, "def draw():\n    noSmooth()\n    noSmooth()\n")

    play(sketch, 3, remarks)

    assert [(name, line) for name, line, _ in remarks] == [("sketch.py", 2), ("sketch.py", 3)]


def test_what_python_finds_strange_is_told(tmp_path: Path) -> None:
    remarks = Remarks()

    play(written(tmp_path, "x = 3\ny = x is 3\n"), remarks=remarks)

    assert [(line, '"=="' in text) for _, line, text in remarks] == [(2, True)]


def test_thread_runs_beside_and_its_mistake_stops_the_sketch(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        import threading
        done = threading.Event()
        others = threading.active_count()
        def work():
            done.set()
            elipse(1, 2, 3, 4)
        def setup():
            thread("work")
            done.wait()
            while threading.active_count() > others:
                pass
        def draw():
            pass
        """,
    )

    assert "line 7: elipse" in mistake(sketch)


def test_overlapping_names_are_pythons_for_pythons_arguments(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        a = set([1, 1]), isinstance({2}, set), list(filter(None, [0, 3])), list(map(str, [1]))
        b = min([2, 1]), max(1, 2), round(2.567, 1), pow(2, 3, 5), abs(-1)
        """,
    )

    namespace = play(sketch)

    assert namespace["a"] == ({1}, True, [3], ["1"])
    assert namespace["b"] == (1, 2, 2.6, 3, 1)


def test_everything_of_the_process_is_put_back(tmp_path: Path) -> None:
    before = (sys.modules["__main__"], list(sys.path), list(sys.meta_path), Path.cwd())

    with begun(written(tmp_path, "x = 1")):
        pass

    assert (sys.modules["__main__"], sys.path, sys.meta_path, Path.cwd()) == before
