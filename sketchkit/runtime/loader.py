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
from collections import deque
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from types import ModuleType, TracebackType
from typing import NamedTuple, TextIO

import numpy as np

from sketchkit.api.live import LiveFlag
from sketchkit.api.names import live_values, names_of
from sketchkit.api.sketch import Sketch
from sketchkit.assets.paths import set_sketch_folder, sketch_folder
from sketchkit.core import running
from sketchkit.core.notices import SketchWarning
from sketchkit.libraries.built_in import BUILT_IN
from sketchkit.runtime.adding import adder
from sketchkit.runtime.carrying import adopt, carry
from sketchkit.runtime.checks import (
    begins_without_smoothing,
    refuse_drawing_before_size,
    refuse_hidden_modules,
)
from sketchkit.runtime.library_modules import LibraryFinder
from sketchkit.runtime.python_mode.names import python_mode_names
from sketchkit.runtime.siblings import Family, SiblingFinder
from sketchkit.runtime.source import Source

Names = dict[str, object]
Handler = Callable[..., object]
Tell = Callable[[Path, int, str], None]

FLAGS = ("keyPressed", "mousePressed")  # both a value and a function of the sketch
KEY_HANDLERS = ("keyPressed", "keyReleased", "keyTyped")  # these may set `key`
FORMER_TEXTS = 20  # that are remembered
MODULE = "__main__"  # so that `if __name__ == "__main__":` holds


class _Parts(NamedTuple):
    """What a program consists of, apart from its sketch."""

    module: ModuleType
    source: Source
    sources: dict[str, Source]
    siblings: dict[str, ModuleType]
    handlers: dict[str, Handler]

    @property
    def namespace(self) -> Names:
        """What the module has defined."""
        return vars(self.module)


