"""What Processing has of OpenGL itself: sending off what is drawn, and `beginPGL()`."""

from __future__ import annotations

from sketchkit.api._parts import CanvasParts


class PGL:
    """What `beginPGL()` gives. OpenGL's own calls are not here; each says what to use instead.

    Examples
    --------
    >>> pgl = beginPGL()
    >>> isinstance(pgl, PGL)
    True
    >>> endPGL()
    """

    def flush(self) -> None:
        """Do nothing: `beginPGL()` has sent off what was drawn.

        Examples
        --------
        >>> pgl = beginPGL()
        >>> pgl.flush()
        >>> endPGL()
        """

    def finish(self) -> None:
        """Do nothing: `beginPGL()` has sent off what was drawn.

        Examples
        --------
        >>> pgl = beginPGL()
        >>> pgl.finish()
        >>> endPGL()
        """

    def __enter__(self) -> PGL:
        """Return itself: `with beginPGL() as pgl:` needs no `endPGL()`."""
        return self

    def __exit__(self, *reason: object) -> None:
        """Do nothing: there is nothing to end."""


class GlAccess(CanvasParts):
    """`flush()`, `beginPGL()`, `endPGL()`, and what kind of canvas it is."""

    def flush(self) -> None:
        """Draw now what has been called for so far.

        See Also
        --------
        beginPGL

        Notes
        -----
        A sketch needs it for nothing but measuring times: what reads the picture does it by itself.
        In P3D lines come after faces only among what is drawn together, so it can change pictures.

        Examples
        --------
        >>> rect(10, 20, 30, 40)
        >>> flush()
        """
        self._renderer.flush()

    def beginPGL(self) -> PGL:
        """Draw what has been called for so far, and return a `PGL`.

        See Also
        --------
        endPGL, flush, shader

        Notes
        -----
        sketchkit does not let sketches call OpenGL: it also draws without it. Shaders
        (`loadShader()`), `blendMode()`, `hint()` and `PShape` do what these calls are used for.

        Examples
        --------
        >>> pgl = beginPGL()
        >>> endPGL()
        """
        self._renderer.flush()
        return PGL()

    def endPGL(self) -> None:
        """Go on after `beginPGL()`.

        Examples
        --------
        >>> pgl = beginPGL()
        >>> endPGL()
        """

    def isGL(self) -> bool:
        """Return whether the canvas is of `P2D` or `P3D`.

        See Also
        --------
        is2D, is3D

        Examples
        --------
        >>> size(100, 100, P2D)
        >>> isGL()
        True
        """
        return not self._stage.is_java2d

    def is2D(self) -> bool:
        """Return whether the canvas is flat.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> is2D()
        False
        """
        return not self._stage.is_3d

    def is3D(self) -> bool:
        """Return whether the canvas has depth: whether it is of `P3D`.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> is3D()
        True
        """
        return self._stage.is_3d
