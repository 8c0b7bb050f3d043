"""The modules beside a sketch: they see its names, and are forgotten after it."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.abc import MetaPathFinder
from importlib.machinery import ModuleSpec, PathFinder, SourceFileLoader
from pathlib import Path
from types import CodeType, ModuleType

from sketchkit.runtime.checks import TAKEN_NAMES, refuse_hidden_modules
from sketchkit.runtime.source import Source

Names = dict[str, object]


@dataclass(frozen=True)
class Family:
    """What the files of a sketch have in common.

    Attributes
    ----------
    folder : Path
        Where the sketch lies.
    names : dict
        What they all see behind their own names.
    sources : dict
        What has been read of them, by file name.
    python : 2 or 3
        Which Python they are written in.
    """

    folder: Path
    names: Names
    sources: dict[str, Source]
    python: int = 3


class SiblingLoader(SourceFileLoader):
    """Runs a module that sees the sketch's names."""

    def __init__(self, name: str, path: str, family: Family) -> None:
        super().__init__(name, path)
        self.family = family

    def create_module(self, spec: ModuleSpec) -> ModuleType:
        """Return a module whose own namespace is empty, and behind it the sketch's names."""
        module = ModuleType(spec.name)
        vars(module)["__builtins__"] = self.family.names
        return module

    def get_code(self, fullname: str) -> CodeType:
        """Return the module's code, from its source: nothing is cached beside a sketch."""
        source = Source.read(Path(self.path), self.family.python)
        self.family.sources[self.path] = source
        refuse_hidden_modules(source)
        return source.code


class SiblingFinder(MetaPathFinder):
    """Finds modules in the sketch's folder, and in folders that the sketch adds to `sys.path`.

    Attributes
    ----------
    family : Family
        The sketch's.
    found : dict
        The modules that the sketch has got from here, and their files; None for a plain folder.
    """

    def __init__(self, family: Family) -> None:
        self.family = family
        self.found: dict[str, Path | None] = {}
        self._path_before = frozenset(sys.path)

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Return where a module of the sketch is; None leaves it to Python."""
        package, _, _ = fullname.rpartition(".")
        if package and package not in self.found:
            return None
        if fullname in TAKEN_NAMES:
            return None
        spec = PathFinder.find_spec(fullname, path if package else self._folders())
        if spec is None or (spec.loader is None and PathFinder.find_spec(fullname, path)):
            return None  # as in Python, a plain folder counts only if nothing else has the name
        self.found[fullname] = Path(spec.origin) if spec.origin else None
        if isinstance(spec.loader, SourceFileLoader):
            spec.loader = SiblingLoader(fullname, spec.loader.path, self.family)
        return spec

    @property
    def files(self) -> list[Path]:
        """The files of the modules that have been found."""
        return [path for path in self.found.values() if path]

    def forget(self) -> None:
        """Let go of the modules: the next sketch may have others of the same names."""
        for name in self.found:
            sys.modules.pop(name, None)

    def _folders(self) -> list[str]:
        return [
            str(self.family.folder),
            *(entry for entry in sys.path if entry not in self._path_before),
        ]
