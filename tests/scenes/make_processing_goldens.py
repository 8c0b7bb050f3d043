"""Make tests/golden/processing anew: the scenes' pictures as Processing itself draws them.

    python -m tests.scenes.make_processing_goldens write SKETCHES
    python -m tests.scenes.make_processing_goldens take FRAMES

`write` puts each scene into SKETCHES as a sketch of its own, `<scene>.py`, that calls Processing's
functions without importing them. Let any program that runs such a file on Processing's core save
the picture of frame 1 as FRAMES/<scene>/frame-0001.png. `take` copies these over the goldens: as
RGB, for the alpha of a window does not show.

Both take the names of scenes behind the folder, to do these alone.
"""

from __future__ import annotations

import argparse
import ast
import inspect
import shutil
import textwrap
from collections.abc import Callable, Iterator
from pathlib import Path
from types import FunctionType

from PIL import Image

from sketchkit.core.constants import JAVA2D, P2D, P3D
from tests.scenes import SCENES, Scene
from tests.scenes.registry import FOLDER

GOLDENS = Path(__file__).parents[1] / "golden" / "processing"
CANVAS = "g"  # the scenes' name for it


class _WithoutCanvas(ast.NodeTransformer):
    """Turns `g.rect(...)` into `rect(...)`, and drops `g` where it is handed on."""

    def visit_Attribute(self, node: ast.Attribute) -> ast.expr:
        """Drop the canvas before a method."""
        self.generic_visit(node)
        if isinstance(node.value, ast.Name) and node.value.id == CANVAS:
            return ast.copy_location(ast.Name(node.attr, node.ctx), node)
        return node

    def visit_Call(self, node: ast.Call) -> ast.Call:
        """Drop the canvas among the arguments."""
        self.generic_visit(node)
        node.args = [
            arg for arg in node.args if not (isinstance(arg, ast.Name) and arg.id == CANVAS)
        ]
        return node

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.FunctionDef:
        """Drop the canvas among the parameters, with all annotations and decorators."""
        self.generic_visit(node)
        node.args.args = [arg for arg in node.args.args if arg.arg != CANVAS]
        for arg in node.args.args:
            arg.annotation = None
        node.decorator_list, node.returns = [], None
        return node


def sketch_of(scene: Scene) -> str:
    """Return a scene as the source of a sketch."""
    functions = [*_called_functions(scene.draw), scene.draw]
    definitions = [_definition(function) for function in functions]
    definitions[-1].name = "draw"
    renderer = {P2D: "P2D", P3D: "P3D", JAVA2D: "JAVA2D"}[scene.renderer]
    lines = [
        *sorted({line for function in functions for line in _math_imports(function)}),
        "def setup():",
        f"    size({scene.size[0]}, {scene.size[1]}, {renderer})",
        *(["    noSmooth()"] if scene.samples == 1 else []),
    ]
    return "\n".join([*lines, *(ast.unparse(definition) for definition in definitions), ""])


def _definition(function: Callable[..., object]) -> ast.FunctionDef:
    tree = ast.parse(textwrap.dedent(inspect.getsource(function)))
    definition = _WithoutCanvas().visit(tree).body[0]
    assert isinstance(definition, ast.FunctionDef)
    return definition


def _called_functions(function: Callable[..., object]) -> Iterator[FunctionType]:
    """Yield the functions of the scene's own file that it uses."""
    assert isinstance(function, FunctionType)
    for name in function.__code__.co_names:
        found = function.__globals__.get(name)
        if isinstance(found, FunctionType) and found.__module__ == function.__module__:
            yield from _called_functions(found)
            yield found


def _math_imports(function: Callable[..., object]) -> Iterator[str]:
    assert isinstance(function, FunctionType)
    for name in function.__code__.co_names:
        if getattr(function.__globals__.get(name), "__module__", None) == "math":
            yield f"from math import {name}"


def write(folder: Path, scenes: list[Scene]) -> None:
    """Write sketches, and the files that they read."""
    shutil.copytree(FOLDER / "data", folder / "data", dirs_exist_ok=True)
    for scene in scenes:
        (folder / f"{scene.name}.py").write_text(sketch_of(scene), encoding="utf-8")


def take(folder: Path, scenes: list[Scene]) -> None:
    """Copy frames over the goldens."""
    GOLDENS.mkdir(parents=True, exist_ok=True)
    for scene in scenes:
        with Image.open(folder / scene.name / "frame-0001.png") as frame:
            frame.convert("RGB").save(GOLDENS / f"{scene.name}.png", optimize=True)


def main() -> None:
    """Do what the command line says."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("action", choices=["write", "take"])
    parser.add_argument("folder", type=Path)
    parser.add_argument("names", nargs="*", metavar="scene", default=list(SCENES))
    options = parser.parse_args()
    action = {"write": write, "take": take}[options.action]
    action(options.folder, [SCENES[name] for name in options.names])


if __name__ == "__main__":
    main()
