"""One process at a time: a lock that the system takes from a process when it ends, however that is."""

from __future__ import annotations

import contextlib
import errno
import os
import sys
from pathlib import Path
from typing import Iterator

from ..tools import caller

# File systems of some clusters have no locks.
_NO_LOCKS = (errno.ENOLCK, errno.ENOSYS, errno.EOPNOTSUPP)

if sys.platform == "win32":
    import msvcrt

    def _take(descriptor: int) -> None:
        os.lseek(descriptor, 1 << 30, os.SEEK_SET)  # behind the text, which others could not read else
        try:
            msvcrt.locking(descriptor, msvcrt.LK_NBLCK, 1)
        except PermissionError:
            raise BlockingIOError from None
        finally:
            os.lseek(descriptor, 0, os.SEEK_SET)

else:
    import fcntl

    def _take(descriptor: int) -> None:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)


@contextlib.contextmanager
def locked(file: Path, what: str) -> Iterator[None]:
    """Holds the lock that is a file, which is removed at the end.

    Raises:
        BlockingIOError: another process holds it; the message says which, and begins with `what`.
    """
    descriptor = _opened(file, what)
    try:
        yield
    finally:
        # A file that is open can be removed first, so that nobody gets it in between; but not on Windows.
        if sys.platform != "win32":
            file.unlink(missing_ok=True)
            with contextlib.suppress(OSError):
                fcntl.flock(descriptor, fcntl.LOCK_UN)  # for copies of the descriptor in forked processes, too
        os.close(descriptor)
        if sys.platform == "win32":
            with contextlib.suppress(OSError):
                file.unlink()


def _opened(file: Path, what: str) -> int:
    while True:
        descriptor = os.open(file, os.O_RDWR | os.O_CREAT, 0o666)
        try:
            try:
                _take(descriptor)
            except BlockingIOError:
                holder = os.read(descriptor, 500).decode(errors="replace") or "another process"
                raise BlockingIOError(
                    f"{what}: {holder} is at work on it; wait until it is done, or give another name"
                ) from None
            except OSError as error:
                if error.errno not in _NO_LOCKS:
                    raise
                caller.warn(f"{what}: cannot be locked here ({error}): let no other process work on it", RuntimeWarning)
            # The file may be the one that its holder has just removed.
            with contextlib.suppress(FileNotFoundError):
                if os.path.samestat(os.fstat(descriptor), os.stat(file)):
                    os.ftruncate(descriptor, 0)
                    import socket

                    os.write(descriptor, f"process {os.getpid()} of {socket.gethostname()}".encode())
                    return descriptor
        except BaseException:
            os.close(descriptor)
            raise
        os.close(descriptor)
