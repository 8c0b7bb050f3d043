from pathlib import Path

from click.testing import CliRunner

from sketchkit.cli.main import main
from tests.runtime.sketches import written

SKETCH = """
def setup():
    size(20, 10)
    background(1, 1, 1)
def draw():
    background(frameCount, 0, 0)
    if frameCount == 3:
        noLoop()
"""


def trace(sketch: Path, frame: int) -> str:
    return CliRunner().invoke(main, ["trace", str(sketch), "--frame", str(frame)]).stdout


def test_frame_is_printed_alone(tmp_path: Path) -> None:
    text = trace(written(tmp_path, SKETCH), 2)

    assert "#020000FF" in text
    assert "#010000FF" not in text


def test_frame_0_is_what_setup_draws(tmp_path: Path) -> None:
    assert "#010101FF" in trace(written(tmp_path, SKETCH), 0)


def test_frame_after_noLoop_is_the_last_one(tmp_path: Path) -> None:
    assert "#030000FF" in trace(written(tmp_path, SKETCH), 9)


def test_mistake_is_exit_status_1(tmp_path: Path) -> None:
    result = CliRunner().invoke(main, ["trace", str(written(tmp_path, "elipse(1)"))])

    assert result.exit_code == 1
    assert "elipse" in result.stderr
