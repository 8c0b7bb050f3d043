"""Python 2's `import`: its own modules, those beside the sketch first, and packages of Java.

A sketch's import statements call the function `__import__` among the names that it sees. So this
one holds for the sketch and its modules alone, and nothing of the process is changed.
"""

from __future__ import annotations

import builtins
import importlib
import sys
from collections.abc import Mapping, Sequence
from importlib.machinery import ModuleSpec
from importlib.util import find_spec
from pathlib import Path
from types import ModuleType

from sketchkit.pymode.modules import python_2_module
from sketchkit.runtime.checks import TAKEN_NAMES
from sketchkit.runtime.python_mode.java import TOP_PACKAGES, JavaPackage
from sketchkit.runtime.siblings import Family, SiblingLoader


class Importer:
    """What the import statements of a sketch call.

    Parameters
    ----------
    family : Family
        The sketch's files.
    """

    def __init__(self, family: Family) -> None:
        self._family = family
        self._modules: dict[str, ModuleType] = {}  # known to this sketch alone

    def __call__(
        self,
        name: str,
        globals: Mapping[str, object] | None = None,
        locals: Mapping[str, object] | None = None,
        fromlist: Sequence[str] | None = (),
        level: int = 0,
    ) -> ModuleType:
        """Return the module that an import statement gets."""
        fromlist = fromlist or ()
        if level == 0 and (module := self._own(name)) is not None:
            return module if fromlist else self._top(name, module)
        if level == 0 and _is_in_package(name, globals):
            level = 1
        return builtins.__import__(name, globals, locals, fromlist, level)

    def _own(self, name: str) -> ModuleType | None:
        """Return a module that only this sketch has, or None."""
        if name not in self._modules and (module := self._made(name)) is not None:
            self._modules.setdefault(name, module)
        return self._modules.get(name)

    def _made(self, name: str) -> ModuleType | None:
        top = name.partition(".")[0]
        folder = self._family.folder
        if (file := folder / f"{name}.py").is_file():
            return self._hidden(name, file) if name in TAKEN_NAMES else None
        if (folder / top).is_dir() or (folder / f"{top}.py").is_file():
            return None
        if alike := _in_other_capitals(folder, name):
            return self._hidden(name, alike)
        if top in TOP_PACKAGES:
            return JavaPackage(name, self._family.names)
        return python_2_module(name)

    def _top(self, name: str, module: ModuleType) -> ModuleType:
        """Return what `import java.util` binds: the package `java`."""
        top, _, path = name.partition(".")
        if not path:
            return module
        package = self._own(top) or importlib.import_module(top)
        found: object = package
        for part in path.split("."):
            found = getattr(found, part)  # so that a class that is not there is told of here
        return package

    def _hidden(self, name: str, file: Path) -> ModuleType:
        """Return a module of the sketch that has the name of one of Python's.

        It comes first for the sketch, as in Python Mode; Python itself goes on with its own.
        """
        loader = SiblingLoader(name, str(file), self._family)
        module = loader.create_module(ModuleSpec(name, loader))
        module.__file__ = str(file)
        self._modules[name] = module  # before it runs: it may import what imports it
        exec(loader.get_code(name), vars(module))
        return module


def _in_other_capitals(folder: Path, name: str) -> Path | None:
    """Return the file `Ball.py` for the module `ball`: on Windows and macOS they are the same."""
    if name in sys.stdlib_module_names or not folder.is_dir():
        return None
    wanted = f"{name}.py".lower()
    return next((file for file in folder.iterdir() if file.name.lower() == wanted), None)


def _is_in_package(name: str, globals: Mapping[str, object] | None) -> bool:
    """Tell whether a module means one of its own folder, as Python 2 lets it without a point."""
    package = globals.get("__package__") if globals else None
    if not isinstance(package, str) or not package:
        return False
    return find_spec(f"{package}.{name.partition('.')[0]}") is not None
