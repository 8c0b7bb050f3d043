"""Drivers' complaints in plain sentences: patterns of all drivers, and what to write instead."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

from sketchkit.core.errors import nearest
from sketchkit.glsl.declarations import Declarations
from sketchkit.glsl.vocabulary import FEEDS, FUNCTIONS, TYPES, USAGES, VARIABLES


class Finding(NamedTuple):
    """What is wrong, and what to write instead; `line` is 0 where the complaint's own is right."""

    sentence: str
    hint: str = ""
    line: int = 0


@dataclass(frozen=True)
class Place:
    """Where a complaint points.

    Attributes
    ----------
    stage : str
    text : str
        The line of the source.
    declared : Declarations
        Of the source.
    names : frozenset of str
        All that occur in the source.
    """

    stage: str
    text: str
    declared: Declarations
    names: frozenset[str]


def finding_for(message: str, place: Place) -> Finding:
    """Return a complaint in plain words; of one that nobody has foreseen the driver's."""
    for pattern, make in _RULES:
        if found := pattern.search(message):
            return make(found, place)
    return Finding(f"The GLSL compiler says: {message.rstrip('.')}.")


def _undeclared(found: re.Match[str], place: Place) -> Finding:
    name = _first(found)
    if re.search(rf"\b{re.escape(name)}\s*\(", place.text):
        return _unknown_function(found, place)
    if name in FEEDS:
        return Finding(f"{name} is not declared.", f"Write at the top: {FEEDS[name]} {name};")
    known = nearest(name, (place.names | VARIABLES) - {name})
    hint = f"Do you mean {known}?" if known else f"Declare it before it is used: float {name};"
    return Finding(f"There is no variable {name}.", hint)


def _unknown_function(found: re.Match[str], place: Place) -> Finding:
    name = _first(found)
    known = nearest(name, FUNCTIONS | set(place.declared.functions))
    own = "A function stands above the place that calls it."
    return Finding(f"There is no function {name}().", f"Do you mean {known}()?" if known else own)


def _wrong_arguments(found: re.Match[str], place: Place) -> Finding:
    name = _first(found)
    if name not in FUNCTIONS and name not in place.declared.functions and name not in TYPES:
        return _unknown_function(found, place)
    # The line may have the name of old, where the compiler saw the one of today.
    if name.startswith("texture") and (old := re.search(rf"\b{name}\w+(?=\s*\()", place.text)):
        name = old[0]
    given = found.groupdict().get("given")
    got = f" ({given})" if given else " these arguments"
    return Finding(f"{name}() does not take{got}.", _usage(name, given or ""))


def _usage(name: str, given: str) -> str:
    if name.startswith("texture") and "sampler2D" in given and re.search(r"vec[34]", given):
        return f"The place has two numbers: {name}(image, uv.xy)."
    return USAGES.get(name, "")


def _wrong_assignment(found: re.Match[str], place: Place) -> Finding:
    given, wanted = _type(found["given"]), _type(found["wanted"])
    if given == wanted:
        return Finding("The two sides of = are not of the same type.")
    article = "an" if wanted[0] in "iu" else "a"
    sentence = f"This is a {given}: it cannot be put into {article} {wanted}."
    return Finding(sentence.replace("a int:", "an int:"), _conversion(given, wanted))


def _conversion(given: str, wanted: str) -> str:
    sizes = {"float": 1, "int": 1, "vec2": 2, "vec3": 3, "vec4": 4}
    have, need = sizes.get(given, 0), sizes.get(wanted, 0)
    if wanted == "int" and given == "float":
        return "int(value) cuts the fraction off."
    if wanted == "bool":
        return "Compare it with something: value > 0.0."
    if have == 1 and need > 1:
        return f"{wanted}(value) has it {need} times."
    if have and need > have:
        missing = ", ".join(["0.0", "1.0"][have - need :])
        return f"Write {wanted}(value, {missing})."
    if have > need > 0:
        return f"Take a part of it: value.{'xyz'[:need]}."
    return ""


def _type(words: str) -> str:
    """Return the name of a type: ANGLE and AMD write `const 3-component vector of float`."""
    size = re.search(r"(\d)-component vector of (\w+)", words)
    if size:
        letter = {"float": "", "bool": "b", "uint": "u"}.get(size[2], "i")
        return f"{letter}vec{size[1]}"
    side = re.search(r"(\d)X\d matrix", words, re.IGNORECASE)
    return f"mat{side[1]}" if side else words.split()[-1].strip("'\"")


