"""Values that change under the sketch's hands: `mouseX`, `frameCount`, `frameRate`, `keyPressed`.

A property marked `@live` is published: whoever runs the sketch copies its value into the sketch's
names before each of its functions. Some names are a value and a function in one.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

Getter = TypeVar("Getter", bound=Callable[[Any], object])  # Any: a getter of whatever class

_live_getters: set[Callable[[Any], object]] = set()  # Any: as above
_live_names: dict[type, tuple[str, ...]] = {}


def live(getter: Getter) -> Getter:
    """Mark the function under `@property` as one whose value is published."""
    _live_getters.add(getter)
    return getter


def live_names(kind: type) -> tuple[str, ...]:
    """Return the names of the live properties of a class; looked for once, used in every frame."""
    if kind not in _live_names:
        _live_names[kind] = tuple(
            name
            for name in dir(kind)
            if isinstance(value := getattr(kind, name), property) and value.fget in _live_getters
        )
    return _live_names[kind]


class LiveFloat(float):
    """A number that can be called: `frameRate` is how fast it goes, `frameRate(30)` sets it."""

    def __new__(cls, value: float, call: Callable[[float], None]) -> LiveFloat:
        """Join a number and what is done when it is called."""
        number = super().__new__(cls, value)
        number._call = call
        return number

    _call: Callable[[float], None]

    def __call__(self, value: float) -> None:
        """Do what the function of this name does."""
        self._call(value)


class LiveInt(int):
    """A whole number that can be called, as `pixelDensity`."""

    def __new__(cls, value: int, call: Callable[[int], None]) -> LiveInt:
        """Join a number and what is done when it is called."""
        number = super().__new__(cls, value)
        number._call = call
        return number

    _call: Callable[[int], None]

    def __call__(self, value: int) -> None:
        """Do what the function of this name does."""
        self._call(value)


class LiveFlag(int):
    """True or false, and the sketch's own function of the same name: `mousePressed`.

    It equals `True` or `False` and prints as they do.
    """

    def __new__(cls, value: bool, call: Callable[..., object]) -> LiveFlag:
        """Join a flag and the sketch's function."""
        flag = super().__new__(cls, value)
        flag._call = call
        return flag

    _call: Callable[..., object]

    def __call__(self, *args: object) -> object:
        """Call the sketch's function."""
        return self._call(*args)

    def __repr__(self) -> str:
        return repr(bool(self))

    __str__ = __repr__
