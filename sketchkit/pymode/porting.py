"""A sketch of Python Mode, written anew as Python 3: a text that people go on with."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from sketchkit.pymode.edits import Edit, Tokens, apply
from sketchkit.pymode.kinds import FLOAT, INT, Kinds
from sketchkit.pymode.late_globals import with_early_globals
from sketchkit.pymode.remarks import remarks
from sketchkit.pymode.syntax import GRAMMARS, change, convert, modernised, parse, refactoring

# What the library changes besides syntax, in this order.
OWN_FIXERS = ("map", "filter")
NAMES = (
    *("apply", "basestring", "dict", "funcattrs", "future", "getcwdu", "has_key", "imports"),
    *("intern", "itertools", "itertools_imports", "long", "metaclass", "methodattrs", "next"),
    *("nonzero", "operator", "raw_input", "reduce", "reload", "renames", "standarderror"),
    *("sys_exc", "types", "unicode", "urllib", "xrange", "zip"),
)
METHODS = {"__div__": "__truediv__", "__rdiv__": "__rtruediv__", "__idiv__": "__itruediv__"}


@dataclass(frozen=True, order=True)
class Remark:
    """Something to check by hand.

    Attributes
    ----------
    file : str
        Its name.
    line : int
        In the new text.
    text : str
        What, and why: a sentence or two.
    """

    file: str
    line: int
    text: str


@dataclass(frozen=True)
class Ported:
    """The new files, and what is to be checked in them.

    Attributes
    ----------
    texts : dict
        By the names that they were given under.
    remarks : list of Remark
        In order.
    """

    texts: dict[str, str]
    remarks: list[Remark]


def port(texts: Mapping[str, str]) -> Ported:
    """Return a sketch's files in Python 3.

    Parameters
    ----------
    texts : dict
        By name; the sketch's own file and its modules, as `text_of` returns them.

    Raises
    ------
    SyntaxError
        If one is no Python.
    SketchError
        If the library is missing that converts.
    """
    drafts = {name: _draft(text, name) for name, text in texts.items()}
    trees = {name: ast.parse(text, name) for name, text in drafts.items()}
    kinds = Kinds(list(trees.values()))
    new_texts, found = {}, []
    for name, text in drafts.items():
        has_true_division = re.search(r"from __future__ import.*\bdivision\b", texts[name])
        divisions = [] if has_true_division else list(_divisions(trees[name], text, kinds))
        edits = [division.edit for division in divisions if division.edit]
        edits += _renamed_methods(trees[name], text)
        new_texts[name] = apply(text, edits)
        found += [Remark(name, each.line, each.doubt) for each in divisions if each.doubt]
        found += [Remark(name, *each) for each in remarks(trees[name])]
    return Ported(new_texts, sorted(set(found)))


def _draft(text: str, name: str) -> str:
    """Return a text whose syntax and names are Python 3's, and whose divisions are not yet."""
    tree = parse(text)
    if tree is None:
        return convert(text, name).text
    changed = str(modernised(tree)).removesuffix("\n")
    for tools in (refactoring(NAMES), refactoring(OWN_FIXERS, "sketchkit.pymode.fixers")):
        tree = parse(changed, GRAMMARS[1:])
        changed = changed if tree is None else str(change(tree, tools)).removesuffix("\n")
    return with_early_globals(changed.rstrip("\n") + "\n")


@dataclass(frozen=True)
class Division:
    """A division: how its sign changes, or what is not known of it."""

    line: int
    edit: Edit | None = None
    doubt: str = ""


def _divisions(tree: ast.Module, text: str, kinds: Kinds) -> Iterator[Division]:
    tokens = Tokens(text)
    for node in ast.walk(tree):
        match node:
            case ast.BinOp(left=left, op=ast.Div(), right=right):
                sign = "/"
            case ast.AugAssign(target=left, op=ast.Div(), value=right):
                sign = "/="
            case _:
                continue
        pair = {kinds.of(left), kinds.of(right)}
        place = tokens.between(left, right, [sign])
        if place is None or FLOAT in pair:
            continue
        if pair == {INT}:
            yield Division(place[0], Edit(*place, sign, f"/{sign}"))
        else:
            whole = f"{ast.unparse(left)} and {ast.unparse(right)}"
            yield Division(
                place[0],
                doubt=f"If {whole} are both whole numbers, write /{sign} here: "
                "Python 2 cut off the fraction.",
            )


def _renamed_methods(tree: ast.Module, text: str) -> Iterator[Edit]:
    tokens = Tokens(text)
    for node in ast.walk(tree):
        if not (isinstance(node, ast.FunctionDef) and node.name in METHODS):
            continue
        if place := tokens.name_after(node.lineno, "def", node.name):
            yield Edit(*place, node.name, METHODS[node.name])
