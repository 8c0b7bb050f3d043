"""An SVG file to a tree of elements that know their lines; a file that attacks is refused.

The reader is Python's own expat, by hand: a tree library would not keep the lines, which are told
when something is wrong. What XML can fetch or multiply (external and nested entities) is refused;
the plain ones that Illustrator writes are read.
"""

from __future__ import annotations

import gzip
import zlib
from dataclasses import dataclass, field
from pathlib import Path
from xml.parsers import expat

MAX_BYTES = 64 << 20  # unpacked; drawings of a few MB are large already
MAX_DEPTH = 100  # elements within elements; drawing programs write ten or twenty
MAX_ENTITY = 256  # characters; Illustrator's are addresses of namespaces
GZIP = b"\x1f\x8b"


class SvgError(ValueError):
    """What is wrong in a file, in a sentence without its final stop, and in which line."""

    def __init__(self, problem: str, line: int = 0) -> None:
        super().__init__(problem)
        self.line = line


@dataclass(slots=True, eq=False)
class Element:
    """An element as it stands in the file."""

    tag: str
    attributes: dict[str, str]
    line: int
    text: str = ""
    children: list[Element] = field(default_factory=list)

    def get(self, name: str) -> str | None:
        """Return the value of an attribute without the blanks around it."""
        value = self.attributes.get(name)
        return None if value is None else value.strip()


def read_elements(path: Path) -> Element:
    """Return the outermost element of a file, which may be gzipped.

    Raises
    ------
    SvgError
        If it is no XML, a broken one, or one that would fetch or multiply.
    """
    builder = _Builder()
    try:
        builder.parser.Parse(_content(path), True)
    except expat.ExpatError as problem:
        raise SvgError(_said(problem.code), problem.lineno) from None
    except (LookupError, UnicodeError) as problem:  # an encoding that Python does not know
        raise SvgError(f"its text cannot be read: {problem}", 1) from None
    (root,) = builder.top.children
    return root


def _content(path: Path) -> bytes:
    """Return the bytes of a file, unpacked."""
    try:
        with path.open("rb") as file:
            is_packed = file.read(2) == GZIP
            file.seek(0)
            source = gzip.GzipFile(fileobj=file) if is_packed else file
            content = source.read(MAX_BYTES + 1)
    except (EOFError, OSError, zlib.error) as problem:
        raise SvgError(f"it cannot be read: {str(problem).rstrip('.')}") from None
    if len(content) > MAX_BYTES:
        raise SvgError(f"it is larger than {MAX_BYTES >> 20} MB")
    return content


class _Builder:
    """Takes what expat finds, and makes a tree of it."""

    def __init__(self) -> None:
        self.top = Element("", {}, 0)
        self.open = [self.top]
        self.parser = expat.ParserCreate()
        self.parser.buffer_text = True
        self.parser.StartElementHandler = self.start
        self.parser.EndElementHandler = self.end
        self.parser.CharacterDataHandler = self.characters
        self.parser.EntityDeclHandler = self.entity

    def start(self, name: str, attributes: dict[str, str]) -> None:
        line = self.parser.CurrentLineNumber
        if len(self.open) > MAX_DEPTH:
            raise SvgError(f"more than {MAX_DEPTH} elements are nested", line)
        element = Element(name.removeprefix("svg:"), attributes, line)
        self.open[-1].children.append(element)
        self.open.append(element)

    def end(self, _name: str) -> None:
        self.open.pop()

    def characters(self, text: str) -> None:
        self.open[-1].text += text

    def entity(
        self,
        name: str,
        is_parameter: bool,
        value: str | None,
        *_elsewhere: str | None,
    ) -> None:
        line = self.parser.CurrentLineNumber
        if value is None:
            raise SvgError(f"the entity {name} lies in another file, which is not fetched", line)
        if is_parameter or len(value) > MAX_ENTITY or "&" in value:
            raise SvgError(f"the entity {name} is more than a short text, and is not read", line)


def _said(code: int) -> str:
    """Return what is wrong with the XML, in words that a beginner can look up."""
    return _SAID.get(expat.errors.messages[code], f"its XML is broken: {expat.ErrorString(code)}")


_SAID = {
    expat.errors.XML_ERROR_TAG_MISMATCH: "an element is not closed before the one around it",
    expat.errors.XML_ERROR_NO_ELEMENTS: "it ends before the drawing is complete",
    expat.errors.XML_ERROR_UNCLOSED_TOKEN: "it ends before the drawing is complete",
    expat.errors.XML_ERROR_SYNTAX: "it is not XML",
    expat.errors.XML_ERROR_INVALID_TOKEN: "it is not XML: a < or & too many, or a quote missing",
    expat.errors.XML_ERROR_DUPLICATE_ATTRIBUTE: "an element has the same attribute twice",
    expat.errors.XML_ERROR_UNDEFINED_ENTITY: "it uses an entity, &name;, that it does not define",
}
