"""Names that Python has too, and whose arguments tell which is meant.

Those that are about numbers (`map`, `min`, `round`, ...) are told apart in `maths.py`; here are
those that need the canvas or the sketch's folder.
"""

from __future__ import annotations

import builtins
from collections.abc import Callable, Mapping
from pathlib import Path

from sketchkit.assets.paths import note_read, note_written

Arguments = tuple[object, ...]


class Overlap:
    """Processing's function for the arguments that fit it, for all others Python's own.

    Python's are classes, and sketches use them as such: `isinstance(x, set)`, `set[int]`.
    """

    def __init__(
        self,
        python: type,
        processing: Callable[..., object],
        is_processing: Callable[[Arguments], bool],
    ) -> None:
        self._python = python
        self._processing = processing
        self._is_processing = is_processing
        self.__name__ = python.__name__
        self.__doc__ = processing.__doc__
        if "__init__" in vars(python):
            vars(self)["__init__"] = vars(python)["__init__"]  # for a subclass that calls it

    def __call__(self, *args: object, **named: object) -> object:
        """Call one of the two."""
        if not named and self._is_processing(args):
            return self._processing(*args)
        return self._python(*args, **named)

    def __instancecheck__(self, instance: object) -> bool:
        return isinstance(instance, self._python)

    def __subclasscheck__(self, subclass: type) -> bool:
        return issubclass(subclass, self._python)

    def __mro_entries__(self, bases: tuple[object, ...]) -> tuple[type, ...]:
        return (self._python,)

    def __getitem__(self, item: object) -> object:
        return self._python[item]  # type: ignore[index] # as set[int] has it

    def __or__(self, other: type) -> object:
        return self._python | other

    def __getattr__(self, name: str) -> object:
        return getattr(self._python, name)

    def __repr__(self) -> str:
        return repr(self._python)


def _is_pixel(args: Arguments) -> bool:
    """Tell `set(x, y, color)` from a set."""
    return len(args) == 3


def _is_effect(args: Arguments) -> bool:
    """Tell `filter(BLUR, 6)` and `filter(shader)` from filtering a list by a function."""
    return bool(args) and args[0] is not None and not callable(args[0])


# Python's name, and when it is Processing's.
OVERLAPS: Mapping[str, tuple[type, Callable[[Arguments], bool]]] = {
    "set": (builtins.set, _is_pixel),
    "filter": (builtins.filter, _is_effect),
}


def overlaps(canvas: object) -> dict[str, object]:
    """Return the names of `OVERLAPS` that the canvas has, with both meanings."""
    return {
        name: Overlap(python, getattr(canvas, name), is_processing)
        for name, (python, is_processing) in OVERLAPS.items()
        if hasattr(canvas, name)
    }


def opener(folder: Path) -> Callable[..., object]:
    """Return Python's `open()`, which finds files in the sketch's `data` folder too."""

    def open(file: object, mode: str = "r", *args: object, **named: object) -> object:
        """Open a file; one that is read may lie in the sketch's `data` folder.

        Parameters
        ----------
        file : str
            Its name.
        mode : str
            `"r"` to read, `"w"` to write, `"a"` to append; with `"b"` for bytes.
        *args, **named
            As Python's own.

        Examples
        --------
        >>> with open("poem.txt") as file:
        ...     println(file.read())
        """
        if isinstance(file, str) and "r" in mode and not Path(file).exists():
            beside = folder / "data" / file
            file = str(beside) if beside.exists() else file
        if isinstance(file, str | Path):
            (note_read if mode.startswith("r") else note_written)(Path(file))
        return builtins.open(file, mode, *args, **named)  # type: ignore[call-overload] # Python checks

    return open
