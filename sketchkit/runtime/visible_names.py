"""All names that a sketch sees without adding any: the language's, and those of libraries."""

from __future__ import annotations

from sketchkit.api.names import groups_of, joined, live_values
from sketchkit.api.sketch import Sketch
from sketchkit.libraries.built_in import BUILT_IN
from sketchkit.runtime.adding import adder

Names = dict[str, object]


def all_groups(sketch: Sketch) -> dict[str, Names]:
    """Return the names by where they come from; values that change are not among them.

    `add_library()` is one that adds to nothing: each sketch has its own.
    """
    return groups_of(sketch) | {"libraries": {**BUILT_IN, "add_library": adder({})}}


def all_names(sketch: Sketch) -> Names:
    """Return all of them, values as they are now."""
    return joined(all_groups(sketch)) | live_values(sketch)
