"""What is expected here was told by Processing's own XML."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from sketchkit.api.data.xml.xml import XML
from sketchkit.core.errors import SketchError
from tests.api.sketches import new_sketch

ZOO = """<zoo city="Bonn" n="3">
  <animal id="0">Goat</animal>
  <animal id="1" weight="4.5">Leopard</animal>
  <cage><animal id="2">Zebra</animal><![CDATA[<raw>]]></cage>
</zoo>"""


@pytest.fixture
def zoo() -> XML:
    return XML.parse(ZOO)


def test_attributes_are_read(zoo: XML) -> None:
    assert (zoo.getString("city"), zoo.getInt("n"), zoo.getFloat("n")) == ("Bonn", 3, 3.0)
    assert (zoo.getString("no"), zoo.getInt("no"), zoo.getInt("no", 4)) == (None, 0, 4)
    assert (zoo.listAttributes(), zoo.hasAttribute("n")) == (["city", "n"], True)


def test_children_are_found(zoo: XML) -> None:
    assert [a.getContent() for a in zoo.getChildren("animal")] == ["Goat", "Leopard"]
    assert [a.getContent() for a in zoo.getChildren("cage/animal")] == ["Zebra"]
    assert zoo.getChild("cage/animal").getInt("id") == 2
    assert (zoo.getChild("nope"), zoo.getChild("cage/nope"), zoo.getChildren("nope")) == (
        *(None, None),
        [],
    )
    assert (zoo.getChild(0).getName(), zoo.getChild(1).getName()) == ("#text", "animal")
    assert zoo.getChild("1/0").getName() == "#text"
    assert zoo.getChild("animal").getParent() is zoo
    assert zoo.getChild("cage").getContent() == "Zebra<raw>"
    assert zoo.getChild("animal").getIntContent(5) == 5


def test_element_tells_what_it_has() -> None:
    element = XML.parse('<a n="1" m="2"><b>2.5</b><c/></a>')
    number, empty = element.getChildren()

    assert element.getAttributeCount() == 2
    assert (element.hasChildren(), empty.hasChildren(), number.hasChildren()) == (True, False, True)
    assert (number.getFloatContent(), empty.getFloatContent(7)) == (2.5, 7)
    assert (number.getIntContent(8), empty.getIntContent()) == (2, 0)


def test_attribute_that_is_set_twice_is_there_once() -> None:
    element = XML.parse('<a n="1" m="2"><b>2.5</b><c/></a>')

    element.setLong("n", 12345678901)

    assert element.toString() == '<a m="2" n="12345678901"><b>2.5</b><c/></a>'


def test_document_is_built_as_in_processing() -> None:
    root = XML("root")
    kid = root.addChild("kid")
    kid.setInt("a", 1)
    kid.setFloat("f", 0.5)
    kid.setContent("x < y & z")
    assert root.format(2) == (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        '<root>\n  <kid a="1" f="0.5">x &lt; y &amp; z</kid>\n</root>\n'
    )

    root.addChild(kid).setFloatContent(3)
    root.removeChild(kid)
    root.setName("ROOT")
    assert str(root) == '<ROOT><kid a="1" f="0.5">3.0</kid></ROOT>'


def test_blank_texts_are_removed(zoo: XML) -> None:
    zoo.trim()

    assert zoo.listChildren() == ["animal", "animal", "cage"]
    assert len(zoo) == 3


def test_children_are_taken_as_the_items_of_a_list(zoo: XML) -> None:
    zoo.trim()

    assert (zoo[1].getContent(), zoo[-1].getName()) == ("Leopard", "cage")
    assert [child.getInt("id") for child in zoo[:2]] == [0, 1]


def test_element_without_children_is_true() -> None:
    assert XML("a")


def test_file_is_saved_and_loaded(tmp_path: Path, zoo: XML) -> None:
    sketch = new_sketch(folder=tmp_path)
    sketch.take_over()

    assert sketch.saveXML(zoo, "out/zoo.xml")

    assert sketch.loadXML("out/zoo.xml").getChild("cage/animal").getContent() == "Zebra"


@pytest.mark.parametrize(
    ("call", "problem"),
    [
        (lambda x: x.getInt("city"), "The attribute city of <zoo> is no whole number"),
        (lambda x: x.getChild("/cage"), "path of names"),
        (lambda x: x.getChild(99), "from 0 to 6"),
        (lambda x: x[99], "from 0 to 6"),
        (lambda x: x["city"], r"getString\('city'\) an attribute"),
        (lambda x: x.removeChild(XML("z")), "takes a child of <zoo>"),
        (lambda x: x.setString("n", 4), r"str\(4\)"),
        (lambda x: x.addChild("<b>"), r"parseXML\(\)"),
        (lambda x: x.getChild(0).setInt("a", 1), "Only elements"),
        (lambda x: XML.parse("<a>\n<b></a>"), "The text, line 2, column 6: <b> is not closed"),
    ],
)
def test_mistakes_are_told(zoo: XML, call, problem: str) -> None:
    with pytest.raises(SketchError) as caught:
        call(zoo)

    assert re.search(problem, str(caught.value))
