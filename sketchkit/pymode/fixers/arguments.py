"""What a call in the library's tree looks like."""

from fissix.pgen2 import token
from fissix.pygram import python_symbols
from fissix.pytree import Base


def count_of_arguments(call: Base) -> int:
    """Return how many values stand between the brackets of a call."""
    trailer = next((part for part in call.children if part.type == python_symbols.trailer), None)
    if trailer is None or len(trailer.children) < 3:
        return 0
    inner = trailer.children[1]
    if inner.type != python_symbols.arglist:
        return 1
    return sum(part.type != token.COMMA for part in inner.children)


def is_statement(call: Base) -> bool:
    """Tell whether a call is all there is of a statement."""
    return call.parent is not None and call.parent.type == python_symbols.simple_stmt
