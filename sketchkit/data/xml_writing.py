"""XML written as text, laid out as Processing does."""

from __future__ import annotations

import re
from typing import Final

from sketchkit.data.xml_tree import Kind, Node

COMPACT: Final = -1  # an indent: everything in one line
DECLARATION: Final = '<?xml version="1.0" encoding="UTF-8"?>\n'

_TEXT_MARKS = {"&": "&amp;", "<": "&lt;", ">": "&gt;", "\r": "&#13;"}
_ATTRIBUTE_MARKS = {**_TEXT_MARKS, '"': "&quot;", "\n": "&#10;", "\t": "&#9;"}


def write_xml(root: Node, indent: int) -> str:
    """Return a node as text.

    Parameters
    ----------
    root : Node
    indent : int
        How many spaces each level is moved to the right. With `COMPACT` everything is in one
        line, without the declaration at its beginning.

    Examples
    --------
    >>> root = Node("a")
    >>> root.place_last(Node("b")).attributes["size"] = "3"
    >>> write_xml(root, COMPACT)
    '<a><b size="3"/></a>'
    >>> print(write_xml(root, 2), end="")
    <?xml version="1.0" encoding="UTF-8"?>
    <a>
      <b size="3"/>
    </a>
    """
    namespaces = _inherited_namespaces(root)
    if indent == COMPACT:
        return _compact(root, namespaces)
    return DECLARATION + _indented(root, indent, 0, namespaces) + "\n"


def _compact(node: Node, more: dict[str, str] | None = None) -> str:
    if node.kind is not Kind.ELEMENT:
        return _leaf(node)
    if not _shown(node):
        return f"<{_head(node, more)}/>"
    inner = "".join(map(_compact, _shown(node)))
    if _is_mixed(node):  # line ends with what is indented about them become one space
        inner = re.sub(r"\s*\n\s*", " ", inner).strip()
    return f"<{_head(node, more)}>{inner}</{node.name}>"


def _indented(node: Node, indent: int, margin: int, more: dict[str, str] | None = None) -> str:
    if node.kind is not Kind.ELEMENT or not _is_mixed(node):
        return _compact(node, more)
    start = "\n" + " " * (margin + indent)
    parts = [f"<{_head(node, more)}>"]
    for child in _shown(node):
        if child.kind is not Kind.RAW:  # a space before it would belong to the text
            parts.append(start)
        part = _indented(child, indent, margin + indent)
        parts.append(part.strip() if child.kind is Kind.TEXT else part)
    if _shown(node)[-1].kind is not Kind.RAW:
        parts.append("\n" + " " * margin)
    return "".join(parts) + f"</{node.name}>"


def _shown(node: Node) -> list[Node]:
    """Return the children that are written: all but blank texts between others."""
    has_text_alone = len(node.children) == 1
    return [c for c in node.children if has_text_alone or not c.is_blank_text()]


def _is_mixed(node: Node) -> bool:
    """Return whether something else than text stands in an element."""
    return any(child.kind not in (Kind.TEXT, Kind.RAW) for child in node.children)


def _leaf(node: Node) -> str:
    match node.kind:
        case Kind.COMMENT:
            return f"<!--{node.text}-->"
        case Kind.RAW:
            return f"<![CDATA[{node.text.replace(']]>', ']]]]><![CDATA[>')}]]>"
        case Kind.INSTRUCTION:
            return f"<?{node.name} {node.text}?>"
        case _:
            return "".join(_TEXT_MARKS.get(mark, mark) for mark in node.text)


def _head(node: Node, more: dict[str, str] | None) -> str:
    """Return the name and the attributes of an element, these in the order of the alphabet."""
    attributes = {**(more or {}), **node.attributes}
    return node.name + "".join(
        f' {name}="{"".join(_ATTRIBUTE_MARKS.get(mark, mark) for mark in attributes[name])}"'
        for name in sorted(attributes, key=lambda name: (not name.startswith("xmlns"), name))
    )


def _inherited_namespaces(node: Node) -> dict[str, str]:
    """Return the namespaces that a node would lose outside of its document."""
    found: dict[str, str] = {}
    parent = node.parent
    while parent is not None:
        found = {n: v for n, v in parent.attributes.items() if n.startswith("xmlns")} | found
        parent = parent.parent
    return found
