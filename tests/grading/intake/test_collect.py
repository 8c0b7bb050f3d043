"""Submissions as classes hand them in, and as nobody should."""

from __future__ import annotations

import io
import os
import socket
import struct
import zipfile
from collections.abc import Callable, Mapping
from pathlib import Path, PurePosixPath

import pytest

from sketchkit.grading.intake.collect import IntakeError, collect
from sketchkit.grading.intake.naming import slugs
from sketchkit.grading.intake.submission import IntakeLimits, Submission

SKETCH = "def setup():\n    size(100, 100)\n\ndef draw():\n    rect(10, 10, 20, 20)\n"
SMALL = IntakeLimits(files=20, file_mb=2, total_mb=3, source_kb=64, depth=4)


@pytest.fixture
def submissions(tmp_path: Path) -> Path:
    folder = tmp_path / "submissions"
    folder.mkdir()
    return folder


@pytest.fixture
def collected(submissions: Path, tmp_path: Path) -> Callable[[], tuple[Submission, ...]]:
    return lambda: collect(submissions, tmp_path / "staging", limits=SMALL)


@pytest.fixture
def only(collected: Callable[[], tuple[Submission, ...]]) -> Callable[[], Submission]:
    """Return the one that is judged here. Another one goes on beside it, whatever it is."""

    def find() -> Submission:
        (one,) = collected()
        return one

    return find


Collected = Callable[[], tuple[Submission, ...]]
Only = Callable[[], Submission]


def zip_of(files: Mapping[str, str | bytes], compression: int = zipfile.ZIP_DEFLATED) -> bytes:
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", compression) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    return data.getvalue()


def zip_of_entries(*entries: tuple[zipfile.ZipInfo, bytes]) -> bytes:
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", zipfile.ZIP_DEFLATED) as archive:
        for info, content in entries:
            archive.writestr(info, content)
    return data.getvalue()


def contents(submission: Submission) -> dict[str, bytes]:
    folder = submission.folder
    assert folder is not None
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


# --- what is handed in ----------------------------------------------------------------------


def test_folders_zips_and_files_may_be_mixed(submissions: Path, collected: Collected) -> None:
    (submissions / "Zoe").mkdir()
    (submissions / "Zoe" / "sketch.py").write_text(SKETCH)
    (submissions / "Ada.zip").write_bytes(zip_of({"sketch.py": SKETCH}))
    (submissions / "Mia.py").write_text(SKETCH)

    found = collected()

    assert [one.name for one in found] == ["Ada", "Mia", "Zoe"]
    assert [str(one.sketch) for one in found] == ["sketch.py", "Mia.py", "sketch.py"]
    assert [one.refusal for one in found] == ["", "", ""]


def test_names_are_kept_as_they_are(submissions: Path, collected: Collected) -> None:
    names = [
        "Åsa Öberg-Nuñez (2nd try)",
        "李 小龙",
        "Müller Anna_12345_assignsubmission_file_",
        "x" * 200,
        "…",
        "a'b\"c<script>",
    ]
    for name in names:
        (submissions / name).mkdir()
        (submissions / name / "sketch.py").write_text(SKETCH)

    found = collected()

    assert {one.name for one in found} == set(names)
    assert all(one.slug.isascii() and len(one.slug) <= 60 for one in found)
    assert {str(one.folder.name) for one in found if one.folder} == {one.slug for one in found}


def test_slugs_differ_where_names_nearly_do(submissions: Path, collected: Collected) -> None:
    for name in ("Zoë", "Zoe", "zoe", "Zoe!", "con", "x" * 70, "x" * 71):
        (submissions / f"{name}.py").write_text(SKETCH)

    found = collected()

    assert len({one.slug.lower() for one in found}) == 7
    assert "con" not in {one.slug for one in found}
    assert not any(one.refusal for one in found)


def test_slug_that_another_name_will_get_cannot_be_taken_before() -> None:
    names = ["A", "a"]
    guessed = slugs(names)[1]

    found = slugs(["A", guessed.upper(), "a"])

    assert len({slug.lower() for slug in found}) == 3


def test_a_name_that_is_no_unicode_can_be_reported(submissions: Path, only: Only) -> None:
    path = os.fsencode(submissions) + b"/M\xfcller.py"
    try:
        with open(path, "w") as file:
            file.write(SKETCH)
    except OSError:
        pytest.skip("this file system only has names in Unicode")

    submission = only()

    assert submission.name == "M\ufffdller"
    assert submission.refusal == ""


