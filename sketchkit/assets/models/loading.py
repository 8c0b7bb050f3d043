"""Models of any format to plain data: the ending of the file's name says which it is."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from sketchkit.assets.models.data import Model
from sketchkit.assets.models.gltf import read_gltf
from sketchkit.assets.models.obj import read_obj
from sketchkit.assets.models.ply import read_ply
from sketchkit.assets.models.stl import read_stl
from sketchkit.core.errors import SketchError, either

READERS: dict[str, Callable[[Path], Model]] = {
    ".obj": read_obj,
    ".ply": read_ply,
    ".stl": read_stl,
    ".gltf": read_gltf,
    ".glb": read_gltf,
}


def load_model(path: Path) -> Model:
    """Return the model in a file.

    Parameters
    ----------
    path : Path
        It ends in .obj, .ply, .stl, .gltf or .glb, in capitals or not.

    Raises
    ------
    SketchError
        If it is of another kind, or broken; what is wrong is told with its line or byte.
    """
    reader = READERS.get(path.suffix.lower())
    if reader is None:
        kinds = either(ending.removeprefix(".").upper() for ending in READERS)
        raise SketchError(
            f"{path} is no model that can be read.", hint=f"Models are {kinds} files."
        )
    return reader(path)
