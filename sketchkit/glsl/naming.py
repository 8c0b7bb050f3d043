"""Which names of a shader become which, and what has to be declared for them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

from sketchkit.glsl.declarations import Declarations, read_declarations
from sketchkit.glsl.interface import uniforms_of
from sketchkit.glsl.tokens import Kind, Token, code_of, directives, next_code
from sketchkit.glsl.words import (
    LEGACY_VARIABLES,
    NEWER_FUNCTIONS,
    RESERVED,
    TEXTURE_FUNCTIONS,
    TURNED,
    shadow_function,
)

OURS = "sk_"  # what names begin with that we give
_NO_TYPES = frozenset(("return", "else", "case", "define", "defined", "ifdef", "ifndef", "undef"))


@dataclass(frozen=True)
class Names:
    """What is renamed in one shader.

    Attributes
    ----------
    functions : mapping of str
        Of names where a bracket follows.
    others : mapping of str
        Of names elsewhere.
    function_aliases : frozenset of str
        Macros that stand for a function's name.
    header, footer : str
        What is declared before, and what follows the code; may be empty.
    by_sketch : mapping of str
        Of uniforms and attributes.
    """

    functions: Mapping[str, str]
    others: Mapping[str, str]
    function_aliases: frozenset[str]
    header: str
    footer: str
    by_sketch: Mapping[str, str]

    def renamed(self, tokens: Sequence[Token], place: int) -> Token:
        """Return a token with its new name."""
        token = tokens[place]
        if token.kind is not Kind.NAME:
            return token
        if token.text not in self.functions and token.text not in self.others:
            return token
        follower = next_code(tokens, place)
        is_function = follower == "(" or (
            token.directive == "define" and _macro(tokens, place) in self.function_aliases
        )
        if not is_function and token.text in RESERVED and re.match(r"[A-Za-z_]", follower):
            return token  # `flat in vec2 p`: it is the word itself
        new = (self.functions if is_function else self.others).get(token.text)
        return token if new is None else token._replace(text=new)


def choose_names(tokens: Sequence[Token], stage: str, *, is_legacy: bool) -> Names:
    """Return what is renamed in a shader, for the version it will be of."""
    used = {token.text for token in tokens if token.kind is Kind.NAME}
    declared = read_declarations(tokens)
    macros = {line[1].text for line in directives(tokens) if _is_definition(line)}
    everywhere: dict[str, str] = {}
    header: list[str] = []
    if is_legacy:
        everywhere |= _storage_words(stage)
        everywhere |= {word: OURS + word for word in used & RESERVED}
        header += _legacy_variables(used, declared, stage, everywhere)
    if stage == "fragment":
        header += _turned(used, declared, everywhere)
    others, functions = dict(everywhere), dict(everywhere)
    if is_legacy:
        _name_functions(used, declared, functions)
        others |= {name: new for name, new in functions.items() if name not in NEWER_FUNCTIONS}
        header += [text for name in sorted(used) if (text := shadow_function(name))]
        others |= {name: OURS + name for name in used & _hiding_names(tokens, declared)}
    footer = ""
    if stage == "vertex" and "main" in declared.functions:
        functions["main"] = "sk_main"
        header.insert(0, "uniform float sk_y_sign;")
        footer = "void main() { sk_main(); gl_Position.y *= sk_y_sign; }"
    for name in macros:  # what the shader defines by itself keeps its name
        functions.pop(name, None)
        others.pop(name, None)
    return Names(
        functions,
        others,
        frozenset(_function_aliases(tokens)),
        " ".join(header),
        footer,
        _by_sketch(declared, others) | _fed(used, stage, others),
    )


def _storage_words(stage: str) -> dict[str, str]:
    if stage == "vertex":
        return {"attribute": "in", "varying": "out"}
    # Only what is written can be invariant, since 4.20.
    return {"attribute": "in", "varying": "in", "invariant": ""}


def _legacy_variables(
    used: set[str], declared: Declarations, stage: str, names: dict[str, str]
) -> Iterator[str]:
    """Name the variables that GLSL once had, and yield their declarations."""
    inputs = {variable.name: variable.type for variable in declared.stored("attribute", "in")}
    for name, legacy in LEGACY_VARIABLES[stage].items():
        if name not in used:
            continue
        names[name] = legacy.name
        taken = legacy.declaration.startswith("in ") and set(legacy.fed_by) <= set(inputs)
        if taken and legacy.fed_by:  # the shader has it by Processing's name, too
            names[name] = legacy.fed_by[0]
        else:
            yield legacy.text


def _turned(used: set[str], declared: Declarations, names: dict[str, str]) -> Iterator[str]:
    """Name what depends on the way up, and yield its declarations."""
    own = {variable.name for variable in declared.variables} | set(declared.functions)
    found = [name for name in TURNED if name in used and name not in own]
    if found:
        yield "uniform float sk_height; uniform float sk_is_turned;"
    for name in found:
        names[name], declaration = TURNED[name]
        yield declaration


def _name_functions(used: set[str], declared: Declarations, functions: dict[str, str]) -> None:
    """Name the functions that read textures, and the shader's own that are built in by now."""
    for name in used:
        if name in declared.functions:
            if name in NEWER_FUNCTIONS:
                functions[name] = OURS + name
        elif name in TEXTURE_FUNCTIONS:
            functions[name] = TEXTURE_FUNCTIONS[name]
        elif shadow_function(name):
            functions[name] = OURS + name


def _hiding_names(tokens: Sequence[Token], declared: Declarations) -> set[str]:
    """Return names of variables that would hide the functions that read textures."""
    found = {variable.name for variable in declared.variables}
    code = code_of(tokens)
    for before, token in pairwise(code):
        if before.kind is Kind.NAME and before.text not in _NO_TYPES:
            found.add(token.text)
    return found & set(TEXTURE_FUNCTIONS.values())


def _function_aliases(tokens: Sequence[Token]) -> Iterator[str]:
    """Yield the macros without parameters that are used as functions."""
    names = {line[1].text for line in directives(tokens) if _is_definition(line)}
    for place, token in enumerate(tokens):
        is_use = token.text in names and token.text != _macro(tokens, place)
        if is_use and next_code(tokens, place) == "(":
            yield token.text


def _is_definition(line: Sequence[Token]) -> bool:
    return line[0].text == "define" and len(line) > 1


def _macro(tokens: Sequence[Token], place: int) -> str:
    """Return the name that is defined on the line of a token; empty if none is."""
    if tokens[place].directive != "define":
        return ""
    while tokens[place].text != "define":
        place -= 1
    return next_code(tokens, place)


def _by_sketch(declared: Declarations, names: Mapping[str, str]) -> dict[str, str]:
    """Return the new names of uniforms and attributes, members of structs among them."""
    own = [*uniforms_of(declared)]
    own += [variable.name for variable in declared.stored("attribute", "in")]
    new = {name: re.sub(r"\w+", lambda word: names.get(word[0], word[0]), name) for name in own}
    return {name: actual for name, actual in new.items() if actual != name}


def _fed(used: set[str], stage: str, names: Mapping[str, str]) -> dict[str, str]:
    """Return the names of what Processing feeds for variables that GLSL once had."""
    return {
        sketch_name: legacy.name
        for name, legacy in LEGACY_VARIABLES[stage].items()
        if name in used and names.get(name) == legacy.name
        for sketch_name in legacy.fed_by
    }