class Program:
    """A sketch that is running. A block: what it changes of the process is put back at the end.

    Parameters
    ----------
    source : Source
        The student's file.
    sketch : Sketch
        What its functions work on.
    tell : callable
        Called with path, line and text of each remark that does not stop the sketch.

    Attributes
    ----------
    names : dict
        All that the sketch sees behind its own names.
    namespace : dict
        What the student's file has defined.
    sources : dict
        The sketch's file and its modules as they were read, by file name.
    former : deque of dict
        The same before each exchange: what was drawn until then comes from these texts.
    """

    def __init__(self, source: Source, sketch: Sketch, tell: Tell) -> None:
        self.sketch = sketch
        values = live_values(sketch)
        own = names_of(sketch) | BUILT_IN
        self.names: Names = vars(builtins) | own
        self._begin(source)
        self._tell = tell
        self._running = running.Running(self.names, [name for name in own if name not in values])
        self._unhidden = set(values)  # live values of which the sketch has not been told
        self.sources = {str(source.path): source}
        self.former: deque[dict[str, Source]] = deque(maxlen=FORMER_TEXTS)
        family = Family(source.path.parent, self.names, self.sources, source.python)
        self._finder = SiblingFinder(family)
        self.names["add_library"] = adder(self.names)
        if source.python == 2:
            self.names |= python_mode_names(family)
        self._libraries = LibraryFinder()
        self._restore = ExitStack()
        self._kept = self._parts()

    @property
    def files(self) -> list[Path]:
        """The sketch's file, and those of its modules so far."""
        found = [*self._finder.files, *map(Path, self.sources)]
        return list(dict.fromkeys([self.source.path, *found]))

    def __enter__(self) -> Program:
        """Go to the sketch's folder and let its modules be found."""
        restore = self._restore
        restore.callback(os.chdir, os.getcwd())
        restore.callback(sys.path.__setitem__, slice(None), list(sys.path))
        restore.callback(sys.modules.__setitem__, MODULE, sys.modules[MODULE])
        restore.callback(set_sketch_folder, sketch_folder())
        restore.callback(self.sketch.end_beside)
        restore.callback(self._finder.forget)
        restore.callback(sys.meta_path.remove, self._finder)
        restore.callback(self._libraries.forget)
        restore.callback(sys.meta_path.remove, self._libraries)
        restore.callback(running.leave, self._running)
        restore.enter_context(warnings.catch_warnings())
        warnings.simplefilter("default", SketchWarning)
        warnings.showwarning = self._show_warning
        running.enter(self._running)
        sys.meta_path.insert(0, self._finder)
        sys.meta_path.append(self._libraries)
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
        """Put back what was changed."""
        self._restore.close()

    def execute(self) -> None:
        """Run the lines of the file itself.

        Raises
        ------
        Exception
            Whatever they raise.
        """
        refuse_hidden_modules(self.source)
        refuse_drawing_before_size(self.source)
        for line, text in self.source.remarks:
            self._tell(self.source.path, line, text)
        if begins_without_smoothing(self.source):
            self.sketch.start_without_smoothing()
        exec(self.source.code, self.namespace)
        self._take_handlers()
        self._tell_of_hidden_values()

    def exchange(self, source: Source) -> None:
        """Run another text of the sketch in place of this one; its variables keep their values.

        Its modules are run anew as well. See `carrying` for what survives.

        Raises
        ------
        Exception
            Whatever the new text raises; `put_back` then makes the sketch what it was.
        """
        refuse_hidden_modules(source)
        old = self._kept = self._parts()
        self.former.append(old.sources)
        self.sources.update({str(source.path): source})
        self._finder.forget()
        self._begin(source)
        sys.modules[MODULE] = self.module
        exec(source.code, self.namespace)
        carry(old.namespace, self.namespace, old.source, source)
        for name, module in old.siblings.items():
            if (file := getattr(module, "__file__", None)) in self.sources and name in sys.modules:
                texts = old.sources[file], self.sources[file]
                carry(vars(module), vars(sys.modules[name]), *texts)
        modules = [vars(sys.modules[name]) for name in self._finder.found if name in sys.modules]
        adopt([self.namespace, *modules])
        self.sketch.handlers.clear()
        self._take_handlers()

    def follow_file(self, source: Source) -> None:
        """Take that its file holds another text now, which means what is run already."""
        self.former.append(dict(self.sources))
        self.source = source
        self.sources[str(source.path)] = source

    def put_back(self) -> None:
        """Make the sketch what it was before the last `exchange`."""
        self.module, self.source, sources, siblings, handlers = self._kept
        self.namespace = vars(self.module)
        self.sources.clear()
        self.sources.update(sources)
        self._finder.forget()
        sys.modules.update(siblings)
        sys.modules[MODULE] = self.module
        self.sketch.handlers.update(handlers)
        self.sketch.attach(self.namespace, self.publish)

    def _parts(self) -> _Parts:
        siblings = {n: sys.modules[n] for n in self._finder.found if n in sys.modules}
        handlers = dict(self.sketch.handlers)
        return _Parts(self.module, self.source, dict(self.sources), siblings, handlers)

    def _begin(self, source: Source) -> None:
        """Make an empty module for a text."""
        self.source = source
        self.module = ModuleType(MODULE)
        self.namespace = vars(self.module)
        self.namespace |= {"__builtins__": self.names, "__file__": str(source.path)}
        self.sketch.attach(self.namespace, self.publish)

    def _take_handlers(self) -> None:
        """Take the functions whose names are values too out of the sketch's namespace."""
        for name in FLAGS:
            if handler := self._function(name):
                self.sketch.handlers[name] = handler
                del self.namespace[name]  # so that the value of this name is seen: it calls this

    def has(self, name: str) -> bool:
        """Tell whether the sketch defines a function."""
        return self._function(name) is not None

    def needs_arguments(self, name: str) -> bool:
        """Tell whether the sketch defines a function that cannot be called without arguments."""
        function = self._function(name)
        parameters = inspect.signature(function).parameters.values() if function else ()
        variable = (inspect.Parameter.VAR_POSITIONAL, inspect.Parameter.VAR_KEYWORD)
        return any(p.default is p.empty and p.kind not in variable for p in parameters)

    def call(self, name: str, event: object = None) -> None:
        """Call a function of the sketch, if there is one, with live values as they are now.

        Parameters
        ----------
        name : str
            `setup`, `draw`, `mouseWheel`, ...
        event : MouseEvent or KeyEvent, optional
            Handed over if the function takes it.
        """
        function = self._function(name)
        if function is None:
            return
        self.publish()
        may_set_key = name in KEY_HANDLERS and "key" not in self.namespace
        if event is not None and _takes_an_argument(function):
            function(event)
        else:
            function()
        if may_set_key and "key" in self.namespace:
            self.sketch.set_key(self.namespace.pop("key"))
        self._tell_of_hidden_values()

    def call_registered(self, name: str, *event: object) -> None:
        """Call a method of all objects that are registered for it, with live values as they are."""
        targets = self.sketch.registered.get(name)
        if not targets:
            return
        self.publish()
        for target in list(targets):
            getattr(target, name)(*event)

    def publish(self) -> None:
        """Bring the live values up to date in what the sketch sees."""
        self.names.update(live_values(self.sketch))

    def _function(self, name: str) -> Handler | None:
        function = self.sketch.handlers.get(name) or self.namespace.get(name)
        return function if callable(function) and not isinstance(function, LiveFlag) else None

    def _tell_of_hidden_values(self) -> None:
        """Tell, once, of each live value that a variable of the sketch hides and differs from."""
        for name in self._unhidden & self.namespace.keys():
            if not _are_the_same(self.namespace[name], self.names[name]):
                self._unhidden.discard(name)
                self._tell(
                    self.source.path,
                    self.source.line_of_binding(name),
                    f"{name} is a variable of your own now: it no longer changes by itself.\n"
                    "    Give it another name, to have Processing's again.",
                )

    def _show_warning(
        self,
        message: Warning | str,
        category: type[Warning],
        filename: str,
        lineno: int,
        file: TextIO | None = None,
        line: str | None = None,
    ) -> None:
        self._tell(Path(filename), lineno, str(message))


def seed_everything(seed: int) -> None:
    """Let the random numbers of Python and NumPy begin at the same place at every run."""
    random.seed(seed)
    np.random.seed(seed)  # noqa: NPY002 # the generator behind np.random.rand()


def _are_the_same(own: object, live: object) -> bool:
    return own is live or (isinstance(own, int | float | str) and own == live)


def _takes_an_argument(function: Handler) -> bool:
    places = (inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.POSITIONAL_OR_KEYWORD)
    parameters = inspect.signature(function).parameters.values()
    return any(p.kind in (*places, inspect.Parameter.VAR_POSITIONAL) for p in parameters)
