"""What 4.20 made shorter, written as GLSL before it takes it.

`float a[2] = {1, 2}` becomes `float a[2] = float[2](1, 2)`, and in a function that returns a float
`return 1` becomes `return 1.0`.
"""

from __future__ import annotations

from collections.abc import Sequence

from sketchkit.glsl.tokens import Token


def with_constructors(tokens: Sequence[Token]) -> list[Token]:
    """Return tokens where lists in braces without a list inside have become constructors."""
    result = list(tokens)
    code = [place for place, token in enumerate(tokens) if token.is_code and not token.directive]
    for nth in range(1, len(code)):
        if tokens[code[nth]].text != "{" or tokens[code[nth - 1]].text != "=":
            continue
        kind = _declared_type([tokens[place].text for place in code[: nth - 1]])
        end = _end_of_flat_list([tokens[place].text for place in code[nth:]])
        if kind and end:
            opening, closing = code[nth], code[nth + end]
            result[opening] = tokens[opening]._replace(text=f"{kind}(")
            result[closing] = tokens[closing]._replace(text=")")
    return result


def with_float_returns(tokens: Sequence[Token]) -> list[Token]:
    """Return tokens where functions of type float return 1.0, and not 1.

    Numbers alone: of other expressions the type is not known, and float() takes vectors, too.
    """
    result = list(tokens)
    code = [place for place, token in enumerate(tokens) if token.is_code and not token.directive]
    depth, is_float = 0, False
    for nth, place in enumerate(code):
        text = tokens[place].text
        if depth == 0 and text == "(":
            is_float = nth >= 2 and tokens[code[nth - 2]].text == "float"
        depth += {"{": 1, "}": -1}.get(text, 0)
        is_alone = tokens[code[min(nth + 1, len(code) - 1)]].text == ";"
        words = [tokens[before].text for before in code[max(nth - 2, 0) : nth]]
        if is_float and depth and is_alone and text.isdigit() and _is_returned(words):
            result[place] = tokens[place]._replace(text=f"{text}.0")
    return result


def _is_returned(words: list[str]) -> bool:
    """Return whether `return` stands last, or a sign behind it."""
    return words[-1:] == ["return"] or words in (["return", "-"], ["return", "+"])


def _declared_type(before: list[str]) -> str:
    """Return the type of what is declared at the end of `before`; empty if it is not plain."""
    left, size = _split_size(before)
    name, left = left[-1:], left[:-1]
    left, own_size = _split_size(left)
    if not name or not left or not (left[-1][0].isalpha() or left[-1][0] == "_"):
        return ""
    return left[-1] + "".join(own_size or size)


def _split_size(words: list[str]) -> tuple[list[str], list[str]]:
    """Cut `[n]` off the end."""
    if words[-1:] != ["]"] or "[" not in words:
        return words, []
    at = len(words) - 1 - words[::-1].index("[")
    return words[:at], words[at:]


def _end_of_flat_list(words: list[str]) -> int:
    """Return where the brace that opens is closed; 0 if others open before."""
    end = words.index("}") if "}" in words else 0
    return 0 if "{" in words[1:end] or words[end - 1 : end] == [","] else end
