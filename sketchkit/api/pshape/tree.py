"""A shape among others: parent, children, names."""

from __future__ import annotations

from typing import Self

from sketchkit.api.pshape.parts import Family, ShapeParts
from sketchkit.core.errors import SketchError, kind_of, shown


class ShapeTree(ShapeParts):
    """Groups and what is in them."""

    def addChild(self, who: Self, idx: int | None = None) -> None:
        """Put a shape into this group.

        Parameters
        ----------
        who : PShape
            It moves, turns and grows with the group from now on.
        idx : int, optional
            Its place among the children; without it, the last.

        Raises
        ------
        SketchError
            If this is no group, or `who` is no shape, or contains this group.

        See Also
        --------
        getChild, removeChild, createShape

        Notes
        -----
        Source: Processing's reference, PShape.addChild(); the course guide's section 4.9.

        Examples
        --------
        >>> snowman = createShape(GROUP)
        >>> snowman.addChild(createShape(ELLIPSE, 50, 70, 50, 50))
        >>> snowman.addChild(createShape(ELLIPSE, 50, 30, 30, 30))
        >>> shape(snowman)
        """
        if not isinstance(who, ShapeParts):
            raise SketchError("addChild() takes a PShape.", got=f"{kind_of(who)}: {shown(who)}")
        if not self._is_group:
            raise SketchError(
                "addChild() belongs to a group.", hint="createShape(GROUP) makes one."
            )
        if self in _with_descendants(who):
            raise SketchError("addChild(): a group cannot be put into itself.")
        self._children.insert(len(self._children) if idx is None else idx, who)
        who._parent = self
        self._unsettle()
        if who._name is not None:
            self.addName(who._name, who)

    def removeChild(self, idx: int) -> None:
        """Take a child out of this group, given its index.

        Examples
        --------
        >>> group = createShape(GROUP)
        >>> group.addChild(createShape(RECT, 10, 10, 50, 50))
        >>> group.removeChild(0)
        """
        child = self._child_at("removeChild", idx)
        self._unsettle()
        del self._children[self.getChildIndex(child)]
        child._parent = None

    def getChild(self, target: int | str) -> Self | None:
        """Return a child.

        Parameters
        ----------
        target : int or str
            Its index; or its name, which is looked for among all descendants.

        Returns
        -------
        PShape or None
            None if there is none of that name.

        Raises
        ------
        SketchError
            If there is no child of that index.

        See Also
        --------
        getChildCount, addChild, setName

        Notes
        -----
        In a file's shape the names are those of the file (the `id` in SVG). Source: Processing's
        reference, PShape.getChild().

        Examples
        --------
        >>> group = createShape(GROUP)
        >>> group.addChild(createShape(RECT, 10, 10, 50, 50))
        >>> group.getChild(0).setFill(color(255, 0, 0))
        >>> shape(group)
        """
        if not isinstance(target, str):
            return self._child_at("getChild", target)
        if self._name == target:
            return self
        if target in self._names:
            return self._names[target]
        found = (child.getChild(target) for child in self._children)
        return next((child for child in found if child is not None), None)

    def findChild(self, target: str) -> Self | None:
        """Return the shape of a name in the whole tree that this one belongs to.

        Examples
        --------
        >>> group = createShape(GROUP)
        >>> dot = createShape(ELLIPSE, 0, 0, 10, 10)
        >>> dot.setName("dot")
        >>> group.addChild(dot)
        >>> print(dot.findChild("dot") is dot)
        True
        """
        return self.getChild(target) if self._parent is None else self._parent.findChild(target)

    def getChildren(self) -> list[Self]:
        """Return the children, in order.

        Examples
        --------
        >>> group = createShape(GROUP)
        >>> print(len(group.getChildren()))
        0
        """
        return list(self._children)

    def getChildCount(self) -> int:
        """Return how many children the shape has.

        Examples
        --------
        >>> group = createShape(GROUP)
        >>> group.addChild(createShape(RECT, 10, 10, 50, 50))
        >>> print(group.getChildCount())
        1
        """
        return len(self._children)

    def getChildIndex(self, who: Self) -> int:
        """Return the index of a child, or -1.

        Examples
        --------
        >>> group = createShape(GROUP)
        >>> print(group.getChildIndex(createShape(RECT, 0, 0, 9, 9)))
        -1
        """
        return next((i for i, child in enumerate(self._children) if child is who), -1)

    def getParent(self) -> Self | None:
        """Return the group that the shape is in, or None.

        Examples
        --------
        >>> group = createShape(GROUP)
        >>> child = createShape(RECT, 10, 10, 50, 50)
        >>> group.addChild(child)
        >>> print(child.getParent() is group)
        True
        """
        return self._parent

    def getName(self) -> str | None:
        """Return the name, or None.

        Examples
        --------
        >>> print(createShape().getName())
        None
        """
        return self._name

    def setName(self, name: str) -> None:
        """Give the shape a name, for `getChild()`.

        Examples
        --------
        >>> door = createShape(RECT, 40, 50, 20, 40)
        >>> door.setName("door")
        """
        self._name = name

    def addName(self, nom: str, shape: Self) -> None:
        """Let `getChild(nom)` find a shape, in the whole tree.

        Examples
        --------
        >>> house = createShape(GROUP)
        >>> door = createShape(RECT, 40, 50, 20, 40)
        >>> house.addChild(door)
        >>> house.addName("entrance", door)
        >>> print(house.getChild("entrance") is door)
        True
        """
        if self._parent is not None:
            self._parent.addName(nom, shape)
        else:
            self._names[nom] = shape

    def getFamily(self) -> int:
        """Return GROUP, PShape.PRIMITIVE, PShape.PATH or PShape.GEOMETRY.

        Examples
        --------
        >>> print(createShape(GROUP).getFamily() == GROUP)
        True
        """
        return int(self._family)

    def getKind(self) -> int:
        """Return what `createShape()` or `beginShape()` was given.

        Examples
        --------
        >>> print(createShape(RECT, 0, 0, 9, 9).getKind() == RECT)
        True
        """
        return self._kind

    def isVisible(self) -> bool:
        """Return whether the shape is drawn.

        Examples
        --------
        >>> print(createShape().isVisible())
        True
        """
        return self._is_visible

    def setVisible(self, visible: bool) -> None:
        """Set whether the shape is drawn.

        Notes
        -----
        In P2D and P3D a child is drawn with its group all the same, as in Processing.

        Examples
        --------
        >>> s = createShape(RECT, 10, 10, 50, 50)
        >>> s.setVisible(False)
        >>> shape(s)
        """
        self._is_visible = bool(visible)
        self._version += 1

    def is3D(self) -> bool:
        """Return whether the shape was made in P3D.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> print(createShape(BOX, 20).is3D())
        True
        """
        return self._stage.is_3d

    def is2D(self) -> bool:
        """Return whether the shape was made on a flat canvas.

        Examples
        --------
        >>> print(createShape(RECT, 0, 0, 9, 9).is2D())
        True
        """
        return not self._stage.is_3d

    def _child_at(self, caller: str, index: int) -> Self:
        try:
            place = int(index)
        except (TypeError, ValueError):
            raise SketchError(
                f"{caller}() takes an index or a name.", got=f"{kind_of(index)}: {shown(index)}"
            ) from None
        if not 0 <= place < len(self._children):
            count = len(self._children)
            has = f"It has {count}, from 0 to {count - 1}." if count else "It has none."
            raise SketchError(
                f"The shape has no child of this index. {has}", got=f"{caller}({place})"
            )
        return self._children[place]


def _with_descendants(shape: ShapeParts) -> list[ShapeParts]:
    found = [shape]
    for member in shape._members():
        found += _with_descendants(member)
    return found


__all__ = ["Family", "ShapeTree"]
