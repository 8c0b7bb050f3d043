"""What a shader wants from a sketch: its kind, its uniforms and its attributes."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from sketchkit.glsl.declarations import Declarations, Variable, read_declarations
from sketchkit.glsl.tokens import tokenize
from sketchkit.glsl.words import LEGACY_VARIABLES

# Processing looks at each line by itself, also within a comment; the first that fits decides.
_KINDS = {
    re.compile(pattern): kind
    for pattern, kind in (
        ("#define *PROCESSING_COLOR_SHADER", "COLOR"),
        ("#define *PROCESSING_LIGHT_SHADER", "LIGHT"),
        ("#define *PROCESSING_TEXTURE_SHADER", "TEXTURE"),
        ("#define *PROCESSING_TEXLIGHT_SHADER", "TEXLIGHT"),
        ("#define *PROCESSING_(?:POLYGON|TRIANGLES|QUADS)_SHADER", "POLY"),
        ("#define *PROCESSING_POINT_SHADER", "POINT"),
        ("#define *PROCESSING_LINE_SHADER", "LINE"),
        ("(?:attribute|in) *vec2 *offset", "POINT"),
        ("(?:attribute|in) *vec4 *direction", "LINE"),
    )
}


@dataclass(frozen=True)
class Declared:
    """The type of a uniform or attribute, in GLSL's words; `length` is None if it is no array."""

    type: str
    length: int | None = None


@dataclass(frozen=True)
class Interface:
    """What a pair of shaders declares.

    Attributes
    ----------
    kind : str or None
        `COLOR`, `TEXTURE`, `LIGHT`, `TEXLIGHT`, `LINE`, `POINT`, `POLY`; None if nothing tells.
    uniforms : mapping of str
        By the names that `set()` takes; members of a struct as `lamp.place`, `lamps[1].place`.
    attributes : frozenset of str
        What the vertex shader reads of each vertex, by the sketch's names.
    kinds_differ : bool
        Whether the two stages say two different kinds: `kind` is the vertex shader's.
    """

    kind: str | None
    uniforms: Mapping[str, Declared]
    attributes: frozenset[str]
    kinds_differ: bool = False


def read_interface(vertex: str | None, fragment: str | None) -> Interface:
    """Return what a pair of shaders declares; None stands for a shader that is not the sketch's."""
    uniforms: dict[str, Declared] = {}
    for source in (fragment, vertex):
        if source is not None:
            uniforms |= uniforms_of(read_declarations(tokenize(source)))
    kinds = [kind for source in (vertex, fragment) if source and (kind := kind_of_source(source))]
    return Interface(
        kinds[0] if kinds else None,
        uniforms,
        frozenset() if vertex is None else attributes_of(vertex),
        kinds_differ=len(set(kinds)) > 1,
    )


def kind_of_source(source: str) -> str | None:
    """Return the kind that a source is of in Processing's view, or None."""
    for line in source.splitlines():
        for pattern, kind in _KINDS.items():
            if pattern.search(line):
                return kind
    return None


def attributes_of(vertex: str) -> frozenset[str]:
    """Return the names of what a vertex shader reads of each vertex."""
    tokens = tokenize(vertex)
    names = {variable.name for variable in read_declarations(tokens).stored("attribute", "in")}
    for token in tokens:
        legacy = LEGACY_VARIABLES["vertex"].get(token.text)
        if legacy is not None and legacy.declaration.startswith("in "):
            names.add(legacy.fed_by[0])
    return frozenset(names)


def uniforms_of(declarations: Declarations) -> dict[str, Declared]:
    """Return the uniforms of a shader, members of structs one by one."""
    return {
        name: Declared(leaf.type, leaf.length)
        for variable in declarations.stored("uniform")
        for name, leaf in _leaves(variable, declarations.structs)
    }


def _leaves(
    variable: Variable, structs: Mapping[str, Sequence[Variable]]
) -> Iterator[tuple[str, Variable]]:
    """Yield the plain variables within one, with their full names."""
    if variable.type not in structs:
        yield variable.name, variable
        return
    count = variable.length
    owners = [variable.name] if count is None else [f"{variable.name}[{i}]" for i in range(count)]
    for owner in owners:
        for member in structs[variable.type]:
            for name, leaf in _leaves(member, structs):
                yield f"{owner}.{name}", leaf
