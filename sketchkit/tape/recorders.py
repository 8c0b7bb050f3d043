"""A recorder on a tape: its buffers as they are, its tables value by value."""

from __future__ import annotations

from collections.abc import Callable
from typing import cast

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.style import Material, Style
from sketchkit.draw.meshes import MeshPart
from sketchkit.draw.recorder import CORNER, NO_CUSTOM, ROW, UV, Attributes, Recorder, ShapeRun
from sketchkit.draw.resources import Pixels, Target
from sketchkit.draw.stage import Stage
from sketchkit.tape.messages import TapeError
from sketchkit.tape.values import Decoder, Encoder

BUFFERS = {"rows": ("row_end", ROW), "corners": ("corner_end", CORNER), "uvs": ("uv_end", UV)}
TABLES: dict[str, type | tuple[type, ...]] = {
    "styles": Style,
    "stages": Stage,
    "nestings": int,
    "shapes": ShapeRun,
    "textures": (Pixels, Target),
    "parts": MeshPart,
}


def encode_recorder(recorder: Recorder, encoder: Encoder) -> dict[str, object]:
    """Return a recorder as JSON has it; the buffers go to the encoder's body."""
    value: dict[str, object] = {
        name: encoder.array(memoryview(getattr(recorder, name))[: getattr(recorder, end)])
        for name, (end, _) in BUFFERS.items()
    }
    value |= {name: encoder.encode(getattr(recorder, name)) for name in TABLES}
    value["matrices"] = encoder.array(np.array(recorder.matrices, np.float64))
    value["attributes"] = _encode_attributes(recorder.attributes, encoder)
    value["normals"] = encoder.encode(recorder.normals)
    return value


def decode_recorder(value: dict[str, object], decoder: Decoder) -> Recorder:
    """Return the recorder that was encoded.

    Raises
    ------
    TapeError
        If none can have been.
    """
    recorder = Recorder(0)
    try:
        for name, (end, size) in BUFFERS.items():
            data = decoder.array(value[name]).tobytes()
            _check(len(data) % size == 0)
            setattr(recorder, name, bytearray(data))
            setattr(recorder, end, len(data))
        for name, kind in TABLES.items():
            items = decoder.decode(value[name])
            _check(isinstance(items, list) and all(isinstance(item, kind) for item in items))
            setattr(recorder, name, items)
        recorder.matrices = decoder.array(value["matrices"]).tolist()
        recorder.attributes = _decode_attributes(value["attributes"], decoder)
        recorder.normals = cast("NDArray[np.float32] | None", decoder.decode(value["normals"]))
    except KeyError:
        raise TapeError("The recording is damaged.") from None
    _check(len(recorder.styles) == len(recorder.stages) == len(recorder.nestings))
    _check(len(recorder.matrices) == 12 * len(recorder.stages))
    recorder.meshes = {part.mesh for part in recorder.parts}
    return recorder


def _encode_attributes(entries: list[Attributes], encoder: Encoder) -> dict[str, object]:
    """Return the attributes of corners column by column: there is one entry for each normal()."""
    materials = list(dict.fromkeys(entry.material for entry in entries))
    customs = {id(entry.custom): entry.custom for entry in entries}
    material_index = {material: index for index, material in enumerate(materials)}
    custom_index = {identity: index for index, identity in enumerate(customs)}
    return {
        "normals": encoder.array(np.array([e.normal for e in entries], np.float64).reshape(-1, 3)),
        "weights": encoder.array(np.array([entry.weight for entry in entries], np.float64)),
        "material": _indices(entries, lambda entry: material_index[entry.material], encoder),
        "custom": _indices(entries, lambda entry: custom_index[id(entry.custom)], encoder),
        "materials": encoder.encode(materials),
        "customs": encoder.encode(list(customs.values())),
    }


def _indices(
    entries: list[Attributes], index_of: Callable[[Attributes], int], encoder: Encoder
) -> object:
    return encoder.array(np.array([index_of(entry) for entry in entries], np.int32))


def _decode_attributes(value: object, decoder: Decoder) -> list[Attributes]:
    _check(isinstance(value, dict))
    table = cast("dict[str, object]", value)
    normals = decoder.array(table["normals"]).tolist()
    weights = decoder.array(table["weights"]).tolist()
    material, custom = (decoder.array(table[name]).tolist() for name in ("material", "custom"))
    materials = cast("list[Material]", decoder.decode(table["materials"]))
    customs = cast("list[dict[str, object]]", decoder.decode(table["customs"]))
    _check(all(isinstance(one, Material) for one in materials))
    try:
        return [
            # One and the same empty mapping, as it was: what has none is told by it.
            Attributes(tuple(normal), materials[m], weight, customs[c] or NO_CUSTOM)
            for normal, weight, m, c in zip(normals, weights, material, custom, strict=True)
        ]
    except (IndexError, TypeError, ValueError):
        raise TapeError("The recording is damaged.") from None


def _check(is_right: bool) -> None:
    if not is_right:
        raise TapeError("The recording is damaged.")
