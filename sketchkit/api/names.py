"""Every name that a sketch sees without importing it, and where it comes from.

The runtime puts them under the sketch's own names, `stubs.py` writes them down for editors, and
errors look for the nearest of them.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from types import ModuleType

from sketchkit.api import arrays, conversions, maths, strings
from sketchkit.api.data.dicts.float_dict import DoubleDict, FloatDict
from sketchkit.api.data.dicts.int_dict import IntDict, LongDict
from sketchkit.api.data.dicts.string_dict import StringDict
from sketchkit.api.data.json.json_array import JSONArray
from sketchkit.api.data.json.json_object import JSONObject
from sketchkit.api.data.lists.float_list import DoubleList, FloatList
from sketchkit.api.data.lists.int_list import IntList, LongList
from sketchkit.api.data.lists.string_list import StringList
from sketchkit.api.data.streams import BufferedReader, PrintWriter
from sketchkit.api.data.tables.table import Table
from sketchkit.api.data.tables.table_row import TableRow
from sketchkit.api.data.xml.xml import XML
from sketchkit.api.events import Event, KeyEvent, MouseEvent
from sketchkit.api.gl_access import PGL
from sketchkit.api.host import PSurface
from sketchkit.api.live import live_names
from sketchkit.api.overlaps import opener, overlaps
from sketchkit.api.pconstants import PConstants
from sketchkit.api.pfont import PFont
from sketchkit.api.pimage import PImage
from sketchkit.api.pmatrix import PMatrix2D, PMatrix3D
from sketchkit.api.pshader import PShader
from sketchkit.api.pshape.shape import PShape
from sketchkit.api.pvector import PVector
from sketchkit.api.sketch import Sketch
from sketchkit.core import constants

CLASSES: tuple[type, ...] = (
    *(Event, KeyEvent, MouseEvent, PConstants, PFont, PGL, PImage, PMatrix2D, PMatrix3D),
    *(PShader, PShape, PSurface, PVector),
    *(StringList, IntList, LongList, FloatList, DoubleList),
    *(StringDict, IntDict, LongDict, FloatDict, DoubleDict),
    *(Table, TableRow, JSONObject, JSONArray, XML, BufferedReader, PrintWriter),
)

Names = dict[str, object]


class TwinNamesError(Exception):
    """Two groups define the same name, so that a sketch would see only one of the two."""


def names_of(sketch: Sketch) -> Names:
    """Return the names of a sketch and what they stand for; live values as they are now."""
    return joined(groups_of(sketch)) | live_values(sketch)


def groups_of(sketch: Sketch) -> dict[str, Names]:
    """Return the names that stay the same as long as the sketch lives, by where they come from."""
    canvas = sketch.canvas
    both = overlaps(canvas)
    return {
        "canvas": {
            name: value
            for name, value in _public(canvas).items()
            if name not in both and callable(value)
        },
        "sketch": _without(_public(sketch), live_names(type(sketch))),
        "itself": {"this": sketch, "g": canvas, "args": sketch.args},
        "overlaps": {**both, "open": opener(sketch.folder)},
        "maths": _exported(maths),
        "strings": _exported(strings),
        "conversions": _exported(conversions),
        "arrays": _exported(arrays),
        "constants": {n: v for n, v in vars(constants).items() if n.isupper()},
        "classes": {kind.__name__: kind for kind in (*CLASSES, type(canvas))},
    }


def joined(groups: Mapping[str, Names]) -> Names:
    """Return all names in one dictionary.

    Raises
    ------
    TwinNamesError
        If a name is in two groups.
    """
    names: Names = {}
    for group, members in groups.items():
        if twins := sorted(names.keys() & members.keys()):
            raise TwinNamesError(
                f"{group} has names that another group has too: {', '.join(twins)}"
            )
        names |= members
    return names


def live_values(sketch: Sketch) -> Names:
    """Return the names whose values change, with their present values."""
    return {name: getattr(sketch, name) for name in live_names(type(sketch))} | {
        name: getattr(sketch.canvas, name) for name in live_names(type(sketch.canvas))
    }


def _public(owner: object) -> Names:
    """Return what the groups of methods define that an owner consists of.

    Names of ours have underscores in them, or are defined where the groups are joined.
    """
    kind = type(owner)
    names = (name for name in dir(kind) if "_" not in name and name not in vars(kind))
    return {name: getattr(owner, name) for name in names}


def _without(names: Names, excluded: Iterable[str]) -> Names:
    return {name: value for name, value in names.items() if name not in set(excluded)}


def _exported(module: ModuleType) -> Names:
    return {name: getattr(module, name) for name in module.__all__}
