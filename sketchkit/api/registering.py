"""`registerMethod()`: how a library takes part in the life of a sketch."""

from __future__ import annotations

from sketchkit.api._sketch_parts import SketchParts
from sketchkit.core.errors import SketchError, either, nearest, shown

# When each is called. Those on phones alone are accepted, and never called.
OCCASIONS = (
    *("pre", "draw", "post", "mouseEvent", "keyEvent", "dispose"),
    *("touchEvent", "pause", "resume"),
)


class Registering(SketchParts):
    """`registerMethod()` and its opposite."""

    def registerMethod(self, methodName: str, target: object) -> None:
        """Have a method of an object called, frame by frame or whenever something happens.

        Parameters
        ----------
        methodName : str
            `"pre"` is called before each `draw()`, `"draw"` after it and after all handlers,
            `"post"` when the picture is complete, `"dispose"` at the end. `"mouseEvent"` takes the
            event, before the sketch's own handler; `"keyEvent"` after it.
        target : object
            It has a method of that name.

        Raises
        ------
        SketchError
            If it has not, is registered already, or there is no such occasion.

        See Also
        --------
        unregisterMethod

        Notes
        -----
        It is meant for libraries, and for classes that shall work by themselves. Source:
        Processing's reference, registerMethod().

        Examples
        --------
        >>> class Trail:
        ...     def __init__(self):
        ...         self.places = []
        ...         registerMethod("pre", self)
        ...     def pre(self):
        ...         self.places.append((mouseX, mouseY))
        >>> trail = Trail()
        """
        _check_occasion("registerMethod", methodName)
        if not callable(getattr(target, methodName, None)):
            raise SketchError(
                f"registerMethod() needs an object with a method {methodName}().",
                got=f"registerMethod({shown(methodName)}, {shown(target)})",
            )
        targets = self.registered.setdefault(methodName, [])
        if any(known is target for known in targets):
            raise SketchError(f"{methodName}() of this object is registered already.")
        targets.append(target)

    def unregisterMethod(self, methodName: str, target: object) -> None:
        """Have it called no longer.

        See Also
        --------
        registerMethod

        Examples
        --------
        >>> class Counter:
        ...     count = 0
        ...     def post(self):
        ...         self.count += 1
        ...         if self.count == 3:
        ...             unregisterMethod("post", self)
        >>> registerMethod("post", Counter())
        """
        _check_occasion("unregisterMethod", methodName)
        targets = self.registered.get(methodName, [])
        targets[:] = [known for known in targets if known is not target]


def _check_occasion(caller: str, name: object) -> None:
    if name in OCCASIONS:
        return
    known = nearest(str(name), OCCASIONS)
    raise SketchError(
        f"{caller}() knows {either(OCCASIONS)}.",
        got=f"{caller}({shown(name)}, ...)",
        hint=f"Do you mean {known}?" if known else None,
    )
