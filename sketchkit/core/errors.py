"""The one error that a sketch can cause, and the words it is made of.

An error says what was wrong, what was received and what to write instead; the file and the line
are added where it is reported.
"""

import difflib
import re
import reprlib
from collections.abc import Iterable, Sequence


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
        brackets, `"x, y [, z]"`, and other forms after a bar, `"a, b | list"`.
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
    allowed = sorted(set(counts) or _counts(usage))
    numbers = f"{_either(allowed)} {'number' if allowed == [1] else 'numbers'}"
    problem = f"{name}() takes {numbers}: {', or '.join(usage.split(' | '))}."
    call = f"{name}({', '.join(map(shown, args))})"
    if len(args) not in allowed:
        return SketchError(problem, got=f"{len(args)}: {call}")
    for place, value in enumerate(args):
        if not _is_number(value):
            got = f"{_kind(value)} for {_argument_name(usage, len(args), place)}: {call}"
            return SketchError(problem, got=got, hint=_number_hint(value))
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


def _counts(usage: str) -> set[int]:
    counts = set()
    for form in filter(None, usage.split(" | ")):
        total = 1
        for part in form.split("["):
            total += part.count(",")
            counts.add(total)
    return counts or {0}


def _either(counts: Sequence[int]) -> str:
    *others, last = counts
    return f"{', '.join(map(str, others))} or {last}" if others else str(last)


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) or hasattr(value, "__float__")


def _kind(value: object) -> str:
    if value is None:
        return "None"
    if isinstance(value, str):
        return "text"
    if callable(value):
        return "a function"
    kind = type(value).__name__
    return f"{'an' if kind[0] in 'aeiouAEIOU' else 'a'} {kind}"


def _argument_name(usage: str, count: int, place: int) -> str:
    for form in usage.split(" | "):
        names = [name.strip(" ]") for name in form.replace("[", "").split(",")]
        if len(names) == count:
            return names[place]
    return f"number {place + 1}"


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
