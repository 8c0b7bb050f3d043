"""The style sheet within an SVG file: Illustrator writes colours so; Processing skips them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple, TypeAlias

from sketchkit.assets.svg.elements import Element

Declarations: TypeAlias = list[tuple[str, str]]  # names and values, in order

_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
_SELECTOR = re.compile(r"(\w+|\*)?(?:#([\w-]+))?((?:\.[\w-]+)*)")


class Rule(NamedTuple):
    """Declarations for the elements that a selector names; what it leaves open is empty.

    Selectors with more than an element, an id and classes (`g > path`, `:hover`) are left out.
    """

    tag: str
    name: str
    classes: frozenset[str]
    declarations: Declarations

    @property
    def weight(self) -> tuple[bool, int, bool]:
        """How precise the selector is: the more precise of two rules wins."""
        return bool(self.name), len(self.classes), bool(self.tag)

    def fits(self, element: Element) -> bool:
        """Return whether an element is meant."""
        return (
            self.tag in ("", element.tag)
            and self.name in ("", element.get("id"))
            and self.classes <= set((element.get("class") or "").split())
        )


def read_rules(root: Element) -> list[Rule]:
    """Return the rules of all style sheets in a file, the stronger ones last."""
    rules: list[Rule] = []
    for sheet in _sheets(root):
        for block in _COMMENT.sub(" ", sheet).split("}"):
            selectors, _, body = block.partition("{")
            declarations = read_declarations(body)
            for selector in selectors.split(","):
                if found := _SELECTOR.fullmatch(selector.strip()):
                    tag, name, classes = found.groups()
                    chosen = frozenset(filter(None, classes.split(".")))
                    tag = "" if tag in (None, "*") else tag
                    rules.append(Rule(tag, name or "", chosen, declarations))
    return sorted(rules, key=lambda rule: rule.weight)


def read_declarations(text: str) -> Declarations:
    """Return what `fill: red; stroke: none` says; values keep the blanks around them."""
    pairs = (part.partition(":") for part in text.split(";"))
    return [(name.strip(), value) for name, _, value in pairs if value.strip()]


def _sheets(element: Element) -> Iterator[str]:
    if element.tag == "style":
        yield element.text
    for child in element.children:
        yield from _sheets(child)
