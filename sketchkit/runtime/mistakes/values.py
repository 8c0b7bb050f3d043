"""Values that do not do: places outside a list, missing keys and files, divisions by zero."""

from __future__ import annotations

import ast
import re
from pathlib import Path

from sketchkit.core.errors import nearest, shown
from sketchkit.runtime.mistakes.mistake import Explanation, Mistake


def explain_index(mistake: Mistake) -> Explanation | None:
    """Explain a place that a list does not have."""
    match mistake.expression:
        case ast.Subscript(value=container, slice=place):
            pass
        case _:
            return Explanation(_sentence(mistake.text))
    name = mistake.written(container)
    try:
        items, index = mistake.value_of(container), mistake.value_of(place)
        count = len(items)  # type: ignore[arg-type] # what has been subscripted has a length
    except (LookupError, TypeError):
        return Explanation(f"{name} has no item {mistake.written(place)}.", COUNTS_FROM_0)
    if count == 0:
        return Explanation(f"{name} is empty: it has no item {shown(index)}.")
    return Explanation(
        f"{name} has {count} item{'s' * (count > 1)}, {name}[0] to {name}[{count - 1}].",
        got=f"{name}[{shown(index)}]",
    )


COUNTS_FROM_0 = "Items are counted from 0, so the last one is len(...) - 1."


def explain_key(mistake: Mistake) -> Explanation | None:
    """Explain a key that a dictionary does not have."""
    if not mistake.error.args:
        return None
    key = mistake.error.args[0]
    problem = f"The dictionary has no key {shown(key)}."
    try:
        keys = list(mistake.value_of(getattr(mistake.expression, "value", None)))  # type: ignore[call-overload] # tried
    except (LookupError, TypeError):
        return Explanation(problem)
    known = nearest(str(key), [known for known in keys if isinstance(known, str)])
    return Explanation(problem, f"Do you mean {known!r}?" if known else None)


def explain_division(mistake: Mistake) -> Explanation | None:
    """Explain a division by zero."""
    match mistake.expression:
        case ast.BinOp(right=divisor) if not isinstance(divisor, ast.Constant):
            what = mistake.written(divisor)
            return Explanation(f"Nothing can be divided by zero: {what} is 0 here.")
    return Explanation("Nothing can be divided by zero.")


def explain_value(mistake: Mistake) -> Explanation | None:
    """Explain a value of the right kind that still does not do."""
    text = mistake.text
    if found := re.match(r"invalid literal for int\(\) with base \d+: (.*)", text):
        is_fraction = re.fullmatch(r"'\s*[-+]?\d*\.\d*\s*'", found[1])
        without_fraction = "parseInt(...) takes it, without its fraction."
        hint = without_fraction if is_fraction else "parseInt(...) gives 0 here, and no error."
        return Explanation(f"{found[1]} is no whole number.", hint)
    if found := re.match(r"could not convert string to float: (.*)", text):
        hint = "parseFloat(...) gives NaN here, and no error."
        return Explanation(f"{found[1]} is no number.", hint)
    if found := re.match(r"not enough values to unpack \(expected (\d+), got (\d+)\)", text):
        return Explanation(f"There are {found[1]} names before the =, but only {found[2]} values.")
    if found := re.match(r"too many values to unpack \(expected (\d+)", text):
        return Explanation(f"There are {found[1]} names before the =, but more values.")
    if text == "math domain error":
        return Explanation(
            "This calculation has no answer.",
            "Perhaps the square root or the logarithm of a negative number.",
        )
    return Explanation(_sentence(text)) if text else None


def explain_file(mistake: Mistake) -> Explanation | None:
    """Explain a file that is not there."""
    filename = getattr(mistake.error, "filename", None)
    if not isinstance(filename, str):
        return None
    folders = [Path(filename).parent, Path("data")]
    files = [file.name for folder in folders if folder.is_dir() for file in folder.iterdir()]
    known = nearest(Path(filename).name, files)
    return Explanation(
        f"There is no file {filename!r} beside the sketch, nor in its data folder.",
        f"Do you mean {known!r}?" if known else None,
    )


def explain_recursion(mistake: Mistake) -> Explanation | None:
    """Explain a function that never stops calling itself."""
    name = f"{mistake.function}()" if mistake.function else "A function"
    return Explanation(
        f"{name} calls itself again and again, without an end.",
        "It needs an if that makes it return without another call.",
    )


def explain_memory(mistake: Mistake) -> Explanation | None:
    """Explain that the memory is full."""
    return Explanation("There is not enough memory for this.", "A list or an image is too large.")


def explain_interrupt(mistake: Mistake) -> Explanation | None:
    """Explain that the user has stopped the sketch."""
    return Explanation("Stopped by Ctrl+C.")


def explain_assertion(mistake: Mistake) -> Explanation | None:
    """Explain an assert of the student's own."""
    return Explanation(mistake.text or "What the assert says is not true.")


def _sentence(text: str) -> str:
    """Return Python's words as a sentence."""
    return text[:1].upper() + text[1:] + ("" if text.endswith((".", "!", "?")) else ".")
