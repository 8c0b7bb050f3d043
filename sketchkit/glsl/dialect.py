"""Stub by the lead, to be replaced: see the task."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Modern:
    text: str
    renamed: Mapping[str, str] = field(default_factory=dict)


def modernize(source: str, stage: str, version: int) -> Modern:
    t = re.sub(r"\btexture\b(?!\s*\()", "texture_", source)
    t = re.sub(r"\battribute\b", "in", t)
    t = re.sub(r"\bvarying\b", "out" if stage == "vertex" else "in", t)
    t = re.sub(r"\btexture2D\b", "texture", t)
    t = re.sub(r"\bvoid\s+main\s*\(\s*(void)?\s*\)", "void sk_main()", t)
    head = f"#version {version}\n"
    if stage == "vertex":
        head += "uniform float sk_y_sign;\n"
        t += "\nvoid main() { sk_main(); gl_Position.y *= sk_y_sign; }\n"
    else:
        head += "uniform float sk_height; uniform float sk_is_turned; vec4 sk_FragCoord; out vec4 sk_FragColor;\n"
        t = re.sub(r"\bgl_FragColor\b", "sk_FragColor", t)
        t = re.sub(r"\bgl_FragCoord\b", "sk_FragCoord", t)
        t += "\nvoid main() { sk_FragCoord = gl_FragCoord; if (sk_is_turned > 0.5) sk_FragCoord.y = sk_height - sk_FragCoord.y; sk_main(); }\n"
    return Modern(head + t, {"texture": "texture_"})
