"""Files that are written whole or not at all: where the disk is full, what was there before stays."""

from __future__ import annotations

import contextlib
import os
import stat
from pathlib import Path
from typing import Iterator


def write(file: str | os.PathLike[str], content: str | bytes) -> None:
    """Writes a file, text in UTF-8.

    Raises:
        OSError: it cannot be written; `filename` is the file, which is as before.
    """
    with replacing(file) as part, open(part, "wb") as opened:
        opened.write(content.encode() if isinstance(content, str) else content)


@contextlib.contextmanager
def replacing(file: str | os.PathLike[str]) -> Iterator[Path]:
    """Where to write what becomes the file as `with` ends: a new file in its folder, which goes after an error.

    The end of a symbolic link is replaced, not the link; owner and mode stay. Devices and pipes are written in place.

    Raises:
        OSError: as `write`.
    """
    path = part = Path(file)
    try:
        if _in_place(path):
            yield path
            return
        target = Path(os.path.realpath(path))
        old = target.stat() if target.exists() else None
        if old is not None and not os.access(target, os.W_OK):
            target.open("rb+").close()  # raises what says why
        part = target.with_name(f"{target.name[:60]}.{os.urandom(4).hex()}.part")  # within the 255 bytes of a name
        try:
            yield part
            with part.open("rb+") as written:
                os.fsync(written.fileno())
            if old is not None:
                with contextlib.suppress(OSError, AttributeError):  # only root may give files away; Windows has no chown
                    os.chown(part, old.st_uid, old.st_gid)
                part.chmod(stat.S_IMODE(old.st_mode))
            part.replace(target)
        finally:
            part.unlink(missing_ok=True)
    except OSError as error:
        # A writer that names another file means that one.
        if error.errno is None or str(error.filename) not in ("None", str(part), str(path)):
            raise
        raise OSError(error.errno, error.strerror, str(path)) from None


def _in_place(path: Path) -> bool:
    """Whether it is no file to be replaced. /dev/stdout is none even where it leads to a file: others write to it too."""
    folder = os.path.realpath(path.parent)
    return folder in ("/dev", "/dev/fd") or folder.startswith("/proc/") or (path.exists() and not path.is_file())
