"""`sketchkit port`: a sketch of Processing's Python Mode, written anew as Python 3."""

from __future__ import annotations

import shutil
import sys
from pathlib import Path

import click

from sketchkit.assets.output import write_file
from sketchkit.cli import say
from sketchkit.cli.sketch_file import sketch_file
from sketchkit.pymode.porting import Ported, port
from sketchkit.pymode.reading import text_of
from sketchkit.runtime.report import StoppedError, reporting
from sketchkit.runtime.source import Source


@click.command(name="port")
@click.argument("sketch", type=sketch_file)
@click.option(
    "--out",
    type=click.Path(file_okay=False, path_type=Path),
    help="The folder to write to. Without it, NAME.py goes beside NAME.pyde; a sketch with "
    "modules goes to the folder NAME-python3.",
)
@click.option("--force", is_flag=True, help="Write over files that are there already.")
def command(sketch: Path, out: Path | None, force: bool) -> None:
    """Write SKETCH, a .pyde file of Processing's Python Mode (Python 2), as Python 3.

    Its modules are written too, its data is copied, and what is to be checked by hand is listed.
    The old files stay as they are.
    """
    files = _files(sketch)
    folder = out or _folder(sketch, files)
    try:
        with reporting(sketch):
            sources = {name: Source.read(file, python=2) for name, file in files.items()}
            ported = port({name: text_of(source.data) for name, source in sources.items()})
    except StoppedError as stopped:
        say.mistake(stopped.report, with_traceback=False)
        sys.exit(1)
    _write(ported, folder, force=force)
    if folder.resolve() != sketch.parent.resolve():
        _copy_rest(sketch.parent, folder)
    _tell(ported, folder)


def _files(sketch: Path) -> dict[str, Path]:
    """Return the sketch and the modules of its folder, by the names of the new files."""
    folder = sketch.parent
    own = (sketch, sketch.with_suffix(".py"))  # the second is what was written last time
    names = [path for path in folder.rglob("*.py") if path not in own and _is_module(path, folder)]
    return {f"{sketch.stem}.py": sketch} | {
        path.relative_to(folder).as_posix(): path for path in sorted(names)
    }


def _is_module(path: Path, folder: Path) -> bool:
    """Tell whether a file can be imported from the sketch's folder, in which it may lie deeper."""
    parents = path.relative_to(folder).parents
    return all((folder / parent / "__init__.py").is_file() for parent in list(parents)[:-1])


def _folder(sketch: Path, files: dict[str, Path]) -> Path:
    if len(files) == 1 and sketch.suffix != ".py":
        return sketch.parent
    return sketch.parent / f"{sketch.stem}-python3"


def _write(ported: Ported, folder: Path, *, force: bool) -> None:
    there = [name for name in ported.texts if (folder / name).exists()]
    if there and not force:
        raise click.UsageError(
            f"{folder / there[0]} is there already. Write --force to replace it, or --out with "
            "another folder."
        )
    for name, text in ported.texts.items():
        write_file(folder / name, text.encode())


def _copy_rest(source: Path, folder: Path) -> None:
    """Copy the data of a sketch."""
    if (source / "data").is_dir():
        shutil.copytree(source / "data", folder / "data", dirs_exist_ok=True)


def _tell(ported: Ported, folder: Path) -> None:
    for name in ported.texts:
        click.echo(f"Written: {folder / name}")
    if not ported.remarks:
        click.echo("There is nothing to check by hand.")
        return
    click.echo("Check by hand:")
    for remark in ported.remarks:
        click.echo(f"  {remark.file}, line {remark.line}: {remark.text}")
