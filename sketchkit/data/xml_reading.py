"""XML read from text or bytes with Python's own parser, Expat.

Nothing is fetched from anywhere, and an entity (a short name for a text, which a document may
define) that is made of others, or is long, is refused: with such a few lines could become
gigabytes.
"""

from __future__ import annotations

from typing import Generic, TypeVar
from xml.parsers import expat

from sketchkit.data.malformed import MalformedError
from sketchkit.data.xml_tree import Kind, Node

N = TypeVar("N", bound=Node)

DEEPEST = 200  # elements within each other
LONGEST_ENTITY = 200  # characters

_PROBLEMS = {  # what Expat says, said to a student
    "no element found": "There is no element in it, or the last one does not end",
    "not well-formed (invalid token)": "A mark stands where none can; & is written &amp;, < &lt;",
    "junk after document element": "Something follows behind the end of the first element",
    "duplicate attribute": "An attribute is there twice",
    "unclosed token": "A tag, a comment or a section does not end",
    "undefined entity": "There is a name between & and ; that is not defined; & is written &amp;",
}


def read_xml(source: str | bytes, node: type[N]) -> N:
    """Return the root element of a document.

    Parameters
    ----------
    source : str or bytes
        The document. Bytes are decoded as it says itself.
    node : type
        The class of the nodes.

    Raises
    ------
    MalformedError
        If it is not well-formed, or not safe to read.

    Examples
    --------
    >>> read_xml("<a><b>text</b></a>", Node).first_at("b").content()
    'text'
    """
    return _Builder(node).build(source)


class _Builder(Generic[N]):
    """Makes nodes of what the parser tells."""

    def __init__(self, node: type[N]) -> None:
        self._node = node
        self._parser = parser = expat.ParserCreate()
        self._roots: list[N] = []
        self._open: list[N] = []
        self._is_raw = False
        parser.buffer_text = True
        parser.StartElementHandler = self._start
        parser.EndElementHandler = lambda _name: self._open.pop()
        parser.CharacterDataHandler = self._characters
        parser.CommentHandler = lambda text: self._place(Kind.COMMENT, text)
        parser.ProcessingInstructionHandler = self._instruction
        parser.StartCdataSectionHandler = self._begin_raw
        parser.EndCdataSectionHandler = self._end_raw
        parser.EntityDeclHandler = self._entity

    def build(self, source: str | bytes) -> N:
        try:
            self._parser.Parse(source, True)
        except expat.ExpatError as error:
            raise MalformedError(self._problem(error), error.lineno, error.offset + 1) from None
        except (ValueError, LookupError) as error:  # an encoding that Python does not know
            if isinstance(error, MalformedError):
                raise
            raise self._error(f"It is in an encoding that cannot be read ({error})") from None
        return self._roots[0]

    def _problem(self, error: expat.ExpatError) -> str:
        message = expat.ErrorString(error.code) or "not well-formed"
        if self._open and message in ("mismatched tag", "no element found"):
            name = self._open[-1].name
            return f"<{name}> is not closed: </{name}> is missing"
        return _PROBLEMS.get(message, f"The XML is wrong ({message})")

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        if len(self._open) == DEEPEST:
            raise self._error(f"More than {DEEPEST} elements lie within each other")
        node = self._node.__new__(self._node)
        Node.__init__(node, name)
        node.attributes = attributes
        if self._open:
            self._open[-1].place_last(node)
        else:
            self._roots.append(node)
        self._open.append(node)

    def _characters(self, text: str) -> None:
        siblings = self._open[-1].children
        if not self._is_raw and siblings and siblings[-1].kind is Kind.TEXT:
            siblings[-1].text += text
        else:
            self._place(Kind.RAW if self._is_raw else Kind.TEXT, text)

    def _begin_raw(self) -> None:
        self._is_raw = True

    def _end_raw(self) -> None:
        self._is_raw = False

    def _instruction(self, name: str, text: str) -> None:
        self._place(Kind.INSTRUCTION, text, name)

    def _place(self, kind: Kind, text: str, name: str = "") -> None:
        if self._open:  # what stands outside of the root is left out
            node = self._node.__new__(self._node)
            Node.__init__(node, name, kind, text)
            self._open[-1].place_last(node)

    def _entity(self, name: str, _is_parameter: bool, value: str | None, *_: str | None) -> None:
        if value is not None and ("&" in value or "%" in value or len(value) > LONGEST_ENTITY):
            problem = f"The entity {name} is made of others, or is too long to be safe"
            raise self._error(problem)

    def _error(self, problem: str) -> MalformedError:
        parser = self._parser
        return MalformedError(problem, parser.CurrentLineNumber, parser.CurrentColumnNumber + 1)
