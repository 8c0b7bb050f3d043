"""`from peasycam import PeasyCam`: the libraries that sketchkit has, as modules for `import`."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Sequence
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec
from importlib.util import spec_from_loader
from types import ModuleType

from sketchkit.libraries import MODULES


class LibraryLoader(Loader):
    """Gives a module all public names of the library that it stands for."""

    def create_module(self, spec: ModuleSpec) -> ModuleType | None:
        """Leave it to Python to make an empty one."""
        return None

    def exec_module(self, module: ModuleType) -> None:
        """Fill it."""
        library = importlib.import_module(MODULES[module.__name__])
        public: Sequence[str] = library.__all__
        vars(module).update({name: getattr(library, name) for name in public}, __all__=public)


class LibraryFinder(MetaPathFinder):
    """Finds them, when nothing else has the name: it stands last in `sys.meta_path`."""

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Return the library of a name, if there is one."""
        return spec_from_loader(fullname, LibraryLoader()) if fullname in MODULES else None

    def forget(self) -> None:
        """Let go of the modules: another program may have others of the same names."""
        for name in MODULES:
            if isinstance(getattr(sys.modules.get(name), "__loader__", None), LibraryLoader):
                del sys.modules[name]