def test_a_class_may_come_as_a_zip_of_zips(tmp_path: Path) -> None:
    archive = tmp_path / "class.zip"
    inner = zip_of({"sketch.py": SKETCH})
    archive.write_bytes(zip_of({"Ada_1_file_/work.zip": inner, "Mia_2_file_/sketch.py": SKETCH}))

    found = collect(archive, tmp_path / "staging")

    assert [(one.name, one.refusal) for one in found] == [("Ada_1_file_", ""), ("Mia_2_file_", "")]


def test_what_computers_leave_behind_is_left_out(submissions: Path, only: Only) -> None:
    litter = {
        "__MACOSX/._sketch.py": "x",
        ".DS_Store": "x",
        "sketch/__pycache__/sketch.cpython-311.pyc": "x",
        "sketch/.git/config": "x",
        "sketch/Icon\r": "x",
    }
    (submissions / ".DS_Store").write_text("x")
    (submissions / "Ada.zip").write_bytes(zip_of({"sketch/sketch.py": SKETCH, **litter}))

    submission = only()

    assert list(contents(submission)) == ["sketch/sketch.py"]
    assert submission.sketch == PurePosixPath("sketch/sketch.py")


def test_the_same_content_has_the_same_digest(submissions: Path, collected: Collected) -> None:
    (submissions / "Ada.zip").write_bytes(zip_of({"a.py": SKETCH, "b/c.txt": "1"}))
    (submissions / "Bob" / "b").mkdir(parents=True)
    (submissions / "Bob" / "a.py").write_text(SKETCH)
    (submissions / "Bob" / "b" / "c.txt").write_text("1")
    (submissions / "Cid.zip").write_bytes(zip_of({"a.py": SKETCH, "b/d.txt": "1"}))
    (submissions / "Dan.zip").write_bytes(zip_of({"a.py": SKETCH, "b/c.txt": "2"}))

    ada, bob, cid, dan = (one.digest for one in collected())

    assert ada == bob
    assert len({ada, cid, dan}) == 3


def test_staging_again_replaces_what_was_there(submissions: Path, only: Only) -> None:
    (submissions / "Ada.zip").write_bytes(zip_of({"sketch.py": SKETCH, "old.txt": "x"}))
    only()
    (submissions / "Ada.zip").write_bytes(zip_of({"sketch.py": SKETCH}))

    assert list(contents(only())) == ["sketch.py"]


def test_others_may_read_the_copies_whatever_the_umask(submissions: Path, only: Only) -> None:
    (submissions / "Ada.zip").write_bytes(zip_of({"sketch.py": SKETCH, "data/x.txt": "x"}))
    before = os.umask(0o077)
    try:
        submission = only()
    finally:
        os.umask(before)

    folder = submission.folder
    assert folder is not None
    modes = [
        path.stat().st_mode & 0o777 for path in (folder, folder / "data", folder / "sketch.py")
    ]
    assert modes == [0o755, 0o755, 0o644]


@pytest.mark.parametrize("kind", ["nothing", "no folder"])
def test_nothing_to_grade_is_told(tmp_path: Path, kind: str) -> None:
    folder = tmp_path / "submissions"
    if kind == "nothing":
        folder.mkdir()

    with pytest.raises(IntakeError, match=r"no submissions in|neither a folder nor a zip"):
        collect(folder, tmp_path / "staging")


# --- which file is the sketch ---------------------------------------------------------------


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        (["anything.py"], "anything.py"),
        (["Ada.py", "other.py"], "Ada.py"),
        (["ball/ball.py", "ball/other.py"], "ball/ball.py"),
        (["a/b/ball.py"], "a/b/ball.py"),
        (["sketch.py", "other.py"], "sketch.py"),
        (["main.py", "other.py"], "main.py"),
        (["sketch.py", "main.py"], "sketch.py"),
        (["ball.pyde", "other.py", "third.py"], "ball.pyde"),
        (["helper.py:x = 1", "ball.py"], "ball.py"),
        (["helper.py:def setup(): pass", "ball.py"], "ball.py"),
        (["helper.py:# def draw():\n 'def draw(): '", "ball.py"], "ball.py"),
        (["ball.py", "deeper/other.py", "deeper/sketch.py"], "ball.py"),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_the_sketch_is_found(
    submissions: Path, only: Only, files: list[str], expected: str
) -> None:
    parts = (file.partition(":") for file in files)
    (submissions / "Ada.zip").write_bytes(zip_of({name: text or SKETCH for name, _, text in parts}))

    assert str(only().sketch) == expected


