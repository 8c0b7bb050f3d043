"""Archives: their files are read one by one, and what is not a plain file refuses the whole."""

from __future__ import annotations

import stat
import struct
import zipfile
import zlib
from collections.abc import Iterator
from pathlib import Path

from sketchkit.grading.intake.naming import shown
from sketchkit.grading.intake.staging import MEGABYTE, Stage
from sketchkit.grading.intake.submission import IntakeLimits, RefusedError

CHUNK = 1 << 16
DIRECTORY_MB = 8  # of a zip's table of contents; 2000 files have a fifth of one
RATIO = 1000  # deflate's own limit is 1032; a picture or a sketch compresses some 10 times
IS_ENCRYPTED, IS_UTF8 = 0x1, 0x800  # bits of a member's flags
UNIX, UNICODE_PATH = 3, 0x7075  # a system, and a kind of extra field
# What zipfile raises for archives that are broken, each in another way.
BROKEN = (
    *(zipfile.BadZipFile, zlib.error, EOFError, OSError, ValueError, struct.error),
    *(NotImplementedError, OverflowError, IndexError, UnicodeError, MemoryError, RuntimeError),
)


def unpack(archive: Path, stage: Stage, limits: IntakeLimits) -> None:
    """Put the files of a zip on a stage.

    Raises
    ------
    RefusedError
        If it is broken, hostile, or more than a submission may be.
    """
    if archive.stat().st_size > limits.total_mb * MEGABYTE:
        raise RefusedError(f"The zip is larger than {limits.total_mb} MB.")
    _check_directory(archive)
    try:
        with zipfile.ZipFile(archive) as zipped:
            members = zipped.infolist()
            _check(members, limits)
            for member in members:
                if not member.is_dir():
                    stage.add(_name(member), _chunks(zipped, member))
    except RefusedError:
        raise
    except BROKEN as reason:
        raise RefusedError(
            f"The zip is broken: {shown(str(reason)) or type(reason).__name__}. "
            "Make it anew and open it once before handing it in."
        ) from None


def _check_directory(archive: Path) -> None:
    """Refuse a table of contents that is too large to be read: zipfile reads all of it at once."""
    tail = archive.stat().st_size - (1 << 16) - 22
    with archive.open("rb") as file:
        file.seek(max(0, tail))
        end = file.read()
    start = end.rfind(b"PK\x05\x06")
    if start < 0 or len(end) < start + 22:
        raise RefusedError("This is not a zip, although it is called so, or only a part of one.")
    size = int(struct.unpack_from("<I", end, start + 12)[0])
    if size > DIRECTORY_MB * MEGABYTE:
        raise RefusedError("The zip's table of contents is too large.")


def _check(members: list[zipfile.ZipInfo], limits: IntakeLimits) -> None:
    if len(members) > limits.files:
        raise RefusedError(f"It has more than {limits.files} files and folders.")
    if len({member.header_offset for member in members}) < len(members):
        raise RefusedError("The zip is a bomb: some of its files share their bytes.")
    for member in members:
        name = shown(member.filename)
        if member.flag_bits & IS_ENCRYPTED:
            raise RefusedError("The zip is locked with a password. Hand it in without one.")
        if member.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
            raise RefusedError(
                "The zip is packed in an unusual way. Make it with your system's own program."
            )
        kind = stat.S_IFMT(member.external_attr >> 16) if member.create_system == UNIX else 0
        if kind == stat.S_IFLNK:
            raise RefusedError(f"{name!r} in the zip is a link. Put the file itself into it.")
        if kind not in (0, stat.S_IFREG, stat.S_IFDIR):
            raise RefusedError(f"{name!r} in the zip is not a file but a device or a pipe.")
        if "\0" in member.orig_filename:
            raise RefusedError(f"A file's name in the zip has a zero in it: {name!r}.")


def _name(member: zipfile.ZipInfo) -> str:
    """Return a member's name as its author wrote it.

    A zip says whether a name is UTF-8. Where it does not, the name is in an old code page, unless
    its bytes can be read as UTF-8: macOS and many servers forget to say so.
    """
    if member.flag_bits & IS_UTF8:
        return member.filename
    told = _unicode_path(member)
    if told is not None:
        return told
    try:
        return member.filename.encode("cp437").decode("utf-8")
    except UnicodeError:
        return member.filename


def _unicode_path(member: zipfile.ZipInfo) -> str | None:
    """Return the name in the extra field that Info-ZIP and WinRAR write, if it fits."""
    extra = member.extra
    while len(extra) >= 4:
        kind, size = struct.unpack_from("<HH", extra)
        field, extra = extra[4 : 4 + size], extra[4 + size :]
        if kind == UNICODE_PATH and len(field) > 5:
            checksum = int(struct.unpack_from("<I", field, 1)[0])
            if checksum == zlib.crc32(member.orig_filename.encode("cp437", "replace")):
                return field[5:].decode("utf-8", "replace")
    return None


def _chunks(zipped: zipfile.ZipFile, member: zipfile.ZipInfo) -> Iterator[bytes]:
    """Yield a member's content; refuse one that grows beyond measure while it does."""
    bound = RATIO * max(member.compress_size, 1) + CHUNK
    size = 0
    with zipped.open(member) as stream:
        while chunk := stream.read(CHUNK):
            size += len(chunk)
            if size > bound:
                raise RefusedError("The zip is a bomb: it unpacks to a thousand times its size.")
            yield chunk
