import pytest

from sketchkit.data.malformed import MalformedError
from sketchkit.data.xml_reading import read_xml
from sketchkit.data.xml_tree import Node
from sketchkit.data.xml_writing import COMPACT, write_xml

ZOO = """<?xml version="1.0" encoding="UTF-8"?>
<zoo n="3" city="Bonn">
  <animal id="0">Goat</animal>
  <animal id="1">Leopard &amp; <b>big</b> cat</animal>
  <!-- c -->
  <cage><animal id="2">Zebra</animal><![CDATA[<raw>]]></cage>
  <?pi data?>
  <empty/>
</zoo>"""

# what Processing's format(2) makes of it
INDENTED = """<?xml version="1.0" encoding="UTF-8"?>
<zoo city="Bonn" n="3">
  <animal id="0">Goat</animal>
  <animal id="1">
    Leopard &amp;
    <b>big</b>
    cat
  </animal>
  <!-- c -->
  <cage>
    <animal id="2">Zebra</animal><![CDATA[<raw>]]></cage>
  <?pi data?>
  <empty/>
</zoo>
"""

BILLION_LAUGHS = """<!DOCTYPE a [
<!ENTITY b "ha"><!ENTITY c "&b;&b;&b;"><!ENTITY d "&c;&c;&c;">
]><a>&d;</a>"""


def test_children_are_named_as_in_processing() -> None:
    names = [child.name for child in read_xml(ZOO, Node).children]

    text = "#text"
    assert names == [
        *(text, "animal", text, "animal", text, "#comment", text),
        *("cage", text, "pi", text, "empty", text),
    ]


def test_layout_is_that_of_processing() -> None:
    assert write_xml(read_xml(ZOO, Node), 2) == INDENTED


def test_marks_of_attributes_and_texts_are_escaped() -> None:
    node = Node("kid")
    node.attributes["s"] = "<&>\"'\n"

    assert write_xml(node, COMPACT) == '<kid s="&lt;&amp;&gt;&quot;\'&#10;"/>'


def test_texts_survive_being_written_and_read() -> None:
    root = read_xml("<a><b> x &lt; y </b><c>1\n2</c></a>", Node)

    again = read_xml(write_xml(root, 2).encode(), Node)

    assert [n.content() for n in again.children if n.name in "bc"] == [" x < y ", "1\n2"]


def test_encoding_is_the_one_that_the_document_names() -> None:
    data = '<?xml version="1.0" encoding="ISO-8859-1"?><a>\u00f6</a>'.encode("latin-1")

    assert read_xml(data, Node).content() == "\u00f6"


def test_namespaces_stay_with_an_element_written_alone() -> None:
    root = read_xml("<a xmlns:x='u'><x:b x:c='1'/></a>", Node)

    assert write_xml(root.children[0], COMPACT) == '<x:b xmlns:x="u" x:c="1"/>'


@pytest.mark.parametrize(
    ("text", "line", "problem"),
    [
        ("<a>\n<b></a>", 2, "<b> is not closed"),
        ("", 1, "no element in it"),
        ("<a>\n1 & 2</a>", 2, "&amp;"),
        ("<a/>\n<b/>", 2, "behind the end of the first element"),
        ("<a x='1' x='2'/>", 1, "twice"),
        ("<a>&nbsp;</a>", 1, "not defined"),
        (BILLION_LAUGHS, 2, "made of others"),
        ("<a>" * 300, 1, "within each other"),
        ("<?xml version='1.0' encoding='klingon'?><a/>", 1, "encoding"),
    ],
)
def test_mistake_is_told_with_its_line(text: str, line: int, problem: str) -> None:
    with pytest.raises(MalformedError, match=problem) as caught:
        read_xml(text.encode(), Node)

    assert caught.value.line == line


def test_nothing_is_fetched_from_files() -> None:
    text = '<!DOCTYPE a [<!ENTITY b SYSTEM "file:///etc/hostname">]><a>x&b;</a>'

    assert read_xml(text, Node).content() == "x"
