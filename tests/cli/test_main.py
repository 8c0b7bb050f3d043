import pytest
from click.testing import CliRunner

from sketchkit import __version__
from sketchkit.cli.main import COMMANDS, main


def test_without_arguments_a_first_example_is_shown() -> None:
    result = CliRunner().invoke(main, [])

    assert result.exit_code == 0
    assert "def draw():" in result.output
    assert "sketchkit run spinning.py" in result.output


def test_first_example_is_a_sketch(capsys: pytest.CaptureFixture[str]) -> None:
    lines = CliRunner().invoke(main, []).output.splitlines()

    compile("\n".join(line[4:] for line in lines if line.startswith("    ")), "spinning.py", "exec")


def test_version() -> None:
    assert CliRunner().invoke(main, ["--version"]).output == f"sketchkit {__version__}\n"


def test_help_lists_all_commands() -> None:
    output = CliRunner().invoke(main, ["--help"]).output

    for name, entry in COMMANDS.items():
        assert name in output
        assert entry.summary in output


@pytest.mark.parametrize("name", COMMANDS)
def test_command_explains_itself(name: str) -> None:
    result = CliRunner().invoke(main, [name, "--help"])

    assert result.exit_code == 0
    assert f"Usage: main {name}" in result.output


def test_unknown_command_is_refused() -> None:
    assert CliRunner().invoke(main, ["draw"]).exit_code == 2
