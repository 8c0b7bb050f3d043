"""Imports run one way: this is the table of who may import whom."""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[1] / "sketchkit"


@dataclass(frozen=True)
class Rule:
    """What a package may import besides itself and the standard library.

    `late` are optional, or slow to load: they are imported inside of functions alone.
    """

    ours: tuple[str, ...] = ()
    theirs: tuple[str, ...] = ()
    late: tuple[str, ...] = ()


BELOW_API = ("core", "data", "pymode", "geometry", "glsl", "imaging", "draw", "assets", "vector")
EVERYTHING = (
    *BELOW_API,
    *("tape", "api", "backends", "libraries", "reference", "runtime", "grading", "stubs"),
)

# The longest name that fits a module is the one that holds.
RULES = {
    "core": Rule(theirs=("numpy",)),
    "data": Rule(theirs=("numpy",)),
    "reference": Rule(),
    "geometry": Rule(("core",), ("numpy",)),
    "imaging": Rule(("core",), ("numpy",)),
    "glsl": Rule(("core",)),
    "pymode": Rule(("core",), ("fissix",)),
    "draw": Rule(("core", "geometry"), ("numpy",)),
    "backends": Rule(),
    "backends.listing": Rule(("core", "geometry", "draw"), ("numpy",)),
    "backends.cpu": Rule(("core", "geometry", "draw"), ("numpy",), late=("numba",)),
    "backends.gl": Rule(
        ("core", "geometry", "draw", "glsl"), ("numpy", "moderngl"), late=("glfw",)
    ),
    "assets": Rule(
        ("core", "geometry", "draw.resources"),
        ("numpy", "PIL", "font_source_sans_pro"),
        late=("PIL", "svgelements", "OpenEXR", "uharfbuzz", "av"),
    ),
    "tape": Rule(("core", "geometry", "draw"), ("numpy",)),
    "vector": Rule(("core", "geometry", "draw", "assets"), ("numpy", "pydyf")),
    "api": Rule(BELOW_API, ("numpy",)),
    "libraries": Rule(("core", "geometry", "api"), ("numpy",)),
    "runtime": Rule(
        (*BELOW_API, "tape", "api", "libraries", "backends", "reference"),
        ("numpy",),
        late=("watchfiles",),
    ),
    "runtime.screens": Rule(("core",), ("glfw",)),
    "runtime.window": Rule(
        (*BELOW_API, "api", "libraries", "backends", "runtime"), ("numpy", "glfw")
    ),
    "grading": Rule(
        (*EVERYTHING, "__init__"),
        ("numpy", "PIL", "scipy"),
        late=("jinja2", "markupsafe", "distributed"),
    ),
    "cli": Rule((*EVERYTHING, "__init__"), ("click", "rich", "PIL"), late=("rich",)),
    "notebooks": Rule(EVERYTHING, ("numpy", "PIL"), late=("PIL",)),
    "stubs": Rule(EVERYTHING),
    "__init__": Rule(EVERYTHING),
    "__main__": Rule(("cli",)),
}


def every_module() -> Iterator[tuple[str, Path]]:
    """Yield name, without the package's, and file of each module."""
    for path in sorted(PACKAGE.rglob("*.py")):
        parts = path.relative_to(PACKAGE).with_suffix("").parts
        is_folder = parts[-1] == "__init__" and len(parts) > 1
        yield ".".join(parts[:-1] if is_folder else parts), path


def rule_of(module: str) -> tuple[str, Rule]:
    """Return the package whose rule holds for a module, and the rule."""
    parts = module.split(".")
    fitting = (".".join(parts[:count]) for count in range(len(parts), 0, -1))
    return next((name, RULES[name]) for name in fitting if name in RULES)


def imports(tree: ast.AST, *, is_late: bool = False) -> Iterator[tuple[str, int, bool]]:
    """Yield what is imported, in which line, and whether within a function."""
    for node in ast.iter_child_nodes(tree):
        match node:
            case ast.Import(names=names):
                for alias in names:
                    yield alias.name, node.lineno, is_late
            case ast.ImportFrom(module=None) | ast.ImportFrom(level=1 | 2 | 3):
                yield "a relative import", node.lineno, is_late
            case ast.ImportFrom(module=str(source), names=names):
                # `from sketchkit.draw import resources` imports draw.resources.
                for alias in names:
                    yield f"{source}.{alias.name}", node.lineno, is_late
        is_function = isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda)
        yield from imports(node, is_late=is_late or is_function)


def breaches(module: str, source: str) -> list[str]:
    """Return what a module imports against its rule, in words."""
    package, rule = rule_of(module)
    found = {}  # by line: one statement breaks the rule once
    for name, line, is_late in imports(ast.parse(source)):
        if not is_allowed(name, package, rule, is_late=is_late):
            where = " within a function" if is_late else ""
            found.setdefault(line, f"{module}, line {line}: {name}{where}")
    return list(found.values())


def is_allowed(name: str, package: str, rule: Rule, *, is_late: bool) -> bool:
    top, _, rest = name.partition(".")
    if top in sys.stdlib_module_names:
        return True
    if top != "sketchkit":
        return top in rule.late if is_late else top in rule.theirs
    rest = rest or "__init__"
    return not is_late and any(_is_within(rest, allowed) for allowed in (package, *rule.ours))


def _is_within(name: str, package: str) -> bool:
    if package == "__init__":  # `from sketchkit import render`
        return not any(_is_within(name, other) for other in RULES if other != "__init__")
    return name == package or name.startswith(f"{package}.")


@pytest.mark.parametrize(
    ("module", "path"), [pytest.param(*item, id=item[0]) for item in every_module()]
)
def test_module_imports_what_its_layer_may(module: str, path: Path) -> None:
    source = path.read_text(encoding="utf-8")

    assert breaches(module, source) == []


@pytest.mark.parametrize(
    ("module", "source"),
    [
        ("core.color", "import moderngl"),
        ("core.color", "from sketchkit.draw import recorder"),
        ("draw.expand", "def f():\n    from sketchkit.api import color"),
        ("draw.expand", "import sketchkit.api.color"),
        ("backends.cpu.raster", "from sketchkit.backends.gl import glsl"),
        ("backends.gl.context", "import glfw"),
        ("assets.images", "from sketchkit.draw.recorder import Recorder"),
        ("api.images", "from sketchkit import backends"),
        ("runtime.loop", "import glfw"),
        ("data.strings", "from . import table"),
    ],
)
def test_import_against_the_table_is_found(module: str, source: str) -> None:
    assert len(breaches(module, source)) == 1


@pytest.mark.parametrize(
    ("module", "source"),
    [
        ("core.color", "import math, numpy as np"),
        ("backends.gl.context", "def f():\n    import glfw"),
        ("assets.images", "from sketchkit.draw import resources"),
        ("runtime.window", "import glfw"),
        ("cli.render", "from sketchkit.runtime.headless import render"),
    ],
)
def test_import_within_the_table_is_allowed(module: str, source: str) -> None:
    assert breaches(module, source) == []
