"""Functions that are no file become a sketch: those of a notebook, or of another program.

They were made where Processing's names are unknown, and a function keeps for ever where it looks
for built-in names. So for the time of the run these names are put among Python's own, where
functions, methods and lambdas of any origin find them; but only those that Python lacks. The few
that it has too, such as `map`, would be in the way of all other code: they go into the namespaces
of the functions themselves. Afterwards all is as before.
"""

from __future__ import annotations

import builtins
import inspect
import linecache
from collections.abc import Iterable, Mapping
from pathlib import Path
from types import FunctionType

from sketchkit.api.names import live_values, names_of
from sketchkit.api.sketch import Sketch
from sketchkit.core import running
from sketchkit.libraries.built_in import BUILT_IN
from sketchkit.reference.standing import HANDLERS
from sketchkit.runtime.adding import adder
from sketchkit.runtime.loader import FLAGS, Names, Program, Tell
from sketchkit.runtime.source import Source

CELL = "notebook"  # what a mistake's place is called, if it is in no file


class FunctionsProgram(Program):
    """A sketch whose functions are there already.

    Parameters
    ----------
    functions : mapping
        By name: `setup`, `draw`, and what else there is in their namespace.
    sketch, tell
        As of `Program`.
    """

    def __init__(self, functions: Mapping[str, object], sketch: Sketch, tell: Tell) -> None:
        super().__init__(Source(Path.cwd() / CELL, b""), sketch, tell)
        self.namespace = dict(functions)
        self._spaces = _namespaces(functions)
        self._own = names_of(sketch) | BUILT_IN | {"add_library": adder(vars(builtins))}
        self.names = vars(builtins)
        lasting = list(self._running.lasting)
        self._seen = vars(builtins) | self._own
        self._running = running.Running(self._seen, lasting)
        self.sources = {name: _source(name) for name in _filenames(self._spaces)}
        for name in FLAGS:
            handler = self.namespace.pop(name, None)
            if isinstance(handler, FunctionType):
                sketch.handlers[name] = handler
        sketch.attach(self.namespace, self.publish)

    def execute(self) -> None:
        """Do nothing: the functions are there."""

    def publish(self) -> None:
        """Bring the live values up to date."""
        values = live_values(self.sketch)
        self.names.update(values)
        self._seen.update(values)

    def __enter__(self) -> Program:
        """Let the functions see the names of a sketch."""
        shared = self._own.keys() & vars(builtins).keys()
        alone = {name: value for name, value in self._own.items() if name not in shared}
        self._restore.callback(_keep_only, vars(builtins), set(vars(builtins)))
        vars(builtins).update(alone)
        for space in self._spaces:
            self._restore.callback(_keep_own, space, shared - space.keys())
            space.update({name: self._own[name] for name in shared - space.keys()})
            self._take_out(space, [name for name in FLAGS if name in space])
        return super().__enter__()

    def _take_out(self, space: Names, names: Iterable[str]) -> None:
        for name in names:
            self._restore.callback(space.__setitem__, name, space.pop(name))


def _keep_only(space: Names, known: set[str]) -> None:
    """Take out what has been added, by `add_library()` too."""
    for name in space.keys() - known:
        del space[name]


def _keep_own(space: Names, lent: set[str]) -> None:
    """Take out the names that were lent to a namespace."""
    for name in lent:
        space.pop(name, None)


def _namespaces(functions: Mapping[str, object]) -> list[Names]:
    """Return where the sketch's own functions have been defined; each place once.

    What else is in a namespace may come from anywhere: those modules are no part of the sketch.
    """
    handlers = (inspect.unwrap(f) for n, f in functions.items() if n in HANDLERS and callable(f))
    spaces = (each.__globals__ for each in handlers if isinstance(each, FunctionType))
    return list({id(space): space for space in spaces}.values())


def _filenames(spaces: Iterable[Names]) -> set[str]:
    """Return the files, or a notebook's cells, in which functions and methods were written."""
    return {
        function.__code__.co_filename
        for space in spaces
        for value in space.values()
        for function in (vars(value).values() if isinstance(value, type) else [value])
        if isinstance(function, FunctionType) and function.__globals__ is space
    }


def _source(filename: str) -> Source:
    """Return a file of functions as it is known to Python; notebooks' cells are in no file."""
    path = Path(filename)
    text = "".join(linecache.getlines(filename))
    return Source(path if path.is_file() else path.with_name(CELL), text.encode())
