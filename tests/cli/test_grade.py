from pathlib import Path

import pytest
from click.testing import CliRunner

from sketchkit.cli.grade import _sum_up, command
from sketchkit.grading.assignment.starter import write_starter
from sketchkit.grading.results import CheckResult, ClassResult, Status, StudentResult


def test_folder_without_submissions_is_told(tmp_path: Path) -> None:
    write_starter(tmp_path / "assignment")
    (tmp_path / "handed-in").mkdir()
    places = [str(tmp_path / name) for name in ("assignment", "handed-in")]

    done = CliRunner().invoke(command, [*places, "--out", str(tmp_path / "results")])

    assert done.exit_code == 2
    assert "There are no submissions in" in done.output


def test_help_shows_each_example_on_a_line_of_its_own() -> None:
    lines = CliRunner().invoke(command, ["--help"]).output.splitlines()

    examples = [line for line in lines if line.startswith("  sketchkit grade ")]
    assert len(examples) == 4
    assert not any("\\b" in line or "\b" in line for line in lines)


def test_name_does_not_reach_the_terminal_as_it_is(capsys: pytest.CaptureFixture[str]) -> None:
    checks = (CheckResult("A", "image", 0.0, 0.0, 1.0),)
    student = StudentResult("\x1b[2Jowned\r\n", "owned", Status.CRASHED, checks=checks)

    _sum_up(ClassResult("Boxes", (student,)), Path("results"))

    printed = capsys.readouterr().out
    assert "\x1b" not in printed
    assert "owned" in printed
