import json
from pathlib import Path

from click.testing import CliRunner, Result

from sketchkit.cli.main import main
from tests.runtime.sketches import written

SKETCH = "size(20, 10)\nbackground(9)\nnoStroke()\nrect(0, 0, 10, 10)\n"


def inspected(folder: Path, *options: str, text: str = SKETCH) -> Result:
    path = str(written(folder, text))
    return CliRunner().invoke(
        main, ["inspect", path, "--renderer", "cpu", "--frame", "0", *options]
    )


def test_line_of_a_pixel_is_printed(tmp_path: Path) -> None:
    assert "sketch.py, line 4: rect(0, 0, 10, 10)" in inspected(tmp_path, "--pixel", "5,5").stdout


def test_json_is_an_object_for_one_pixel_and_a_list_for_more(tmp_path: Path) -> None:
    one = inspected(tmp_path, "--pixel", "5,5", "--json")
    two = inspected(tmp_path, "--pixel", "5,5", "--pixel", "15,5", "--json")

    assert json.loads(one.stdout)["drawn_by"]["line"] == 4
    assert [own["drawn_by"]["line"] for own in json.loads(two.stdout)] == [4, 2]


def test_pixel_outside_is_exit_status_2(tmp_path: Path) -> None:
    result = inspected(tmp_path, "--pixel", "20,5")

    assert result.exit_code == 2
    assert "20 x 10" in result.stderr


def test_pixel_is_two_numbers(tmp_path: Path) -> None:
    result = inspected(tmp_path, "--pixel", "5")

    assert result.exit_code == 2
    assert "120,80" in result.stderr


def test_mistake_is_exit_status_1(tmp_path: Path) -> None:
    assert inspected(tmp_path, "--pixel", "1,1", text="elipse(1)").exit_code == 1
