from pathlib import Path

from click.testing import CliRunner

from sketchkit.cli.grade_init import command
from sketchkit.grading.assignment.load import load


def test_folder_with_an_assignment_is_made(tmp_path: Path) -> None:
    done = CliRunner().invoke(command, [str(tmp_path / "new")])

    assert done.exit_code == 0
    assert f"sketchkit grade check {tmp_path / 'new'}" in done.output
    assert load(tmp_path / "new").title == "A ball that crosses"


def test_second_time_leaves_everything_as_it_is(tmp_path: Path) -> None:
    CliRunner().invoke(command, [str(tmp_path)])
    (tmp_path / "assignment.toml").write_text("mine")

    done = CliRunner().invoke(command, [str(tmp_path)])

    assert done.exit_code == 2
    assert "already" in done.output
    assert (tmp_path / "assignment.toml").read_text() == "mine"