def _read_only(found: re.Match[str], place: Place) -> Finding:
    names = re.findall(r"\w+", found[1] or "") or re.findall(
        r"(\w+)[\w.\[\]]*\s*[-+*/]?=", place.text
    )
    by_name = {variable.name: variable.storage for variable in place.declared.variables}
    name = next((name for name in names if name in by_name), names[0] if names else "It")
    storage = by_name.get(name, "")
    if storage == "uniform":
        return Finding(
            f"{name} is a uniform: only the sketch gives it a value.",
            f"Copy it into a variable of your own first: value = {name};",
        )
    if storage in ("varying", "in") and place.stage == "fragment":
        return Finding(
            f"{name} comes from the vertex shader: here it can only be read.",
            f"Copy it into a variable of your own first: value = {name};",
        )
    if storage in ("attribute", "in"):
        return Finding(f"{name} is an attribute: it can only be read.")
    return Finding(f"{name} cannot be assigned to.")


def _redeclared(found: re.Match[str], place: Place) -> Finding:
    return Finding(f"{_first(found)} is declared twice.", "The second time, leave the type out.")


def _constructor(few: bool) -> Callable[[re.Match[str], Place], Finding]:
    word = "few" if few else "many"

    def make(found: re.Match[str], place: Place) -> Finding:
        name = found.groupdict().get("type")
        name = name or next(iter(re.findall(r"\b[biu]?(?:vec|mat)[234](?=\s*\()", place.text)), "")
        count = re.sub(r"\D", "", name)
        hint = f"A {name} takes {count} numbers in all." if "vec" in name else ""
        return Finding(f"There are too {word} numbers in {name or 'this'}(...).", hint)

    return make


def _swizzle(found: re.Match[str], place: Place) -> Finding:
    letters = found.groupdict().get("mask")
    what = f".{letters}" if letters else "This"
    return Finding(
        f"{what} does not fit what stands before it.",
        "A vec2 has .x and .y, a vec3 .z too, a vec4 .w too; xyzw and rgba do not mix.",
    )


def _differing(found: re.Match[str], place: Place) -> Finding:
    there = next((v for v in place.declared.variables if v.name == _first(found)), None)
    own = f" Here it is a {there.type}." if there else ""
    return Finding(
        f"{_first(found)} is declared differently in the vertex and in the fragment shader.",
        f"Type and name have to be the same in both.{own}",
    )


def _unfed(found: re.Match[str], place: Place) -> Finding:
    name = _first(found)
    return Finding(
        f"{name} is read in the fragment shader, but the vertex shader does not write it.",
        "Declare it in both, with the same name; the vertex shader's main() gives it a value.",
    )


def _no_main(found: re.Match[str], place: Place) -> Finding:
    near = nearest("main", place.declared.functions)
    line = place.declared.functions.get(near or "", 0)
    hint = f"Do you mean main where you wrote {near}?" if near else "Write void main() { ... }."
    return Finding("The shader has no main().", hint, line)


def _said(sentence: str, hint: str = "") -> Callable[[re.Match[str], Place], Finding]:
    """Return a maker of the same words each time; `{}` stands for the name that was found."""

    def make(found: re.Match[str], place: Place) -> Finding:
        name = _first(found) if found.groups() else ""
        return Finding(sentence.replace("{}", name), hint.replace("{}", name))

    return make


def _first(found: re.Match[str]) -> str:
    return next((group for group in found.groups() if group), "")


