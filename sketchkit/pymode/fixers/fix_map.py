"""`map(f, values)` becomes a list; `map(value, 0, 1, 2, 3)` is Processing's and stays."""

from fissix.fixer_util import Node
from fissix.fixes import fix_map
from fissix.pytree import Base

from sketchkit.pymode.fixers.arguments import count_of_arguments

PROCESSING_TAKES = 5


class FixMap(fix_map.FixMap):  # type: ignore[misc] # the library ships no types
    """Leaves calls with five arguments alone."""

    def transform(self, node: Node, results: dict[str, object]) -> Base | None:
        """Return what stands in place of the call; None leaves it."""
        if count_of_arguments(node) == PROCESSING_TAKES:
            return None
        changed: Base | None = super().transform(node, results)
        return changed