@pytest.mark.parametrize(
    ("files", "words"),
    [
        ({"a.py": SKETCH, "b.py": SKETCH}, "not clear which of its files is the sketch: 'a.py'"),
        ({"ball.pde": "void draw() {}"}, "Java"),
        ({"readme.txt": "x"}, "no file of Python"),
        ({"work.ipynb": "{}"}, "notebook"),
        ({"inner.zip": zip_of({"sketch.py": SKETCH})}, "an archive within it"),
        ({"a/b/c/sketch.py": SKETCH}, "too deep"),
        ({}, "no file in it"),
    ],
    ids=["two", "java", "text", "notebook", "zip in zip", "deep", "empty"],
)
def test_no_sketch_is_told(
    submissions: Path, only: Only, files: dict[str, str | bytes], words: str
) -> None:
    (submissions / "Ada.zip").write_bytes(zip_of(files))

    assert words in only().refusal


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (SKETCH.encode("utf-16"), "UTF-16"),
        (SKETCH.encode("utf-16-le"), "zeros"),
        ("# x\nname = 'Zoë'".encode("latin-1"), "line 2"),
        (b"\0\0\0", "zeros"),
        (b" \n", "empty"),
    ],
    ids=["utf-16", "utf-16 without a mark", "latin-1", "binary", "empty"],
)
def test_a_file_that_is_no_text_is_told(
    submissions: Path, only: Only, content: bytes, words: str
) -> None:
    (submissions / "Ada.py").write_bytes(content)

    assert words in only().refusal


@pytest.mark.parametrize(
    "content",
    [
        b"\xef\xbb\xbf" + SKETCH.encode(),
        "# -*- coding: latin-1 -*-\nname = 'Zoë'".encode("latin-1"),
        "#!/usr/bin/python\n# coding=cp1252\nname = '€'".encode("cp1252"),
        SKETCH.replace("\n", "\r\n").encode(),
    ],
    ids=["byte order mark", "coding", "coding in line 2", "CRLF"],
)
def test_a_file_that_python_reads_is_kept_as_it_is(
    submissions: Path, only: Only, content: bytes
) -> None:
    (submissions / "Ada.py").write_bytes(content)

    assert contents(only()) == {"Ada.py": content}


@pytest.mark.parametrize("suffix", [".rar", ".7z", ".tar.gz", ".pdf", ""])
def test_another_kind_of_file_is_refused(submissions: Path, only: Only, suffix: str) -> None:
    (submissions / f"Ada{suffix}").write_bytes(b"x")

    submission = only()

    assert submission.name == f"Ada{suffix}"
    assert submission.refusal.startswith("It is a")


# --- zips that lie --------------------------------------------------------------------------


@pytest.mark.parametrize(
    "name",
    [
        *("../outside.py", "a/../../outside.py", "/tmp/outside.py", "..\\outside.py"),
        *("C:\\outside.py", "C:outside.py", "\\\\server\\share\\x.py", "a/\x01.py"),
        *("a\nb.py", "x" * 300 + ".py", "a/b/c/d/e/f.py", "ü" * 130 + ".py"),
    ],
)
def test_a_name_that_leads_elsewhere_refuses_the_zip(
    submissions: Path, tmp_path: Path, only: Only, name: str
) -> None:
    before = sorted(path for path in Path("/tmp").glob("outside*"))
    (submissions / "Ada.zip").write_bytes(zip_of({"sketch.py": SKETCH, name: "x"}))

    submission = only()

    assert submission.refusal
    assert submission.folder is None
    assert list((tmp_path / "staging").iterdir()) == []
    assert sorted(path for path in Path("/tmp").glob("outside*")) == before


def test_windows_separators_make_folders(submissions: Path, only: Only) -> None:
    (submissions / "Ada.zip").write_bytes(zip_of({"ball\\ball.py": SKETCH, "ball\\a.txt": "x"}))

    assert sorted(contents(only())) == ["ball/a.txt", "ball/ball.py"]


def test_a_zero_in_a_name_is_refused(submissions: Path, only: Only) -> None:
    data = zip_of({"sketch.py": SKETCH, "aXb.py": "x"}).replace(b"aXb.py", b"a\0b.py")
    (submissions / "Ada.zip").write_bytes(data)

    assert "zero" in only().refusal


