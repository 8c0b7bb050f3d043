from click.testing import CliRunner

from sketchkit.cli.main import main


def test_everything_is_looked_at() -> None:
    result = CliRunner().invoke(main, ["doctor"])

    assert result.exit_code == 0
    for what in (
        "sketchkit",
        "numpy",
        "OpenGL",
        "OSMesa",
        "window",
        "CPU renderer",
        "font",
        "sandbox",
        "Python Mode",
    ):
        assert what in result.output
