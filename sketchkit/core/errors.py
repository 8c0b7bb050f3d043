"""The one error that a sketch can cause, and the words it is made of.

An error says what was wrong, what was received and what to write instead; the file and the line
are added where it is reported.
"""

import difflib
import math
import re
import reprlib
from collections.abc import Iterable, Iterator, Sequence

from sketchkit.core.constants import MAX_FLOAT

# Names in a usage that may stand for something else than a number, and what that is.
OTHER_KINDS: dict[str, type] = {
    "color": str,
    "color1": str,
    "color2": str,
    "font": object,
    "image": object,
    "name": object,
    "renderer": object,
    "text": object,
}


class SketchError(Exception):
    """A mistake in the sketch, told to its author.

    Parameters
    ----------
    problem : str
        What was wrong: a whole sentence, in the names that the sketch uses.
    got : str, optional
        What was received: it follows the word "Got", without a final stop.
    hint : str, optional
        What to write instead: a whole sentence.
    """

    def __init__(self, problem: str, *, got: str | None = None, hint: str | None = None) -> None:
        super().__init__(problem)
        self.problem = problem
        self.got = got
        self.hint = hint

    @property
    def message(self) -> str:
        """The parts that there are, joined: the problem, then an indented line with the others."""
        got = f"Got {self.got}." if self.got else None
        rest = "  ".join(part for part in (got, self.hint) if part)
        return f"{self.problem}\n    {rest}" if rest else self.problem

    def __str__(self) -> str:
        return self.message


def wrong_numbers(
    name: str, args: Sequence[object], usage: str, counts: Sequence[int] = ()
) -> SketchError:
    """Return the error for a call with too many, too few or the wrong kind of arguments.

    Parameters
    ----------
    name : str
        The function's, as the sketch writes it.
    args : sequence
        What it was called with.
    usage : str
        The names of its numbers, `"x, y, width, height"`. Those that may be left out stand in
        brackets, `"x, y [, z]"`, and other forms after a bar, `"a, b | list"`. Names in capitals
        are constants.
    counts : sequence of int, optional
        How many numbers it takes, where `usage` does not show that.

    Examples
    --------
    >>> print(wrong_numbers("rect", (10, 20, 30), "x, y, width, height [, radii]", (4, 5, 8)))
    rect() takes 4, 5 or 8 numbers: x, y, width, height [, radii].
        Got 3: rect(10, 20, 30).
    >>> print(wrong_numbers("sq", ("7",), "n"))
    sq() takes 1 number: n.
        Got text for n: sq('7').  float('7') makes a number of it.
    """
    allowed = sorted(set(counts) or set(map(len, _forms(usage))) or {0})
    problem = f"{name}() takes {_takes(usage, allowed)}."
    call = f"{name}({', '.join(map(shown, args))})"
    if len(args) not in allowed:
        return SketchError(problem, got=f"{len(args)}: {call}")
    if usage.isupper():
        return SketchError(problem, got=call)
    for place, value in enumerate(args):
        argument = _argument_name(usage, len(args), place)
        if not _is_number(value) and not isinstance(value, OTHER_KINDS.get(argument, ())):
            got = f"{kind_of(value)} for {argument}: {call}"
            return SketchError(problem, got=got, hint=_number_hint(value))
        if _is_too_large(value):
            problem = f"A number for {name}() is too large: 3.4e38 is the most."
            return SketchError(problem, got=f"{shown(value)} for {argument}: {call}")
    return SketchError(problem, got=call)


def nearest(name: str, names: Iterable[str]) -> str | None:
    """Return the one of `names` that was probably meant, or None.

    Capitals and underscores do not count, so that `push_matrix` finds `pushMatrix`.

    Examples
    --------
    >>> nearest("elipse", ["ellipse", "rect"])
    'ellipse'
    """
    by_plain_name = {_plain(known): known for known in names}
    found = difflib.get_close_matches(_plain(name), list(by_plain_name), n=1, cutoff=0.7)
    return by_plain_name[found[0]] if found else None


def shown(value: object) -> str:
    """Return `value` as a message shows it: as Python writes it, but short."""
    if isinstance(value, float):
        return repr(round(value, 4))
    if callable(value):
        return getattr(value, "__name__", "a function")
    return _short.repr(value)


_short = reprlib.Repr()
_short.maxstring = _short.maxother = 40


def kind_of(value: object) -> str:
    """Return in words what a value is that was given where it does not belong."""
    if value is None:
        return "None"
    if isinstance(value, str):
        return "text"
    if isinstance(value, int | float):
        return "a number"
    if callable(value):
        return "a function"
    name = type(value).__name__
    return f"{'an' if name[0] in 'aeiouAEIOU' else 'a'} {name}"


def either(choices: Iterable[object]) -> str:
    """Return choices as a sentence lists them.

    Examples
    --------
    >>> either([4, 5, 8])
    '4, 5 or 8'
    """
    *others, last = map(str, choices)
    return f"{', '.join(others)} or {last}" if others else last


def _takes(usage: str, counts: Sequence[int]) -> str:
    """Return how many values a function takes, and their names."""
    forms = usage.split(" | ")
    if usage.isupper():
        return either(forms)
    is_numeric = not any(name in OTHER_KINDS for names in _forms(usage) for name in names)
    noun = "number" if is_numeric else "value"
    return f"{either(counts)} {noun}{'s' * (list(counts) != [1])}: {', or '.join(forms)}"


def _forms(usage: str) -> Iterator[list[str]]:
    """Yield the names of each way to call: of `x, y [, z]` x and y, then x, y and z."""
    for form in filter(None, usage.split(" | ")):
        names: list[str] = []
        for part in form.split("["):
            names += filter(None, (name.strip(" ]") for name in part.split(",")))
            yield list(names)


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) or hasattr(value, "__float__")


def _is_too_large(value: object) -> bool:
    """Return whether a number, infinity aside, does not fit into the 32 bits of Java's float."""
    if not isinstance(value, int | float):
        return False
    return abs(value) > MAX_FLOAT and value not in (math.inf, -math.inf)


def _argument_name(usage: str, count: int, place: int) -> str:
    return next(
        (names[place] for names in _forms(usage) if len(names) == count), f"number {place + 1}"
    )


def _number_hint(value: object) -> str | None:
    if value is None:
        return "A function that ends without return gives None."
    if isinstance(value, str) and re.fullmatch(r"\s*[-+]?\d+(\.\d*)?\s*", value):
        return f"float({value!r}) makes a number of it."
    if isinstance(value, list | tuple):
        return "A list's numbers are taken one by one: values[0], values[1]."
    if hasattr(value, "x") and hasattr(value, "y"):
        return "A vector's numbers are v.x, v.y and v.z."
    if callable(value):
        return "Is there a pair of brackets missing?"
    return None


def _plain(name: str) -> str:
    return name.replace("_", "").lower()
