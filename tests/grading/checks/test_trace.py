import pytest

from sketchkit.grading.assignment.errors import AssignmentError
from sketchkit.grading.checks.case import Basis
from sketchkit.grading.checks.kinds import KINDS
from sketchkit.grading.evidence import Evidence, RunEvidence, Trace
from sketchkit.grading.results import Status
from tests.grading.checks.cases import check_of, judged, traced

BOXES = Trace(
    {"box": 2, "rect": 1},
    nesting=2,
    lights=1,
    retained=3,
    textures=4,
    canvases=5,
    shaders={"wave.frag": ("time", "speed")},
    draw_calls=6,
    vertices=72,
)


@pytest.mark.parametrize(
    ("text", "score"),
    [
        ("kinds = {box = 2}", 1),
        ("kinds = {box = 1}", 0),
        ('kinds = {box = ">= 2", sphere = 1}', 0.5),
        ("nesting = 2", 1),
        ('nesting = ">= 3"', 0),
        ("lights = 1\nretained = 3\ntextures = 4\ncanvases = 4", 0.75),
        ('vertices = "50..80"\ndraw_calls = "< 7"', 1),
        ("kinds = {box = 2, rect = 0}", 0),
        ("kinds = {box = 2, rect = 0, line = 0}", 0.5),
        ("kinds = {sphere = 0}", 1),
        ('shader = {uniform = "time"}', 1),
        ('shader = {uniform = ["time", "speed"], name = "wave.frag"}', 1),
        ('shader = {uniform = "colour"}', 0),
        ('shader = {name = "wood.frag"}', 0),
        ('lights = 2\nshader = {uniform = "time"}', 0.5),
        ('lights = 2\nnesting = 2\ncurve = "all or nothing"', 0),
    ],
)
def test_share_of_what_is_fulfilled(text: str, score: float) -> None:
    assert judged(check_of("trace", text), traced(f1=BOXES)).score == score


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("kinds = {box = 1}", "Drawn with box() in frame 1: 2. Expected: exactly 1."),
        (
            "kinds = {ellipse = '>= 3'}",
            "Drawn with ellipse() or circle() in frame 1: 0. Expected: at least 3.",
        ),
        ("lights = '2..3'", "Lights that shine in frame 1: 1. Expected: 2 to 3."),
        ("kinds = {rect = 0}", "Drawn with rect() or square() in frame 1: 1. Expected: none."),
        (
            "shader = {uniform = 'size'}",
            'The shader in frame 1 is not given size: call set("size", ...) of it.',
        ),
        (
            "shader = {name = 'wood.frag'}",
            "Nothing is drawn with wood.frag in frame 1: call shader() before drawing.",
        ),
    ],
)
def test_reason_says_what_is_expected_and_what_was_found(text: str, reason: str) -> None:
    assert judged(check_of("trace", text), traced(f1=BOXES)).reasons[0] == reason


def test_missing_shader_is_told() -> None:
    result = judged(check_of("trace", "shader = {uniform = 'size'}"), traced(f1=Trace({"box": 1})))

    assert result.reasons[0].startswith("Nothing is drawn with a shader of your own in frame 1")


def test_frame_that_draws_nothing_earns_nothing() -> None:
    check = check_of("trace", "kinds = {rect = 0}\nlights = '<= 3'")

    assert judged(check, traced(f1=Trace())).score == 0


def test_as_in_the_reference() -> None:
    check = check_of("trace", 'lights = "as in the reference"')
    two = traced(f1=Trace({"box": 1}, lights=2))

    alike, other = judged(check, two, two), judged(check, traced(f1=BOXES), two)

    assert (alike.score, other.score) == (1, 0)
    assert other.reasons[0] == "Lights that shine in frame 1: 1. Expected: exactly 2."


def test_frames_count_alike_and_repetitions_are_told_once() -> None:
    check = check_of("trace", "kinds = {box = 2}", frames=(1, 2, 3, 4))

    result = judged(check, traced(f1=BOXES, f2=Trace(), f3=Trace(), f4=BOXES))

    assert result.score == 0.5
    assert result.reasons[0] == (
        "Drawn with box() in frame 2: 0. Expected: exactly 2. So it is in 1 more frame."
    )


def test_frame_that_was_not_reached_earns_nothing() -> None:
    run = RunEvidence(Status.OVER_LIMIT, "It took more than 20 s.", traces={1: BOXES})

    result = judged(check_of("trace", "kinds = {box = 2}", frames=(1, 9)), Evidence({"": run}))

    assert result.score == 0.5
    assert result.reasons[0] == "It stopped before frame 9: It took more than 20 s."


def test_run_with_events_is_looked_at() -> None:
    check = check_of("trace", "kinds = {box = 2}", events="events.json")
    run = RunEvidence(Status.GRADED, traces={1: BOXES})

    assert judged(check, Evidence({"events.json": run})).score == 1
    assert KINDS["trace"].needs(check, check.options)[0].events == "events.json"


@pytest.mark.parametrize(
    ("text", "basis"),
    [("lights = 1", Basis.NOTHING), ('lights = "as in the reference"', Basis.SKETCH)],
)
def test_reference_is_needed_where_it_is_named(text: str, basis: Basis) -> None:
    assert KINDS["trace"].basis(check_of("trace", text).options) is basis


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "expects something"),
        ("kinds = {boxes = 1}", r"boxes is no kind of shape.\n    Do you mean box\?"),
        ("kinds = {circle = 1}", r"Do you mean ellipse\?"),
        ("kinds = {wibble = 1}", "Kinds are rect, ellipse"),
        ("kinds = 3", "kinds is a table, not 3"),
        ("lights = 'two'", "lights is a number of things, not 'two'"),
        ("shader = {uniforms = 'a'}", r"uniforms is no key of shader.\n    Do you mean uniform\?"),
        ("shader = {uniform = 3}", "uniform is a text or a list of texts"),
    ],
)
def test_expectation_that_cannot_be_read_is_refused(text: str, words: str) -> None:
    with pytest.raises(AssignmentError, match=words):
        check_of("trace", text)
