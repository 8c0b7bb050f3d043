"""Java's packages, as far as sketches import them: Processing's own, and a few classes."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping
from types import ModuleType, SimpleNamespace

from sketchkit.core.errors import SketchError

TOP_PACKAGES = frozenset({"java", "javax", "processing", "com", "net"})


class Statics:
    """A class of Java of which only what is static is known: `PApplet.sin`, `PApplet.PI`."""

    def __init__(self, names: Mapping[str, object]) -> None:
        self._names = names

    def __mro_entries__(self, bases: tuple[object, ...]) -> tuple[type, ...]:
        """Tell that no class can be made of it."""
        raise SketchError(
            "A sketch has one window here: PApplet cannot be made into a second one.",
            hint="createGraphics() draws out of sight, and image() shows it in the window.",
        )

    def __getattr__(self, name: str) -> object:
        if name in self._names and not name.startswith("_"):
            return self._names[name]
        raise AttributeError(name, name=name, obj=self)


class JavaPackage(ModuleType):
    """A package of Java: what is in it is found when it is asked for.

    Parameters
    ----------
    name : str
        The whole of it: `java.util`.
    names : dict
        What the sketch sees: Processing's classes are among it.
    """

    def __init__(self, name: str, names: Mapping[str, object]) -> None:
        super().__init__(name, f"The Java package {name}.")
        self._names = names
        known = [path.rpartition(".") for path in CLASSES]
        self.__all__ = [short for package, _, short in known if package == name]
        self.__path__: list[str] = []

    def __getattr__(self, name: str) -> object:
        if name.startswith("__"):
            raise AttributeError(name, name=name, obj=self)
        path = f"{self.__name__}.{name}"
        if path in CLASSES:
            return CLASSES[path]
        if self.__name__.startswith("processing."):
            return self._of_processing(path, name)
        if name[:1].islower():
            return JavaPackage(path, self._names)
        raise SketchError(
            f"{path} is a class of Java, and there is no Java here.",
            hint=INSTEAD.get(self.__name__, "Python's own library has something like it."),
        )

    def _of_processing(self, path: str, name: str) -> object:
        if name == "PApplet":
            return Statics(self._names)
        if name in self._names:
            return self._names[name]
        raise SketchError(
            f"{path} belongs to a part of Processing that sketchkit does not have.",
            hint="Take out the import and what uses it.",
        )


def _random_between_0_and_1() -> float:
    import random

    return random.random()


def _parse_int(text: str, base: int = 10) -> int:
    return int(text, base)


def _round(number: float) -> int:
    return math.floor(number + 0.5)


MATH: dict[str, Callable[..., object] | float] = {
    **{name: getattr(math, name) for name in ("acos", "asin", "atan", "atan2", "cos", "cosh")},
    **{name: getattr(math, name) for name in ("exp", "hypot", "log", "log10", "pow", "sin")},
    **{name: getattr(math, name) for name in ("sinh", "sqrt", "tan", "tanh")},
    "PI": math.pi,
    "E": math.e,
    "abs": abs,
    "ceil": lambda number: float(math.ceil(number)),
    "floor": lambda number: float(math.floor(number)),
    "max": max,
    "min": min,
    "random": _random_between_0_and_1,
    "round": _round,
    "signum": lambda number: math.copysign(1.0, number) if number else 0.0,
    "toDegrees": math.degrees,
    "toRadians": math.radians,
}
CLASSES: dict[str, object] = {
    "java.lang.Math": SimpleNamespace(**MATH),
    "java.lang.System": SimpleNamespace(
        currentTimeMillis=lambda: time.time_ns() // 1_000_000,
        nanoTime=time.perf_counter_ns,
        out=SimpleNamespace(println=print, print=lambda text: print(text, end="")),
    ),
    "java.lang.Integer": SimpleNamespace(
        MAX_VALUE=2**31 - 1, MIN_VALUE=-(2**31), parseInt=_parse_int, toString=str
    ),
    "java.lang.Float": SimpleNamespace(parseFloat=float, MAX_VALUE=3.4028234663852886e38),
    "java.lang.String": str,
    "java.lang.Object": object,
    "java.util.ArrayList": list,
}
# What to write instead of the classes of a package.
INSTEAD = {
    "java.awt": "mouseX, mouseY, displayWidth and surface tell of the mouse and the screen.",
    "java.io": "open() reads and writes files, loadStrings() reads lines.",
    "java.lang": "Python has it: math, time, str(), int(), float().",
    "java.util": "Python has it: list, dict, set, random, datetime.",
    "javax.swing": "text() and key let the sketch itself ask, in its own window.",
}
