"""Answers as text for the terminal and the window, and as JSON."""

from __future__ import annotations

from sketchkit.runtime.explore.describe import Color, Description, Surroundings, describe
from sketchkit.runtime.explore.layers import Layer, Part
from sketchkit.runtime.explore.log import FrameLog
from sketchkit.runtime.explore.matrices import number, rows_of

PARTS = {
    Part.FILL: "its fill",
    Part.STROKE: "its outline (stroke)",
    Part.POINT: "a point (stroke)",
    Part.BACKGROUND: "the background",
    Part.PIXELS: "pixels that were set",
}
FILLS = {"image": "the image", "letter": "a letter", "line": "a line", "point": "a point"}


def part_in_words(description: Description) -> str:
    """Return which part of what a call draws it is."""
    if description.layer.part in (Part.FILL, Part.STROKE) and description.kind in FILLS:
        return FILLS[description.kind]
    return PARTS[description.layer.part]


def why(log: FrameLog, layer: Layer, around: Surroundings) -> str:
    """Return whether a layer shows, or why it does not."""
    if layer.is_visible:
        percent = round(100 * layer.share)
        return f"visible, {percent if percent else 'less than 1'} % of the colour"
    if layer.clipped and layer.clipped == layer.covered:
        return "hidden: cut off by clip()"
    if layer.behind is not None and layer.beneath is None:
        return f"hidden: behind {describe(log, layer.behind, around).title}"
    if layer.beneath is not None:
        if (layer.beneath.moment[0], layer.beneath.row) == (layer.moment[0], layer.row):
            return "hidden: painted over by its own outline"
        return f"hidden: painted over by {describe(log, layer.beneath, around).title}"
    if layer.discarded:
        return "invisible: its shader discards this pixel"
    if layer.transparent:
        return "invisible: its alpha is 0 here"
    if layer.unchanging:
        mode = layer.pipeline.blend.name if layer.pipeline else "BLEND"
        return f"without effect: blendMode({mode}) changes nothing here"
    return "hidden: what is drawn over it leaves less than one shade of it"


def color_text(color: Color) -> str:
    """Return a colour as a sketch writes it, and in hexadecimal."""
    red, green, blue, alpha = color
    see_through = "" if alpha == 255 else f", alpha {alpha}"
    return f"{red}, {green}, {blue} (#{red:02X}{green:02X}{blue:02X}){see_through}"


def call_lines(description: Description) -> list[str]:
    """Return the call, and the calls of the sketch's functions that led to it."""
    lines = []
    inner = description.sites[0] if description.sites else None
    lines.append(description.title + (f"    ({inner.where})" if inner else ""))
    for called, site in zip(description.sites, description.sites[1:], strict=False):
        times = f", {site.times} times, each in the one before" if site.times > 1 else ""
        name = called.function or "it"
        lines.append(f"    {name}() was called {site.where}, {site.place}{times}")
    return lines


def detail_lines(description: Description) -> list[str]:
    """Return everything that a call was drawn with, a value a line."""
    entries = [(name, text) for name, text in _entries(description) if text]
    width = max((len(name) for name, _ in entries), default=0)
    lines = []
    for name, text in entries:
        first, *rest = text.split("\n")
        lines.append(f"{name:<{width}}  {first}")
        lines += [f"{'':<{width}}  {line}" for line in rest]
    return lines


def _entries(own: Description) -> list[tuple[str, str]]:
    layer, paint = own.layer, own.paint
    place, count = own.which
    entries = [("part", f"{part_in_words(own)}, {_samples(layer)}")]
    if count > 1:
        entries.append(("which", f"number {place} of {count} that this line drew in this way"))
    if own.began and own.began != own.line:
        entries.append(("shape", f"from beginShape() in line {own.began} on"))
    entries += [("made", f"{site.place}: {site.text}") for site in own.made[:1]]
    if own.kind == "background":
        return [*entries, ("color", color_text(paint.fill) if paint.fill else "")]
    if own.kind == "pixels":
        return entries
    varies = " and others: a colour for each vertex" if paint.varies else ""
    if own.kind == "image":
        entries.append(("tint", color_text(paint.tint) if paint.tint else "none"))
    else:
        entries.append(("fill", (color_text(paint.fill) + varies) if paint.fill else "none"))
    if paint.stroke:
        weight = f", weight {number(paint.weight or 0)}"
        entries.append(("stroke", color_text(paint.stroke) + weight + varies))
    elif own.kind not in ("image", "letter"):
        entries.append(("stroke", "none"))
    return [*entries, *_surroundings(own)]


def _surroundings(own: Description) -> list[tuple[str, str]]:
    """Return what is the same for fill and stroke."""
    entries = []
    if own.modelview is not None:
        rows = "\n".join(
            "  ".join(f"{number(v):>9}" for v in row) for row in rows_of(own.modelview)
        )
        depth = f", within {own.nesting} pushMatrix()" if own.nesting else ""
        entries.append(("matrix", f"{own.doing}{depth}\n{rows}"))
    if own.lights is not None:
        text = "\n".join(own.lights) or "switched on, but there are none: all is black"
        entries += [("lights", text), ("material", own.material)]
    entries += [("texture", own.texture), ("shader", own.shader)]
    if own.blend != "BLEND":
        entries.append(("blend", f"blendMode({own.blend})"))
    if own.depth.startswith(("not", "compared, not")):
        entries.append(("depth", own.depth))
    if own.clip is not None:
        left, top, width, height = own.clip
        entries.append(("clip", f"{width} x {height} at {left}, {top}"))
    return entries


def _samples(layer: Layer) -> str:
    count = len(layer.shares)
    covered = min(layer.covered, count)
    return "the whole pixel" if covered == count else f"{covered} of the pixel's {count} samples"


def as_json(log: FrameLog, own: Description, around: Surroundings) -> dict[str, object]:
    """Return a description as JSON has it."""
    layer, paint = own.layer, own.paint
    value: dict[str, object] = {
        "file": own.sites[0].file if own.sites else None,
        "line": own.line or None,
        "call": own.sites[0].text if own.sites else None,
        "function": own.sites[0].function if own.sites else None,
        "calls": [
            {
                "file": s.file,
                "line": s.line,
                "function": s.function,
                "call": s.text,
                "times": s.times,
            }
            for s in own.sites[1:]
        ],
        "frame": own.frame,
        "kind": own.kind,
        "part": layer.part.value,
        "visible": layer.is_visible,
        "share": round(layer.share, 4),
        "why": why(log, layer, around),
        "fill": paint.fill,
        "stroke": paint.stroke,
        "stroke_weight": paint.weight,
        "color": layer.color.tolist(),
    }
    if own.made:
        value["made"] = {
            "file": own.made[0].file,
            "line": own.made[0].line,
            "call": own.made[0].text,
        }
    if own.modelview is not None:
        value |= {"modelview": rows_of(own.modelview), "matrix": own.doing, "nesting": own.nesting}
    if own.paint.tint is not None:
        value["tint"] = own.paint.tint
    if own.began is not None:
        value["begin_shape_line"] = own.began
    value |= {
        "lights": None if own.lights is None else list(own.lights),
        "material": own.material or None,
        "texture": own.texture or None,
        "shader": own.shader or None,
        "blend": own.blend or None,
        "clip": None if own.clip is None else list(own.clip),
    }
    return value
