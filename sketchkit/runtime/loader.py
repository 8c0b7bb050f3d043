"""A student's file becomes a program: its names, its folder, its modules, its functions.

The names are not written into the sketch's own namespace. They are what stands behind it, where
Python looks for `print` and `len`: so the sketch's variables come first, `dir()` shows the
student's own names alone, and all modules of a sketch see the same live values. Python looks
them up there as fast.
"""

from __future__ import annotations

import builtins
import inspect
import os
import random
import sys
import warnings
from collections.abc import Callable
from contextlib import ExitStack
from functools import cache
from pathlib import Path
from types import ModuleType, TracebackType

import numpy as np

from sketchkit.api.live import LiveFlag
from sketchkit.api.names import live_values, names_of
from sketchkit.api.sketch import Sketch
from sketchkit.core.notices import SketchWarning, warn_once
from sketchkit.runtime.siblings import SiblingFinder
from sketchkit.runtime.source import Source

Names = dict[str, object]
Handler = Callable[..., object]

FLAGS = ("keyPressed", "mousePressed")  # both a value and a function of the sketch
MODULE = "__main__"  # so that `if __name__ == "__main__":` holds

_running: list[Program] = []


class Program:
    """A sketch that is running. A block: what it changes of the process is put back at the end.

    Parameters
    ----------
    source : Source
        The student's file.
    sketch : Sketch
        What its functions work on.
    on_warning : callable
        Called with path, line and text of each remark.

    Attributes
    ----------
    names : dict
        All that the sketch sees besides its own names.
    namespace : dict
        What the student's file has defined.
    """

    def __init__(
        self, source: Source, sketch: Sketch, on_warning: Callable[[str, int, str], None]
    ) -> None:
        self.source = source
        self.sketch = sketch
        self.names: Names = vars(builtins) | names_of(sketch)
        self.module = ModuleType(MODULE)
        self.namespace: Names = vars(self.module)
        self.namespace |= {"__builtins__": self.names, "__file__": str(source.path)}
        self._on_warning = on_warning
        self._live = frozenset(live_values(sketch))
        self._own_names = 0
        self._finder = SiblingFinder(source.path.parent, self.names)
        self._restore = ExitStack()
        sketch.namespace = self.namespace
        sketch.bind(self.publish)

    @property
    def files(self) -> list[Path]:
        """The sketch's file, and those of its modules so far."""
        return [self.source.path, *self._finder.files]

    def __enter__(self) -> Program:
        """Go to the sketch's folder and let its modules be found."""
        restore = self._restore
        restore.callback(os.chdir, os.getcwd())
        restore.callback(sys.path.__setitem__, slice(None), list(sys.path))
        restore.callback(sys.modules.__setitem__, MODULE, sys.modules[MODULE])
        restore.callback(self._finder.forget)
        restore.callback(sys.meta_path.remove, self._finder)
        restore.callback(_running.remove, self)
        restore.enter_context(warnings.catch_warnings())
        warnings.simplefilter("default", SketchWarning)
        warnings.showwarning = self._show_warning
        _running.append(self)
        sys.meta_path.insert(sys.meta_path.index(_path_finder()), self._finder)
        sys.modules[MODULE] = self.module
        os.chdir(self.source.path.parent)
        self.sketch.take_over()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self._restore.close()

    def execute(self) -> None:
        """Run the lines of the file itself.

        Raises
        ------
        Exception
            Whatever they raise.
        """
        self.source.refuse_hidden_modules()
        if self.source.begins_without_smoothing():
            self.sketch.start_without_smoothing()
        exec(self.source.code, self.namespace)
        for name in FLAGS:
            if callable(handler := self.namespace.get(name)) and not _is_flag(handler):
                self.sketch.handlers[name] = handler
                del self.namespace[name]  # the value of this name is seen again; it calls this

    def has(self, name: str) -> bool:
        """Tell whether the sketch defines a function."""
        return self._handler(name) is not None

    def call(self, name: str, event: object = None) -> None:
        """Call a function of the sketch, if there is one, with live values as they are now.

        Parameters
        ----------
        name : str
            `setup`, `draw`, `mouseWheel`, ...
        event : MouseEvent or KeyEvent, optional
            Handed over if the function takes it.
        """
        handler = self._handler(name)
        if handler is None:
            return
        self.publish()
        if event is not None and _takes_event(handler):
            handler(event)
        else:
            handler()
        if len(self.namespace) != self._own_names:
            self._tell_of_hidden_values()

    def publish(self) -> None:
        """Bring the live values up to date in what the sketch sees."""
        self.names.update(live_values(self.sketch))

    def seed(self, seed: int) -> None:
        """Let the random numbers of Python and NumPy begin at the same place at every run."""
        random.seed(seed)
        np.random.seed(seed)  # noqa: NPY002 # this is the generator that np.random.rand() uses

    def _handler(self, name: str) -> Handler | None:
        handler = self.sketch.handlers.get(name) or self.namespace.get(name)
        return handler if callable(handler) and not _is_flag(handler) else None

    def _tell_of_hidden_values(self) -> None:
        self._own_names = len(self.namespace)
        for name in sorted(self._live & self.namespace.keys()):
            self._say_once(
                f"{name} is a variable of your own now: it no longer changes by itself. "
                "Give it another name to have Processing's again."
            )

    def _say_once(self, message: str) -> None:
        warnings.warn_explicit(
            message,
            SketchWarning,
            str(self.source.path),
            _first_binding(self.source, message.partition(" ")[0]),
            registry=self.namespace.setdefault("__warningregistry__", {}),  # type: ignore[arg-type] # as Python makes it
        )
