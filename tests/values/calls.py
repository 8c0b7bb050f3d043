"""The calls whose results are compared with Processing's: maths, chance, text, vectors, colours.

`listed_calls.txt` has them, except for those of chance: these are made here, for many seeds.

Each is a line of a sketch. Where it has several parts, divided by `"; "`, the last is the value.
The lines of a group follow one another in the same sketch, so a seed rules those below it.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

LISTED = Path(__file__).with_name("listed_calls.txt")

SEEDS = (
    *("0", "1", "2", "42", "-1", "-7", "123456789", "2147483647", "-2147483648", "4294967297"),
    *("9007199254740993", "-9223372036854775808", "3.7", "-3.7", "0.5", "1e6"),
)
PLACES = ("0", "0.5", "0.01", "0.999", "1", "1.5", "7.25", "15.9", "16", "255.3", "4095.5")
FAR_PLACES = ("-0.5", "-3.3", "-1000.1", "4096.7", "12345.678", "100000.3", "1000000.1", "9e6")


def every_call() -> Iterator[tuple[str, list[str]]]:
    """Yield the name of each group, and its calls in order."""
    yield from _listed()
    yield from _chance()
    yield from _noise()


def _listed() -> Iterator[tuple[str, list[str]]]:
    _, *groups = LISTED.read_text(encoding="utf-8").split("\n[")
    for group in groups:
        name, *lines = group.strip().splitlines()
        yield name.removesuffix("]"), lines


def _chance() -> Iterator[tuple[str, list[str]]]:
    for seed in SEEDS:
        yield (
            f"random numbers of seed {seed}",
            [
                f"randomSeed({seed})",
                *("random(1)", "random(1)", "random(100)", "random(-5, 5)", "random(0.1, 0.3)"),
                *("randomGaussian()", "random(1e6)", "randomGaussian()", "randomGaussian()"),
                *("random(255)", "random(-10)", "random(10, 10)", "random(10, 5)", "random(0)"),
                *("random(3e38)", "random(1e-30)", "random(-1, 0)", "random(0, TWO_PI)"),
                *("random(16777216)", "int(random(6))", "choice(6)", "choice(-5, 5)"),
                f"randomSeed({seed}); randomGaussian()",
                f"randomSeed({seed}); randomGaussian()",  # the spare one of the pair is forgotten
            ],
        )
    for seed in SEEDS[:4]:
        yield (
            f"random vectors of seed {seed}",
            [f"randomSeed({seed})", *["PVector.random2D()", "PVector.random3D()"] * 4],
        )
    rolls = [f"int(random({n}, {n + 7}))" for n in range(-20, 20)]
    yield "whole random numbers", ["randomSeed(9)", *rolls]


def _noise() -> Iterator[tuple[str, list[str]]]:
    for seed in SEEDS[:8]:
        yield (
            f"noise of seed {seed}",
            [
                f"noiseSeed({seed})",
                *(f"noise({x})" for x in PLACES),
                *(f"noise({x}, {y})" for x, y in zip(PLACES, reversed(PLACES), strict=True)),
                *(f"noise({x}, {y}, {x})" for x, y in zip(PLACES, PLACES[3:], strict=False)),
                *(f"noise({x})" for x in FAR_PLACES),
                *(f"noise({x}, {y}, 0.3)" for x, y in zip(FAR_PLACES, PLACES, strict=False)),
            ],
        )
    for lod, falloff in (("1", ""), ("8", ""), ("3", "0.3"), ("6", "0.65"), ("4", "0.9")):
        yield (
            f"noise in detail {lod} {falloff}".strip(),
            [
                "noiseSeed(5)",
                f"noiseDetail({lod}{', ' if falloff else ''}{falloff})",
                *(f"noise({x}, 2.2)" for x in PLACES),
                *(f"noise({x}, 2.2, 3.7)" for x in FAR_PLACES),
                "noiseDetail(0); noise(1.5)",
                "noiseDetail(2, 0); noise(1.5)",
                "noiseDetail(4, 0.5)",
            ],
        )
