import pytest

from sketchkit.grading.assignment.errors import AssignmentError
from sketchkit.grading.checks.kinds import KINDS
from sketchkit.grading.evidence import Evidence, SourceFacts
from tests.grading.checks.cases import check_of, judged, written

FACTS = SourceFacts(
    calls={"rotateY": 2, "pg.rect": 1, "rect": 1, "background": 1},
    functions=("Ball.update", "draw", "setup"),
    classes=("Ball",),
    names=("angle", "mouseX"),
    statements={"for": 1, "import math": 1},
)


@pytest.mark.parametrize(
    ("text", "score"),
    [
        ('calls = "rotateY"', 1),
        ('calls = ["rotateY()", "rotateX"]', 0.5),
        ('calls = [["square", "rect"]]', 1),
        ('calls = [["square", "box"]]', 0),
        ('calls = ["rotate*"]', 1),
        ('calls = ["pg.rect"]', 1),
        ('defines = ["draw", "def setup", "class Ball", "Ball.update"]', 1),
        ('defines = ["update"]', 0),
        ('defines = ["*.update"]', 1),
        ('defines = ["Ball"]', 0),
        ('uses = ["for", "import math", "mouseX", "while"]', 0.75),
        ('calls = ["rotateY"]\nforbids = ["import math"]', 0),
        ('calls = ["rotateY"]\nforbids = ["import math", "exec"]', 0.5),
        ('calls = ["rotateY"]\nforbids = ["exec"]', 1),
        ('calls = ["rotateY", "sphere"]\ncurve = [[0.5, 0], [1, 1]]', 0),
    ],
)
def test_share_of_what_is_found(text: str, score: float) -> None:
    assert judged(check_of("source", text), written(FACTS)).score == score


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ('calls = ["sphere"]', "sphere() is not called in your code."),
        (
            'calls = ["rotatey"]',
            "rotatey() is not called in your code. There is rotateY(): is that what you mean?",
        ),
        (
            'calls = [["square", "box"]]',
            "None of these is called in your code: square() or box().",
        ),
        ('defines = ["mousePressed"]', "mousePressed() is not defined in your code."),
        ('defines = ["class Box"]', "class Box is not defined in your code."),
        ('uses = ["while"]', "while is not used in your code."),
        ('uses = ["for"]\nforbids = ["pg.*"]', "pg.rect is used, which is not allowed here."),
    ],
)
def test_reason_names_what_is_wrong(text: str, reason: str) -> None:
    assert judged(check_of("source", text), written(FACTS)).reasons[0].startswith(reason)


def test_empty_sketch_earns_nothing() -> None:
    check = check_of("source", 'uses = ["for"]\nforbids = ["exec"]')

    assert judged(check, Evidence()).score == 0


def test_nothing_has_to_be_run() -> None:
    check = check_of("source", 'uses = ["for"]')

    assert KINDS["source"].needs(check, check.options) == ()


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "needs calls, defines or uses"),
        ('forbids = ["exec"]', "An empty sketch would fulfil forbids alone"),
        ("calls = [3]", "calls is a list of names"),
        ("calls = [[]]", "calls is a list of names"),
        ('calls = [""]', "calls is a list of names"),
        ("uses = {a = 1}", "uses is a list of names"),
        ('uses = ["for"]\nforbids = [["a", "b"]]', "forbids is a text or a list of texts"),
        ('frames = "1"\ncalls = ["a"]', "frames is no key of a source check"),
    ],
)
def test_what_cannot_be_looked_for_is_refused(text: str, words: str) -> None:
    with pytest.raises(AssignmentError, match=words):
        check_of("source", text)
