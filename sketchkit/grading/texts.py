"""Texts that others wrote, made safe to show: what cannot be seen is made to be seen.

A submission chooses its names and what it prints. Control characters can rewrite a terminal,
bidirectional ones can make a line read as another, and lone surrogates break whoever encodes
them. Escaping for HTML, XML or CSV comes after this, and is the business of who writes those.
"""

from __future__ import annotations

import re

# C0, DEL, C1 without tab and newline; soft hyphen; marks of direction; separators that Python and
# editors disagree about; invisible operators; half of a pair; what is no character in any plane.
# Joiners (U+200C, U+200D) stay: names are written with them, and they reorder nothing.
_UNSEEN = re.compile(
    "[\x00-\x08\x0b-\x1f\x7f-\x9f\xad\u061c\u115f\u1160\u180e\u200b\u200e\u200f\u2028-\u202e"
    "\u2060-\u206f\u3164\ud800-\udfff\ufdd0-\ufdef\ufeff\uffa0\ufff9-\ufffb\ufffe\uffff"
    "\U000e0000-\U000e007f"
    + "".join(
        f"{chr(plane + 0xFFFE)}{chr(plane + 0xFFFF)}" for plane in range(0x10000, 0x110000, 0x10000)
    )
    + "]"
)


def visible(text: str) -> str:
    r"""Return a text with a sign for each character that would not be seen.

    Tabs and newlines stay, `\r\n` becomes `\n`. All characters of the result are allowed in
    XML 1.0 and can be encoded.

    Examples
    --------
    >>> print(visible("\x1b[31mred\x00 \u202eabc"))
    ⟨U+001B⟩[31mred⟨U+0000⟩ ⟨U+202E⟩abc
    """
    if text.isascii() and text.isprintable():  # pictures as data: addresses, of megabytes
        return text
    return _UNSEEN.sub(_sign, text.replace("\r\n", "\n"))


def visible_line(text: str) -> str:
    """Return a text as `visible` does, in one line: with signs for tabs and newlines too."""
    return visible(text).replace("\n", "⏎").replace("\t", "⇥")


def _sign(match: re.Match[str]) -> str:
    # Unicode has signs for the first 32, but few faces do.
    return f"⟨U+{ord(match[0]):04X}⟩"
