import math
from pathlib import Path

import pytest

from sketchkit.libraries.peasycam import CameraState, PeasyCam
from tests.api.sketches import new_sketch
from tests.libraries.peasycam_sketches import moved
from tests.runtime.sketches import begun, mistake, play, written

# At a distance of 99, log10(1 + 99) is 2: a pixel pushes by this many radians.
STEP = math.sqrt(2) * 0.00125
MIDDLE = [100, 50]


def glided(push: float) -> float:
    """Return how far a push goes: all of it, and 84 % in each further frame, down to 0.001."""
    way = 0.0
    while abs(push) >= 0.001:
        way += push
        push *= 0.84
    return way


def drag(to: list[int], **more: object) -> dict[str, object]:
    """Return a drag from the middle within one frame."""
    return {"frame": 1, "drag": [MIDDLE, to], "frames": 1, **more}


def test_camera_stands_before_the_origin(tmp_path: Path) -> None:
    cam = moved(tmp_path, 1)

    assert cam.getPosition() == [0, 0, 99]
    assert cam.getLookAt() == [0, 0, 0]
    assert cam.getUpVector() == [0, 1, 0]


def test_sketch_is_seen_through_it(tmp_path: Path) -> None:
    text = "size(200, 100, P3D)\nPeasyCam(this, 10, 20, 30, 99)\nplace = screenX(10, 20, 30)"

    assert play(written(tmp_path, text))["place"] == pytest.approx(100)


def test_horizontal_drag_turns_about_y_and_glides(tmp_path: Path) -> None:
    cam = moved(tmp_path, 60, drag([110, 50]))

    angle = glided(-10 * STEP)
    assert cam.getPosition() == pytest.approx([99 * math.sin(angle), 0, 99 * math.cos(angle)])


def test_vertical_drag_turns_about_x(tmp_path: Path) -> None:
    cam = moved(tmp_path, 60, drag([100, 60]))

    # At y = 60 the pointer is 1/5 below the middle: that lessens only turns about y.
    angle = glided(10 * STEP)
    assert cam.getPosition() == pytest.approx([0, -99 * math.sin(angle), 99 * math.cos(angle)])


def test_drag_at_the_edge_rolls(tmp_path: Path) -> None:
    cam = moved(tmp_path, 60, {"frame": 1, "drag": [[199, 50], [199, 60]], "frames": 1})

    across = 199 / 200 * 2 - 1
    roll, pitch = glided(-10 * STEP * across), glided(10 * STEP * (1 - across * across))
    assert cam.getRotations()[2] == pytest.approx(roll, abs=1e-4)
    assert abs(pitch) == 0  # too little to move at all


@pytest.mark.parametrize(
    ("mode", "turns"),
    [
        ("setYawRotationMode", (False, True, False)),
        ("setPitchRotationMode", (True, False, False)),
        ("setRollRotationMode", (False, False, True)),
        ("setSuppressRollRotationMode", (True, True, False)),
        ("setFreeRotationMode", (True, True, True)),
    ],
)
def test_mode_allows_some_axes(tmp_path: Path, mode: str, turns: tuple[bool, ...]) -> None:
    way = {"frame": 1, "drag": [[120, 30], [150, 10]], "frames": 1}

    cam = moved(tmp_path, 2, way, setup=f"cam.{mode}()")

    x, y, z = cam.getRotations()
    assert (abs(x) > 1e-6, abs(y) > 1e-6, abs(z) > 1e-6) == turns


def test_shift_keeps_the_direction_of_the_drag(tmp_path: Path) -> None:
    way = {"frame": 1, "drag": [MIDDLE, [120, 53], [121, 80]], "frames": 2, "with": ["SHIFT"]}

    cam = moved(tmp_path, 60, way)

    x, y, z = cam.getRotations()
    assert (abs(x), abs(z)) == (0, 0)
    assert y < -0.1


def test_wheel_goes_farther_by_2_percent_a_notch_and_glides(tmp_path: Path) -> None:
    event = {"frame": 1, "wheel": 1}

    first = moved(tmp_path, 1, {"frame": 1, "move": MIDDLE}, event)
    second = moved(tmp_path, 2, {"frame": 1, "move": MIDDLE}, event)

    assert first.getDistance() == pytest.approx(99 * 1.02)
    assert second.getDistance() == pytest.approx(99 * 1.02 * (1 + 0.84 * 0.02))


def test_right_drag_zooms_by_a_tenth_of_a_notch_for_a_pixel(tmp_path: Path) -> None:
    cam = moved(tmp_path, 2, drag([100, 60], button="right"))

    assert cam.getDistance() == pytest.approx(99 * 1.02)


def test_middle_drag_moves_along_the_picture(tmp_path: Path) -> None:
    cam = moved(tmp_path, 2, drag([108, 42], button="center"))

    # A speed of 8 / 8, times 0.0025 of the distance, against the hand.
    assert cam.getLookAt() == pytest.approx([-99 * 0.0025, 99 * 0.0025, 0])


