"""Stub by the lead, to be replaced: see the task."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class Declared:
    type: str
    length: int | None = None


@dataclass(frozen=True)
class Interface:
    kind: str | None
    uniforms: Mapping[str, Declared]
    attributes: frozenset[str]


def read_interface(vertex: str | None, fragment: str | None) -> Interface:
    both = (vertex or "") + "\n" + (fragment or "")
    kind = re.search(r"PROCESSING_(COLOR|TEXTURE|LIGHT|TEXLIGHT|LINE|POINT)_SHADER", both)
    uniforms = {}
    for m in re.finditer(r"uniform\s+(?:(?:low|medium|high)p\s+)?(\w+)\s+([^;]+);", both):
        for part in m[2].split(","):
            n = re.match(r"\s*(\w+)\s*(?:\[(\d+)\])?", part)
            uniforms[n[1]] = Declared(m[1], int(n[2]) if n[2] else None)
    attributes = frozenset(re.findall(r"(?:attribute|in)\s+\w+\s+(\w+)\s*;", vertex or ""))
    return Interface(kind[1] if kind else None, uniforms, attributes)
