"""Pages as a real browser shows them, and what it refuses them."""

from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest

from sketchkit.grading.reports.write import write_class, write_student
from sketchkit.grading.results import ClassResult
from tests.grading.browser import Browser
from tests.grading.reports.sample import hostile_class, make_class

PHONE = (390, 844)
SKY = (0x9C, 0xD3, 0xF0)
BALL = (0xD8, 0x45, 0x2E)
NIGHT = (0x10, 0x13, 0x1C)  # Nora's sky

NAMES = "[...document.querySelectorAll('tbody tr')].map((row) => row.children[0].dataset.value)"
CARDS = "[...document.querySelectorAll('.cards > li .who')].map((who) => who.textContent)"
MARKS = (
    "[...document.querySelectorAll('tbody tr')].map((row) => Number(row.children[1].dataset.value))"
)
SHOWN = "[...document.querySelectorAll('tbody tr')].filter((row) => row.checkVisibility()).length"


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Browser]:
    with closing(Browser(tmp_path_factory.mktemp("profile"))) as started:
        yield started


@pytest.fixture(scope="module")
def results(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("results")
    write_all(make_class(folder), folder)
    return folder


@pytest.fixture
def nora(results: Path) -> Path:
    """The page of who drew another sky and another ball."""
    return results / "students" / "student-14" / "report.html"


def write_all(result: ClassResult, folder: Path) -> None:
    write_class(result, folder)
    for student in result.students:
        write_student(student, result.title, result.record, folder)


def share(picture: np.ndarray, color: tuple[int, int, int]) -> float:
    """Return how much of a picture is of a colour, nearly."""
    return float((np.abs(picture.astype(int) - color).max(axis=2) <= 4).mean())


def assert_quiet(browser: Browser) -> None:
    assert browser.requests == []
    assert browser.faults == []


def test_overview_sorts_rows_and_cards_at_a_click(browser: Browser, results: Path) -> None:
    browser.open(results / "index.html")
    opened = browser.value(NAMES)

    browser.click("th[data-key=marks] button")
    rising = browser.value(MARKS)
    cards = browser.value(CARDS)
    browser.click("th[data-key=marks] button")
    falling = browser.value(MARKS)

    assert opened[0] == "Quentin Roy"
    assert rising == sorted(rising)
    assert rising[0] == -1  # what has no marks is not what has none to lose
    assert falling == sorted(rising, reverse=True)
    assert browser.value(CARDS) == cards[::-1] == browser.value(NAMES)
    assert browser.value("document.querySelector('[aria-sort]').dataset.key") == "marks"
    browser.value(
        "const o = document.querySelector('#ordering'); o.value = 'outlier';"
        "o.dispatchEvent(new Event('change'));"
    )
    assert browser.value(NAMES) == opened
    assert_quiet(browser)


def test_overview_is_filtered_while_one_types(browser: Browser, results: Path) -> None:
    browser.open(results / "index.html")

    browser.click("#filter")
    browser.write("graded far below")

    assert browser.value(SHOWN) == 4
    assert browser.value("document.querySelector('#said').textContent") == "4 of 18"
    assert browser.value(SHOWN.replace("tbody tr", ".cards > li")) == 4
    assert_quiet(browser)


def test_overview_shows_pictures_or_the_table_also_without_scripts(
    browser: Browser, results: Path
) -> None:
    browser.send("Emulation.setScriptExecutionDisabled", value=True)
    try:
        browser.open(results / "index.html", height=1400)
        pictures = browser.picture()
        browser.click("#view-table")
        table = browser.picture()
        shown = browser.value(SHOWN)
        is_sorting = browser.value("!document.querySelector('.sort').disabled")
    finally:
        browser.send("Emulation.setScriptExecutionDisabled", value=False)

    assert share(pictures, SKY) > 0.03
    assert share(table, SKY) == 0
    assert shown == 18
    assert not is_sorting  # a button that could do nothing
    assert_quiet(browser)


def test_student_page_shows_both_pictures(browser: Browser, nora: Path) -> None:
    browser.open(nora)
    browser.value("document.querySelector('.comparison').scrollIntoView({block: 'center'})")

    picture = browser.picture()

    assert share(picture, NIGHT) > 0.02
    assert share(picture, SKY) > 0.02
    assert share(picture, BALL) > 0.0005
    assert_quiet(browser)


def test_slider_lays_one_picture_over_the_other(browser: Browser, nora: Path) -> None:
    browser.open(nora)
    browser.click("[data-view=slider]")
    half = browser.picture()

    browser.value("document.querySelector('.split').focus()")
    browser.press("ArrowRight")
    moved = browser.value("Number(document.querySelector('.split').value)")
    browser.value(
        "const s = document.querySelector('.split'); s.value = 100;"
        "s.dispatchEvent(new Event('input'));"
    )
    whole = browser.picture()

    assert moved > 50
    assert share(whole, NIGHT) > 1.5 * share(half, NIGHT) > 0.01
    assert share(whole, SKY) < share(half, SKY) - 0.01
    assert_quiet(browser)


def test_flicker_shows_one_picture_after_the_other(browser: Browser, nora: Path) -> None:
    browser.open(nora)
    browser.click("[data-view=flicker]")
    browser.click(".pause")
    showing = "document.querySelector('.showing').textContent"
    seen = {}

    for _ in range(2):
        browser.click(".swap")
        seen[browser.value(showing)] = browser.picture()

    assert share(seen["drawn"], NIGHT) > 0.02 + share(seen["expected"], NIGHT)
    assert share(seen["expected"], SKY) > 0.02 + share(seen["drawn"], SKY)
    assert_quiet(browser)


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_pages_fit_a_phone_and_follow_its_colours(
    browser: Browser, results: Path, nora: Path, scheme: str
) -> None:
    for page in (results / "index.html", nora):
        browser.open(page, *PHONE, scheme)

        assert browser.value("document.documentElement.scrollWidth") == PHONE[0]
        assert (browser.picture()[2, 2].mean() < 60) == (scheme == "dark")
        assert_quiet(browser)


def test_no_script_of_a_submission_runs(browser: Browser, tmp_path: Path, results: Path) -> None:
    write_all(hostile_class(), tmp_path)
    pages = [*tmp_path.rglob("*.html"), results / "students" / "script" / "report.html"]

    for page in pages:
        browser.open(page)

        assert browser.value("document.title") != "PWNED"
        assert browser.value("document.scripts.length") == 1
        assert_quiet(browser)


@pytest.mark.parametrize(
    "fault",
    [
        "<script>document.title = 'PWNED'</script>",
        "<img src=x onerror=\"document.title = 'PWNED'\">",
        "<img src='http://127.0.0.1:9/seen.png'>",
        "<link rel=stylesheet href='http://127.0.0.1:9/style.css'>",
        "<iframe src='http://127.0.0.1:9/'></iframe>",
    ],
    ids=["script", "handler", "picture", "style", "frame"],
)
def test_page_would_be_safe_even_if_a_text_were_not_escaped(
    browser: Browser, nora: Path, tmp_path: Path, fault: str
) -> None:
    text = nora.read_text(encoding="utf-8")
    broken = tmp_path / "broken.html"
    broken.write_text(text.replace("<main>", f"<main>{fault}", 1), encoding="utf-8")

    browser.open(broken)

    assert browser.value("document.title") == "Nora Lind - Bouncing ball"
    assert any("Content Security Policy" in message for message in browser.faults)
