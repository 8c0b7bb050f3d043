"""Breaking text into lines that fit into a box, where Processing breaks it."""

from __future__ import annotations

from collections.abc import Callable

LONG_WORD = 25  # characters; from here on Processing measures a word from its start

Measure = Callable[[str], float]


def wrap(text: str, width: float, measure: Measure) -> list[str]:
    """Return the lines that text makes in a box.

    Lines are broken at spaces and newlines; a word that is wider than the box, within itself.
    Where not even one character fits, the text ends.

    Parameters
    ----------
    text : str
    width : float, pixels
    measure : function
        Returns the width of a piece of text.

    Examples
    --------
    >>> wrap("the quick brown fox", 10, len)
    ['the quick', 'brown fox']
    """
    lines: list[str] = []
    for sentence in text.split("\n"):
        own, is_complete = _wrap_sentence(sentence, width, measure)
        lines += own
        if not is_complete:
            break
    return lines


def _wrap_sentence(sentence: str, width: float, measure: Measure) -> tuple[list[str], bool]:
    """Return the lines of text without newlines, and whether all of it has found a place."""
    lines: list[str] = []
    line = word = place = 0  # where the line and its last word begin; where we are
    used = 0.0
    while True:
        place = sentence.find(" ", place) % (len(sentence) + 1)  # -1, not found, is the end
        word_width = measure(sentence[word:place])
        if used + word_width < width:
            if place == len(sentence):
                return [*lines, sentence[line:]], True
            used += word_width
            word = place  # the space belongs to the word that follows it
            place += 1
        elif used:
            lines.append(sentence[line:word])
            line = word = place = word + _leading_spaces(sentence[word:])
            used = 0.0
        else:
            count = _fitting(sentence[word:place], width, measure)
            if not count:
                return lines, False
            place = word + count
            lines.append(sentence[line:place])
            line = word = place


def _leading_spaces(text: str) -> int:
    return len(text) - len(text.lstrip(" "))


def _fitting(word: str, width: float, measure: Measure) -> int:
    """Return how many characters of a word that is too wide fit into a line."""
    if len(word) >= LONG_WORD:
        count = 1
        while count < len(word) and measure(word[:count]) < width:
            count += 1
        return count - 1
    count = len(word) - 1
    while count > 0 and measure(word[:count]) > width:
        count -= 1
    return max(count, 0)
