from pathlib import Path

from sketchkit.draw.recorder import Recorder
from sketchkit.runtime.explore.noting import noting
from tests.runtime.sketches import begun, written


def test_recorder_is_the_plain_one_outside_of_the_block(tmp_path: Path) -> None:
    slot = Recorder.__dict__["row_end"]

    with begun(written(tmp_path, "size(50, 50)\n")) as loop, noting(loop.program):
        assert isinstance(Recorder.__dict__["row_end"], property)

    assert Recorder.__dict__["row_end"] is slot


def test_rows_of_a_call_are_noted_with_it(tmp_path: Path) -> None:
    with begun(written(tmp_path, "size(50, 50)\ndef draw():\n    pass\n")) as loop:
        names, canvas = loop.program.names, loop.program.sketch.canvas
        own = str(loop.program.source.path)
        recorder = canvas._recorder  # type: ignore[attr-defined] # of every canvas
        code = compile("rect(1, 2, 3, 4)\nfor i in range(3):\n    circle(i, 2, 3)", own, "exec")

        with noting(loop.program):
            exec(code, {"__builtins__": names})
        lines = [chain[0].instruction for _, chain in recorder.origins]

        assert len(lines) == 2  # the circles are of one call
        assert recorder.row_end // 64 == 4


def test_nothing_is_noted_outside_of_the_block(tmp_path: Path) -> None:
    with begun(written(tmp_path, "size(50, 50)\nrect(1, 2, 3, 4)\n")) as loop:
        canvas = loop.program.sketch.canvas
        canvas.rect(1, 2, 3, 4)  # type: ignore[attr-defined] # of every canvas

        assert canvas._recorder.origins == []  # type: ignore[attr-defined] # of every canvas