@pytest.mark.parametrize(
    ("call", "event", "measure"),
    [
        ("cam.setWheelScale(3)", {"frame": 1, "wheel": 1}, lambda cam: cam.getDistance() / 99 - 1),
        (
            "cam.setZoomScale(3)",
            drag([100, 60], button="right"),
            lambda cam: cam.getDistance() / 99 - 1,
        ),
        ("cam.setPanScale(3)", drag([108, 50], button="center"), lambda cam: cam.getLookAt()[0]),
        ("cam.setRotationScale(3)", drag([110, 50]), lambda cam: cam.getRotations()[1]),
    ],
    ids=["wheel", "zoom", "pan", "rotation"],
)
def test_scale_multiplies_the_push(tmp_path: Path, call, event, measure) -> None:
    events = ({"frame": 1, "move": MIDDLE}, event)

    plain = measure(moved(tmp_path, 2 if "drag" in event else 1, *events))
    scaled = measure(moved(tmp_path, 2 if "drag" in event else 1, *events, setup=call))

    assert scaled == pytest.approx(3 * plain)


def test_zoom_stops_at_the_limits(tmp_path: Path) -> None:
    events = ({"frame": 1, "move": MIDDLE}, {"frame": 1, "wheel": 20}, {"frame": 30, "wheel": -40})

    far = moved(tmp_path, 20, *events, setup="cam.setMaximumDistance(120)")
    near = moved(tmp_path, 60, *events, setup="cam.setMinimumDistance(90)")

    assert far.getDistance() == 120
    assert near.getDistance() == 90


def test_limits_hold_at_once(tmp_path: Path) -> None:
    assert moved(tmp_path, 1, setup="cam.setMaximumDistance(50)").getDistance() == 50


def test_double_click_travels_back(tmp_path: Path) -> None:
    clicks = [{"frame": frame, "click": "left", "at": MIDDLE} for frame in (2, 4)]

    cam = moved(tmp_path, 60, *clicks, setup="cam.rotateX(1); cam.pan(5, 5)")
    kept = moved(tmp_path, 60, *clicks, setup="cam.rotateX(1); cam.setResetOnDoubleClick(False)")

    assert cam.getPosition() == pytest.approx([0, 0, 99])
    assert kept.getRotations()[0] == pytest.approx(1)


def test_one_click_does_nothing(tmp_path: Path) -> None:
    cam = moved(tmp_path, 60, {"frame": 2, "click": "left", "at": MIDDLE}, setup="cam.rotateX(1)")

    assert cam.getRotations()[0] == pytest.approx(1)


def test_travel_takes_its_time_by_the_sketchs_clock(tmp_path: Path) -> None:
    # Frame 31 is at 500 ms: half of the time, half of the way. After 300 ms it would have ended.
    half = moved(tmp_path, 31, setup="cam.setDistance(199, 1000)")
    quarter = moved(tmp_path, 16, setup="cam.setDistance(199, 1000)")
    end = moved(tmp_path, 62, setup="cam.setDistance(199, 1000)")

    assert half.getDistance() == pytest.approx(149)
    assert quarter.getDistance() == pytest.approx(99 + 100 * 0.25**2 * 2.5)
    assert end.getDistance() == 199


def test_state_is_travelled_to(tmp_path: Path) -> None:
    setup = "s = cam.getState(); cam.rotateY(1); cam.pan(8, 0); cam.setState(s, 1000)"

    half = moved(tmp_path, 31, setup=setup)
    end = moved(tmp_path, 62, setup=setup)

    assert half.getRotations() == pytest.approx([0, 0.5, 0])
    assert half.getLookAt() == pytest.approx([4 * math.cos(1), 0, -4 * math.sin(1)])
    assert end.getPosition() == [0, 0, 99]


def test_state_without_time_is_taken_at_once(tmp_path: Path) -> None:
    cam = moved(tmp_path, 0, setup="s = cam.getState(); cam.rotateY(1); cam.setState(s, 0)")

    assert cam.getPosition() == [0, 0, 99]


def test_lookAt_takes_whole_numbers_for_milliseconds(tmp_path: Path) -> None:
    time = moved(tmp_path, 31, setup="cam.lookAt(10, 0, 0, 1000)")
    distance = moved(tmp_path, 30, setup="cam.lookAt(10, 0, 0, 1000.0)")
    both = moved(tmp_path, 31, setup="cam.lookAt(10, 0, 0, 199, 1000)")

    assert time.getPosition() == pytest.approx([5, 0, 99])
    assert distance.getPosition() == pytest.approx([10, 0, 1000])
    assert both.getPosition() == pytest.approx([5, 0, 149])


def test_setRotations_ends_a_travel(tmp_path: Path) -> None:
    setup = "cam.rotateY(1); cam.reset(1000); cam.setRotations(0.1, 0.2, 0.3)"

    assert moved(tmp_path, 90, setup=setup).getRotations() == pytest.approx([0.1, 0.2, 0.3])


