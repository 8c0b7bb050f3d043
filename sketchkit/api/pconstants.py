"""PConstants: Processing's constants by the name of a class, as `PShape.QUADS` has them."""

from __future__ import annotations

from sketchkit.core import constants


class PConstants:
    """Every constant of Processing: `PConstants.CENTER` is `CENTER`.

    Notes
    -----
    In Processing its classes take the constants over from here, so that `PShape.QUADS` and
    `PImage.ARGB` are right as well.

    Examples
    --------
    >>> PConstants.HALF_PI == HALF_PI
    True
    """


for _name, _value in vars(constants).items():
    if _name.isupper():
        setattr(PConstants, _name, _value)
