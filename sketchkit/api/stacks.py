"""push() and pop(): matrix and style together."""

from __future__ import annotations

from sketchkit.api._parts import Block
from sketchkit.api.style import Styling
from sketchkit.api.transforms import Transforms


class Stacks(Styling, Transforms):
    """Putting everything aside at once."""

    def push(self) -> Block:
        """Put matrix and style aside until `pop()`; `with push():` takes them back by itself.

        See Also
        --------
        pop, pushMatrix, pushStyle

        Examples
        --------
        >>> with push():
        ...     translate(50, 50)
        ...     fill(255, 0, 0)
        ...     rect(0, 0, 30, 30)
        >>> rect(0, 0, 30, 30)
        """
        self.pushStyle()
        self.pushMatrix()
        return Block(self.pop)

    def pop(self) -> None:
        """Take back what `push()` put aside.

        Raises
        ------
        SketchError
            If there is nothing.

        Examples
        --------
        >>> push()
        >>> translate(50, 50)
        >>> pop()
        >>> rect(0, 0, 30, 30)
        """
        self.popStyle()
        self.popMatrix()
