"""MTL files: the materials of OBJ files.

Read as Processing reads them: a line with too few numbers changes nothing, and whatever stands
before the first `newmtl`, be it a comment, makes a gray material.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from sketchkit.assets.models.data import ModelMaterial, Rgb, read_text, said, texture_beside
from sketchkit.assets.models.number_rows import NumberRows, is_number

# Options of a texture with a fixed number of words; these three have one to three numbers.
OPTIONS = {"-blendu": 1, "-blendv": 1, "-bm": 1, "-boost": 1, "-cc": 1, "-clamp": 1}
OPTIONS |= {"-imfchan": 1, "-mm": 2, "-texres": 1, "-type": 1}
VECTOR_OPTIONS = {"-o", "-s", "-t"}


def read_mtl(path: Path, known: int = 0) -> list[ModelMaterial]:
    """Return the materials of a file in their order.

    Parameters
    ----------
    path : Path
    known : int
        How many materials other files had already: a material without a name is called by it.

    Raises
    ------
    SketchError
        If a number cannot be read, or the file is no text.
    """
    materials: list[ModelMaterial] = []
    for line, text in enumerate(read_text(path, "MTL").splitlines(), 1):
        words = text.split()
        if words and words[0] == b"newmtl":
            materials.append(ModelMaterial(said(b" ".join(words[1:]))))
            continue
        if not materials:
            materials.append(ModelMaterial(f"material{known}"))
        if words:
            materials[-1] = _changed(path, line, materials[-1], words)
    return materials


def _changed(path: Path, line: int, material: ModelMaterial, words: list[bytes]) -> ModelMaterial:
    """Return a material after one more line."""
    keyword, *values = words
    match keyword:
        case b"Ka" if len(values) >= 3:
            return replace(material, ambient=_color(path, line, values))
        case b"Kd" if len(values) >= 3:
            return replace(material, diffuse=_color(path, line, values))
        case b"Ks" if len(values) >= 3:
            return replace(material, specular=_color(path, line, values))
        case b"Ns" if values:
            return replace(material, shininess=_numbers(path, line, values, 1)[0])
        case b"d" if values:
            return replace(material, opacity=_numbers(path, line, values, 1)[0])
        case b"Tr" if values:
            return replace(material, opacity=1 - _numbers(path, line, values, 1)[0])
        case b"map_Kd" if values:
            name = _file_name([said(word) for word in values])
            return replace(material, texture=texture_beside(path, f"line {line}", name))
    return material


def _color(path: Path, line: int, words: list[bytes]) -> Rgb:
    red, green, blue = _numbers(path, line, words, 3)
    return red, green, blue


def _numbers(path: Path, line: int, words: list[bytes], count: int) -> list[float]:
    rows = NumberRows(count)
    rows.add(path, line, words)
    rows.array(path)  # refuses what is no number
    return [float(word) for word in rows.words]


def _file_name(words: list[str]) -> str:
    """Return the name of a picture without the options before it; it may have spaces."""
    at = 0
    while at < len(words) - 1 and words[at] in OPTIONS.keys() | VECTOR_OPTIONS:
        if words[at] in OPTIONS:
            at += 1 + OPTIONS[words[at]]
            continue
        at += 1
        last = min(at + 3, len(words) - 1)
        while at < last and is_number(words[at]):
            at += 1
    return " ".join(words[at:])