def test_viewport_limits_where_it_listens(tmp_path: Path) -> None:
    cam = moved(tmp_path, 5, drag([110, 50]), setup="cam.setViewport(0, 0, 100, 100)")

    assert cam.getPosition() == [0, 0, 99]
    assert cam.getViewport() == [0, 0, 100, 100]
    assert not cam.insideViewport(0, 50)


def test_inactive_camera_does_not_listen(tmp_path: Path) -> None:
    cam = moved(tmp_path, 5, drag([110, 50]), setup="cam.setActive(False)")
    again = moved(tmp_path, 5, drag([110, 50]), setup="cam.setActive(False); cam.setActive(True)")

    assert (cam.isActive(), cam.getPosition()) == (False, [0, 0, 99])
    assert again.getPosition() != [0, 0, 99]


@pytest.mark.parametrize(
    "handler",
    [
        "lambda dx, dy: cam.pan(dx, dy)",
        "type('H', (), {'handleDrag': lambda _, x, y: cam.pan(x, y)})()",
    ],
    ids=["function", "object"],
)
def test_handler_of_the_sketch(tmp_path: Path, handler: str) -> None:
    cam = moved(tmp_path, 3, drag([110, 53]), setup=f"cam.setLeftDragHandler({handler})")

    assert cam.getLookAt() == [10, 3, 0]


def test_handlers_can_be_exchanged_or_taken_away(tmp_path: Path) -> None:
    setup = "cam.setLeftDragHandler(cam.getPanDragHandler())"

    panned = moved(tmp_path, 2, drag([108, 50]), setup=setup)
    still = moved(tmp_path, 2, drag([108, 50]), setup="cam.setLeftDragHandler(None)")

    assert panned.getLookAt()[0] == pytest.approx(-99 * 0.0025)
    assert still.getPosition() == [0, 0, 99]


def test_hud_is_flat_and_ends(tmp_path: Path) -> None:
    text = """
    size(200, 100, P3D)
    cam = PeasyCam(this, 99)
    lights()
    before = screenX(10, 0, 0), screenY(10, 0, 0)
    cam.beginHUD()
    flat = screenX(30, 40, 0), screenY(30, 40, 0)
    cam.endHUD()
    after = screenX(10, 0, 0), screenY(10, 0, 0)
    """
    with begun(written(tmp_path, text)) as loop:
        names = loop.program.namespace
        stage = loop.program.sketch.canvas._stage

    assert names["flat"] == pytest.approx((30, 40))
    assert names["after"] == names["before"]
    assert stage.depth_test
    assert stage.lights is not None


def test_canvas_out_of_sight_has_its_camera_set(tmp_path: Path) -> None:
    text = """
    size(200, 100, P2D)
    pg = createGraphics(80, 60, P3D)
    cam = PeasyCam(this, pg, 99)
    with pg:
        place = pg.screenX(0, 0, 0), pg.screenY(0, 0, 0)
    other = createGraphics(80, 60, P3D)
    cam.getState().apply(other)
    with other:
        same = other.screenX(0, 0, 0), other.screenY(0, 0, 0)
    """

    names = play(written(tmp_path, text))

    assert names["place"] == names["same"] == pytest.approx((40, 30))


@pytest.mark.parametrize(
    "line",
    [
        "from peasy import PeasyCam as Cam, CameraState",
        "from peasycam import PeasyCam as Cam",
        "import peasy; Cam = peasy.PeasyCam",
        "Cam = PeasyCam",
        "add_library('peasycam'); Cam = PeasyCam; CameraState",
    ],
)
def test_every_way_to_get_it_gives_the_same_class(tmp_path: Path, line: str) -> None:
    assert play(written(tmp_path, line))["Cam"] is PeasyCam


def test_module_of_the_sketchs_own_comes_first(tmp_path: Path) -> None:
    written(tmp_path, "PeasyCam = 5", "peasy.py")

    assert play(written(tmp_path, "from peasy import PeasyCam"))["PeasyCam"] == 5


def test_this_may_be_left_out(tmp_path: Path) -> None:
    names = play(written(tmp_path, "size(20, 20, P3D)\ncam = PeasyCam(1, 2, 3, 40)"))

    assert names["cam"].getPosition() == [1, 2, 43]


def test_wrong_numbers_are_told(tmp_path: Path) -> None:
    told = mistake(written(tmp_path, "size(20, 20, P3D)\ncam = PeasyCam(this, 1, 2)"))

    assert "PeasyCam() takes 1 or 4 numbers: distance, or x, y, z, distance." in told


def test_wrong_handler_is_told(tmp_path: Path) -> None:
    text = "size(20, 20, P3D)\nPeasyCam(this, 9).setWheelHandler(5)"

    assert "handleWheel(delta), a function, or None" in mistake(written(tmp_path, text))


def test_without_a_sketch_it_says_so() -> None:
    with pytest.raises(Exception, match="belongs into a sketch that is running"):
        PeasyCam(100)


def test_state_can_be_kept_in_a_file() -> None:
    import pickle

    cam = PeasyCam(new_sketch(), 1, 2, 3, 40)

    assert pickle.loads(pickle.dumps(cam.getState())) == CameraState((1, 0, 0, 0), (1, 2, 3), 40)