@pytest.mark.parametrize(
    ("mode", "words"),
    [(0o120777, "link"), (0o010644, "device or a pipe"), (0o020666, "device or a pipe")],
    ids=["link", "pipe", "device"],
)
def test_what_is_no_file_refuses_the_zip(
    submissions: Path, only: Only, mode: int, words: str
) -> None:
    info = zipfile.ZipInfo("sketch.py")
    info.create_system = 3
    info.external_attr = mode << 16
    (submissions / "Ada.zip").write_bytes(zip_of_entries((info, b"/etc/passwd")))

    assert words in only().refusal


def test_a_bomb_is_refused_while_it_unpacks(submissions: Path, only: Only) -> None:
    (submissions / "Ada.zip").write_bytes(zip_of({"sketch.py": SKETCH, "a.bin": bytes(3 << 20)}))

    assert "larger than 2 MB" in only().refusal


def test_many_large_files_are_refused_together(submissions: Path, only: Only) -> None:
    files = {f"{number}.bin": bytes(1 << 20) for number in range(4)}
    (submissions / "Ada.zip").write_bytes(zip_of({"sketch.py": SKETCH, **files}))

    assert "larger than 3 MB all together" in only().refusal


def test_a_size_in_a_header_is_not_believed(submissions: Path, only: Only) -> None:
    data = bytearray(zip_of({"a.bin": bytes(3 << 20), "sketch.py": SKETCH}))
    for start in (data.find(b"PK\x03\x04") + 22, data.find(b"PK\x01\x02") + 24):
        data[start : start + 4] = struct.pack("<I", 100)
    (submissions / "Ada.zip").write_bytes(bytes(data))

    submission = only()

    assert submission.refusal


def test_entries_that_share_their_bytes_are_bounded(submissions: Path, only: Only) -> None:
    """As in a bomb without nesting: many entries of the directory for the same data."""
    data = zip_of({"a.bin": bytes(2 << 20)})
    directory = data.find(b"PK\x01\x02")
    end = data.find(b"PK\x05\x06")
    entry = data[directory:end]
    many = b"".join(entry.replace(b"a.bin", b"%c.bin" % letter) for letter in b"abcdefgh")
    tail = struct.pack("<4sHHHHIIH", b"PK\x05\x06", 0, 0, 8, 8, len(many), directory, 0)
    (submissions / "Ada.zip").write_bytes(data[:directory] + many + tail)

    assert only().refusal == "The zip is a bomb: some of its files share their bytes."


def test_too_many_files_are_refused(submissions: Path, only: Only) -> None:
    (submissions / "Ada.zip").write_bytes(zip_of({f"{n}.py": "x" for n in range(21)}))

    assert "more than 20 files" in only().refusal


def test_too_long_a_source_is_refused(submissions: Path, only: Only) -> None:
    (submissions / "Ada.py").write_text("x = 1\n" * 20_000)

    assert "more than 64 kB of Python" in only().refusal


@pytest.mark.parametrize("second", ["sketch.py", "Sketch.PY", "sketch.py/x"])
def test_two_files_of_one_name_are_refused(submissions: Path, only: Only, second: str) -> None:
    first, other = zipfile.ZipInfo("sketch.py"), zipfile.ZipInfo("sketch.pX")
    data = zip_of_entries((first, SKETCH.encode()), (other, b"2"))
    data = zip_of({"sketch.py": SKETCH, second: "2"}) if second != "sketch.py" else data
    (submissions / "Ada.zip").write_bytes(data.replace(b"sketch.pX", b"sketch.py"))

    assert only().refusal


def test_a_locked_zip_is_refused(submissions: Path, only: Only) -> None:
    data = bytearray(zip_of({"sketch.py": SKETCH}))
    data[data.find(b"PK\x03\x04") + 6] |= 1
    data[data.find(b"PK\x01\x02") + 8] |= 1
    (submissions / "Ada.zip").write_bytes(bytes(data))

    assert "password" in only().refusal


