import pytest

from sketchkit.assets.svg.css import read_declarations, read_rules
from sketchkit.assets.svg.elements import Element


def chosen(sheet, tag, **attributes):
    """Return the values of the rules that fit an element, the strongest last."""
    root = Element("svg", {}, 1, children=[Element("style", {}, 1, sheet)])
    element = Element(tag, attributes, 1)
    return [
        value for rule in read_rules(root) if rule.fits(element) for _, value in rule.declarations
    ]


@pytest.mark.parametrize(
    ("selector", "fits"),
    [
        ("*", True),
        ("path", True),
        ("rect", False),
        ("#me", True),
        ("#you", False),
        (".a", True),
        (".a.b", True),
        (".a.c", False),
        ("path#me.a", True),
        ("rect.a", False),
        ("g > path", False),
        ("path:hover", False),
    ],
)
def test_a_selector_names_an_element_an_id_and_classes(selector, fits):
    found = chosen(f"{selector}{{fill:red}}", "path", **{"id": "me", "class": "b a"})

    assert found == ["red"] * fits


def test_the_more_precise_rule_is_the_stronger_one_and_then_the_later_one():
    sheet = "#me{fill:1} .a{fill:2} path{fill:3} .a.b{fill:4} .b{fill:5} *{fill:6}"
    found = chosen(sheet, "path", **{"id": "me", "class": "a b"})

    assert found == ["6", "3", "2", "5", "4", "1"]


def test_rules_may_share_declarations_and_have_comments():
    sheet = "/* ours {} */ .x, .y { fill :red; /* ! */ ; stroke: }"

    assert chosen(sheet, "g", **{"class": "y"}) == ["red"]


@pytest.mark.parametrize("sheet", ["", "}", "{", ".a", ".a{fill", "a{b:c}}d", "@import 'x';"])
def test_half_a_sheet_does_no_harm(sheet):
    assert chosen(sheet, "path", **{"class": "a"}) == []


def test_declarations_keep_their_order_and_the_blank_before_a_value():
    assert read_declarations("fill:red; stroke : none;;x:") == [
        ("fill", "red"),
        ("stroke", " none"),
    ]
