"""`filter(f, values)` becomes a list; `filter(BLUR)`, whose answer nobody takes, stays."""

from fissix.fixer_util import Node
from fissix.fixes import fix_filter
from fissix.pytree import Base

from sketchkit.pymode.fixers.arguments import is_statement


class FixFilter(fix_filter.FixFilter):  # type: ignore[misc] # the library ships no types
    """Leaves calls alone that are a statement of their own."""

    def transform(self, node: Node, results: dict[str, object]) -> Base | None:
        """Return what stands in place of the call; None leaves it."""
        if is_statement(node):
            return None
        changed: Base | None = super().transform(node, results)
        return changed
