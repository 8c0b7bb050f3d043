import ast
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from sketchkit.cli.main import main
from tests.runtime.sketches import play


def new(*args: object) -> Result:
    return CliRunner().invoke(main, ["new", *map(str, args)])


def test_folder_is_ready_to_run(tmp_path: Path) -> None:
    result = new(tmp_path / "spinning")

    assert result.exit_code == 0
    assert (tmp_path / "spinning" / "data").is_dir()
    play(tmp_path / "spinning" / "spinning.py", 2)


def test_editors_are_told_the_names(tmp_path: Path) -> None:
    new(tmp_path / "spinning")

    ast.parse((tmp_path / "spinning" / "__builtins__.pyi").read_text())
    assert '"rect"' in (tmp_path / "spinning" / "ruff.toml").read_text()
    assert (tmp_path / "spinning" / "pyrightconfig.json").exists()


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("math", "name of a Python module"),
        ("numpy", "name of a Python module"),
        ("2d", "cannot be the name"),
        ("my sketch", "cannot be the name"),
        ("class", "cannot be the name"),
    ],
)
def test_name_that_would_bite_is_refused(tmp_path: Path, name: str, words: str) -> None:
    result = new(tmp_path / name)

    assert result.exit_code == 2
    assert words in result.output
    assert list(tmp_path.iterdir()) == []


def test_folder_that_exists_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "spinning").mkdir()

    assert new(tmp_path / "spinning").exit_code == 2
    assert list((tmp_path / "spinning").iterdir()) == []
