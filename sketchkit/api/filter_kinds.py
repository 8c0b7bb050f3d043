"""What `filter()` can be asked for, and what each kind does with pixels."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from sketchkit.core import constants as c
from sketchkit.core.errors import SketchError, shown, wrong_numbers
from sketchkit.draw.vertex import U8
from sketchkit.imaging import filters
from sketchkit.imaging.blurring import blurred

FILTER_USAGE = "kind [, number]"

# The filters, by what follows their kind: nothing, or a number.
PLAIN_FILTERS: dict[int, tuple[str, Callable[[U8], U8]]] = {
    c.GRAY: ("GRAY", filters.gray),
    c.INVERT: ("INVERT", filters.inverted),
    c.OPAQUE: ("OPAQUE", filters.opaque),
    c.ERODE: ("ERODE", filters.eroded),
    c.DILATE: ("DILATE", filters.dilated),
}
FILTERS_BY_NUMBER = {c.BLUR: "BLUR", c.POSTERIZE: "POSTERIZE", c.THRESHOLD: "THRESHOLD"}
USUAL_NUMBERS = {c.BLUR: 1.0, c.THRESHOLD: 0.5}
FILTER_NAMES = {kind: name for kind, (name, _) in PLAIN_FILTERS.items()} | FILTERS_BY_NUMBER


def check_filter(kind: object, number: object) -> None:
    """Refuse an unknown filter, and a number that does not fit the one that is asked for."""
    name = FILTER_NAMES.get(kind) if isinstance(kind, int) else None
    if name is None:
        *names, last = FILTER_NAMES.values()
        raise SketchError(
            f"filter() takes {', '.join(names)} or {last}.",
            got=shown(kind),
            hint=f"Write {kind} without quotes." if isinstance(kind, str) else None,
        )
    if number is None:
        if kind == c.POSTERIZE:
            raise SketchError(
                "POSTERIZE takes a number of levels.", hint="Write filter(POSTERIZE, 4)."
            )
        return
    if kind in PLAIN_FILTERS:
        raise SketchError(f"{name} takes no number.", hint=f"Write filter({name}).")
    if isinstance(number, bool) or not isinstance(number, int | float | np.number):
        raise wrong_numbers("filter", (kind, number), FILTER_USAGE)
    if kind == c.POSTERIZE and not 2 <= number < 256:
        raise SketchError("POSTERIZE takes 2 to 255 levels.", got=shown(number))


def filtered(data: U8, image_format: int, kind: int, number: float | None) -> tuple[U8, int]:
    """Return filtered pixels, and the format that they then have."""
    if kind in PLAIN_FILTERS:
        if kind == c.GRAY and image_format == c.ALPHA:  # a mask becomes a picture of it
            return filters.opaque(255 - data[..., [2, 2, 2, 2]]), c.RGB
        return PLAIN_FILTERS[kind][1](data), c.RGB if kind == c.OPAQUE else image_format
    level = USUAL_NUMBERS.get(kind, 0.0) if number is None else float(number)
    if kind == c.THRESHOLD:
        return filters.threshold(data, level), image_format
    if kind == c.POSTERIZE:
        return filters.posterized(data, int(level)), image_format
    result = blurred(data, level)
    return filters.opaque(result) if image_format == c.RGB else result, image_format