_QUOTED = r"[`'\"](\w+)[`'\"]"
_PATTERNS: list[tuple[str, Callable[[re.Match[str], Place], Finding]]] = [
    (r"no function with name '(\w+)'|call of undeclared identifier '(\w+)'", _unknown_function),
    (
        rf"{_QUOTED}(?: : | )undeclared|undefined variable {_QUOTED}"
        rf"|undeclared identifier:? ?[`'\"]?(\w+)",
        _undeclared,
    ),
    (
        r"(?:no matching function for call to|compatible overloaded function) "
        r"[`'\"]?(\w+)\((?P<given>[^)]*)\)|[`'\"](\w+)[`'\"] : no matching overloaded function",
        _wrong_arguments,
    ),
    (
        r"(?:initializer|value) of type (?P<given>\w+) cannot be assigned to variable of type "
        r"(?P<wanted>\w+)",
        _wrong_assignment,
    ),
    (r"cannot convert from '?(?P<given>[^']+?)'? to '?(?P<wanted>[^']+?)'?$", _wrong_assignment),
    (r"incompatible types \((?P<wanted>\w+) and (?P<given>\w+)\) in", _wrong_assignment),
    (r'implicit cast from "(?P<given>\w+)" to "(?P<wanted>\w+)"', _wrong_assignment),
    (
        r"incompatible types|cannot convert",
        _said(
            "The types on the two sides do not fit.",
            "A float, a vec2, a vec3 and a vec4 go only where the same is wanted.",
        ),
    ),
    (
        r"too few components to construct [`'](?P<type>\w+)"
        r"|not enough data|too little data|too few (?:arguments|components)"
        r"|not enough (?:arg|param)",
        _constructor(few=True),
    ),
    (
        r"too many parameters to [`'](?P<type>\w+)"
        r"|too much data|too many (?:arguments|components|param)",
        _constructor(few=False),
    ),
    (
        r"invalid swizzle / mask [`'](?P<mask>\w+)|swizzle|vector field selection"
        r"|illegal field selection|field selection out of range",
        _swizzle,
    ),
    (
        r"cannot access field [`'](\w+)|no such field in structure|member \"(\w+)\"",
        _said("The struct has no member {}."),
    ),
    (
        r"read-only variable '(\w+)'|l-?value(?: required)?\W*(.*)|can't modify(.*)"
        r"|cannot assign to(.*)|assignment to (?:varying|uniform|const)(.*)",
        _read_only,
    ),
    (
        r"size mismatch|type mismatch|wrong operand types|invalid operands|incompatible type"
        r"|cannot be applied|operands? (?:of|to) (?!relational)"
        r"|could not implicitly convert operands",
        _said(
            "The two sides of the operator are of types that do not go together.",
            "A vector goes with a vector of the same size, or with a float.",
        ),
    ),
    (
        r"must be (?:a )?(?:scalar )?bool|boolean expression|conditional expression|not a bool"
        r"|operands to relational|condition",
        _said("A condition has to be true or false.", "Compare numbers one by one: color.r > 0.5."),
    ),
    (r"no return statement", _said("The function ends without return.")),
    (
        r"convert return value to (\w+)|`return' with wrong type|return type|function return",
        _said("What the function returns is not of the type that stands before its name."),
    ),
    (rf"{_QUOTED} redeclared|{_QUOTED} : redefinition|redefinition of {_QUOTED}", _redeclared),
    (rf"{_QUOTED} is already (?:declared|defined)", _redeclared),
    (
        r"array index|index expression|out of range|out of bounds",
        _said("The array is shorter than that.", "The first element is [0]."),
    ),
    (
        r"operator %|% .*integer|'%'",
        _said("% is for whole numbers.", "For floats write mod(a, b)."),
    ),
    (
        r"version .*not supported|is not supported|unsupported version",
        _said("This computer's OpenGL does not know that #version.", "Write #version 330."),
    ),
    (
        r"lacks [`']main|missing main|entry point|main.* not (?:defined|implemented)|no main"
        r"|does not (?:have|contain|define) .*main|undefined .*\bmain\b",
        _no_main,
    ),
    (
        r"output [`'](\w+)' declared as|type mismatch .*between .*\"(\w+)\""
        r"|types? of [`'\"](\w+)['\"].*(?:differ|mismatch)"
        r"|varying [`'\"]?(\w+).*(?:differ|mismatch)"
        r"|uniform [`'\"]?(\w+)['\"]? declared as",
        _differing,
    ),
    (
        r"input [`'\"]?(\w+)['\"]? has no matching|fragment shader [`'](\w+)' not written"
        r"|varying [`'\"]?(\w+)['\"]? not declared"
        r"|(?:input|varying) [`'\"](\w+).*not (?:written|found)"
        r"|reads? varying [`'\"]?(\w+)",
        _unfed,
    ),
    (
        r"unresolved reference to function [`'](\w+)"
        r"|function [`'\"]?(\w+)[`'\"]? (?:is )?not defined",
        _said("{}() is announced, but its body is nowhere."),
    ),
    (r"unterminated #if|#if.*without|missing #endif", _said("There is no #endif for this #if.")),
    (r"unterminated comment|in comment", _said("A comment that begins with /* has no */.")),
    (
        r"non-directive|invalid directive|unknown directive|invalid preproc",
        _said(
            "There is no such line with #.", "Known are #define, #ifdef, #else, #endif, #version."
        ),
    ),
]
_RULES = [(re.compile(pattern, re.IGNORECASE), make) for pattern, make in _PATTERNS]