@pytest.mark.parametrize("compression", [zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_an_unusual_compression_is_refused(submissions: Path, only: Only, compression: int) -> None:
    (submissions / "Ada.zip").write_bytes(zip_of({"sketch.py": SKETCH}, compression))

    assert "unusual" in only().refusal


def broken(change: Callable[[bytearray], object]) -> bytes:
    data = bytearray(zip_of({"sketch.py": SKETCH}, zipfile.ZIP_STORED))
    change(data)
    return bytes(data)


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"PK",
        b"not a zip at all" * 99,
        broken(lambda data: data.__setitem__(slice(60, 64), b"XXXX")),
        broken(lambda data: data.__delitem__(slice(len(data) // 2, None))),
        broken(lambda data: data.__delitem__(slice(0, 40))),
        broken(lambda data: data.__setitem__(slice(-6, -2), b"\xff\xff\xff\x7f")),
        broken(lambda data: data.__setitem__(slice(-10, -6), b"\xff\xff\xff\x7f")),
        zip_of({"sketch.py": SKETCH})[:-30],
    ],
    ids=[
        *("empty", "two bytes", "text", "bad checksum", "half", "without its beginning"),
        *("directory elsewhere", "huge directory", "without its end"),
    ],
)
def test_a_broken_zip_is_refused_and_the_others_go_on(
    submissions: Path, collected: Collected, data: bytes
) -> None:
    (submissions / "Ada.zip").write_bytes(data)
    (submissions / "Bob.py").write_text(SKETCH)

    ada, bob = collected()

    assert "zip" in ada.refusal
    assert ada.refusal.endswith(".")
    assert bob.refusal == ""


@pytest.mark.parametrize("flag", [True, False], ids=["told", "not told"])
def test_names_in_utf_8_are_read_as_such(submissions: Path, only: Only, flag: bool) -> None:
    data = bytearray(zip_of({"sketch.py": SKETCH, "Bälle.txt": "x"}))
    if not flag:  # as macOS writes it: the bytes are UTF-8 and nothing says so
        for magic, offset in ((b"PK\x03\x04", 7), (b"PK\x01\x02", 9)):
            data[data.rfind(magic) + offset] &= ~0x08
    (submissions / "Ada.zip").write_bytes(bytes(data))

    assert "Bälle.txt" in contents(only())


def test_names_in_an_old_code_page_are_read_as_such(submissions: Path, only: Only) -> None:
    data = zip_of({"sketch.py": SKETCH, "BXlle.txt": "x"}).replace(b"BXlle", b"B\x84lle")
    (submissions / "Ada.zip").write_bytes(data)

    assert "Bälle.txt" in contents(only())


# --- folders --------------------------------------------------------------------------------


def test_a_folder_with_only_a_zip_is_unpacked(submissions: Path, only: Only) -> None:
    (submissions / "Ada").mkdir()
    (submissions / "Ada" / "my work.zip").write_bytes(zip_of({"ball/ball.py": SKETCH}))

    assert str(only().sketch) == "ball/ball.py"


@pytest.mark.parametrize("kind", ["link", "linked folder", "pipe", "socket"])
def test_what_is_no_file_refuses_the_folder(
    submissions: Path, tmp_path: Path, only: Only, kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = submissions / "Ada"
    folder.mkdir()
    (folder / "sketch.py").write_text(SKETCH)
    secret = tmp_path / "secret"
    secret.mkdir()
    if kind == "link":
        (folder / "data.txt").symlink_to("/etc/passwd")
    elif kind == "linked folder":
        (folder / "data").symlink_to(secret)
    elif kind == "pipe":
        os.mkfifo(folder / "pipe.txt")
    else:
        monkeypatch.chdir(folder)  # a socket's path must be short
        with socket.socket(socket.AF_UNIX) as made:
            made.bind("socket.txt")

    assert "is a link" in only().refusal or "not a file" in only().refusal


@pytest.mark.parametrize("kind", ["link", "pipe", "pipe called zip", "loop"])
def test_what_is_no_file_is_refused_as_a_submission(
    submissions: Path, only: Only, kind: str
) -> None:
    if kind == "link":
        (submissions / "Ada.py").symlink_to("/etc/passwd")
    elif kind == "loop":
        (submissions / "Ada").symlink_to(submissions)
    else:
        os.mkfifo(submissions / ("Ada.zip" if "zip" in kind else "Ada.py"))

    assert "link" in only().refusal or "pipe" in only().refusal


def test_a_folder_that_is_too_deep_is_refused(submissions: Path, only: Only) -> None:
    deep = submissions / "Ada" / "a/b/c/d/e/f"
    deep.mkdir(parents=True)
    (submissions / "Ada" / "sketch.py").write_text(SKETCH)
    (deep / "x.txt").write_text("x")

    assert "deeper than 4" in only().refusal


def test_a_hollow_file_is_not_copied_to_its_end(submissions: Path, only: Only) -> None:
    (submissions / "Ada").mkdir()
    (submissions / "Ada" / "sketch.py").write_text(SKETCH)
    with (submissions / "Ada" / "hollow.bin").open("wb") as file:
        file.truncate(1 << 40)

    assert "larger than 2 MB" in only().refusal
