import builtins
import keyword
import re
from functools import cache

import pytest

from sketchkit.reference.instead import (
    BY_ITSELF,
    EVERY,
    MODULES,
    instead_of,
    instead_of_attribute,
    sentences,
)
from sketchkit.reference.names import names_by_owner
from sketchkit.reference.standing import HANDLERS
from sketchkit.runtime.visible_names import all_names
from sketchkit.stubs import blank_sketch

# Names in sentences that are no functions of a sketch: parts of Python, and of packages.
OF_PYTHON = frozenset(
    {
        *("append", "find", "index", "items", "keys", "values", "lower", "upper", "strip"),
        *("startswith", "endswith", "replace", "system", "home", "splitext", "makedirs", "dot"),
        *("run", "quote_plus", "unquote_plus", "split", "SystemExit", "list", "attrib", "Ball"),
        *("getShape", "getName", "getFloat", "rows"),
    }
)


@cache
def names() -> dict[str, object]:
    return all_names(blank_sketch())


def test_sentence_of_a_name_is_found() -> None:
    assert instead_of("HashMap") == "Write dict in Python."


def test_class_nearest_to_the_object_comes_first() -> None:
    owners = ["PGraphics", "PImage"]

    assert "createGraphics" in str(instead_of("setParent", owners))
    assert "loadPixels" in str(instead_of("isModified", owners))


def test_sentence_for_all_names_of_a_class_is_for_those_of_the_table_alone() -> None:
    assert "shader()" in str(instead_of("createProgram", ["PGL"]))
    assert instead_of("createProgramme", ["PGL"]) is None


def test_what_java_writes_behind_a_dot_is_said_of_any_object() -> None:
    assert instead_of_attribute("length", ["list", "object"]) == "Python writes len(...)."
    assert instead_of("length", ["list"]) is None


@pytest.mark.parametrize("sentence", sorted(set(sentences().values())))
def test_sentence_is_whole(sentence: str) -> None:
    first = sentence.split()[0]

    assert sentence[0].isupper() or first in ("sketchkit", "bRigid")
    assert sentence.endswith((".", "sounddevice", "opencv-python", "pyserial", "gpiozero"))
    assert "  " not in sentence


@pytest.mark.parametrize("sentence", sorted(set(sentences().values())))
def test_sentence_names_functions_that_are_here(sentence: str) -> None:
    known = names().keys() | vars(builtins).keys() | HANDLERS | OF_PYTHON

    called = re.findall(r"(?<!without )\b(\w+)\(", sentence)

    assert [name for name in called if name not in known] == []


def test_sentences_are_about_names_that_sketches_do_not_have() -> None:
    here = [
        name
        for owner, name in sentences()
        if owner == BY_ITSELF and (name in names() or name in vars(builtins))
    ]

    assert here == ["exec"]  # Python's is here; Processing's, which starts a program, is not


def test_owners_are_classes_of_the_table() -> None:
    owners = {owner for owner, _ in sentences()}

    assert owners <= names_by_owner().keys() | {EVERY, MODULES}


def test_no_sentence_is_about_a_word_of_python() -> None:
    assert [name for _, name in sentences() if keyword.iskeyword(name)] == []
