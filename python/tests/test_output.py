"""Every output is written whole or not at all: on a full disk the old file stays, and one line says which file it was."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import threading
from pathlib import Path

import pytest
from asperity.tools import output

OLD = b"good\n" * 1000
FULL = """
import resource, sys
from asperity.tools import output
resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))  # Python ignores SIGXFSZ: an error is left
output.write(sys.argv[1], "new\\n" * 1000)
"""


def test_an_output_that_finds_no_room_leaves_what_was_there(tmp_path: Path) -> None:
    """Tables, figures, units and surface files are written by this function; the blocks of a study by one like it."""
    file = tmp_path / "old.inc"
    file.write_bytes(OLD)
    done = subprocess.run([sys.executable, "-c", FULL, str(file)], capture_output=True, text=True, timeout=60, check=False)
    assert f"OSError: [Errno 27] File too large: '{file}'" in done.stderr
    assert file.read_bytes() == OLD and list(tmp_path.iterdir()) == [file]


def test_links_modes_and_names_stay(tmp_path: Path) -> None:
    target, link = tmp_path / "target", tmp_path / "link"
    link.symlink_to("target")
    output.write(link, "a\n")  # a link to what is not there yet
    before = os.umask(0o027)
    try:
        output.write(tmp_path / "new", b"")
    finally:
        os.umask(before)
    assert (tmp_path / "new").stat().st_mode & 0o777 == 0o640
    target.chmod(0o604)
    output.write(link, "µ\n")
    assert link.is_symlink() and target.read_bytes() == "µ\n".encode() and target.stat().st_mode & 0o777 == 0o604
    longest = tmp_path / ("ü" * 127)
    output.write(longest, "a")
    assert longest.read_text(encoding="utf-8") == "a"
    assert {path.name for path in tmp_path.iterdir()} == {"target", "link", "new", longest.name}


def test_pipes_and_devices_are_written_in_place(tmp_path: Path) -> None:
    pipe, found = tmp_path / "pipe", []
    os.mkfifo(pipe)
    reader = threading.Thread(target=lambda: found.append(pipe.read_bytes()), daemon=True)
    reader.start()
    output.write(pipe, "through\n")
    reader.join(60)
    assert found == [b"through\n"] and pipe.is_fifo()
    with pytest.raises(OSError, match="No space left on device: '/dev/full'"):
        output.write("/dev/full", "a")
    # What the standard output leads to stays the file that others have open.
    with open(tmp_path / "log", "wb") as log:
        program = "from asperity.tools import output; output.write('/dev/stdout', 'a\\n')"
        subprocess.run([sys.executable, "-c", program], stdout=log, timeout=60, check=True)
        assert os.fstat(log.fileno()).st_ino == (tmp_path / "log").stat().st_ino
    assert (tmp_path / "log").read_bytes() == b"a\n"


def test_what_may_not_be_written_is_named(tmp_path: Path) -> None:
    for file, error in ((tmp_path, IsADirectoryError), (tmp_path / "no" / "file", FileNotFoundError)):
        with pytest.raises(error) as raised:
            output.write(file, "a")
        assert raised.value.filename == str(file)


UNIT = """
import resource, sys
from pathlib import Path
from asperity import Params
from asperity.hosts.fmu import build
from asperity.hosts.fmu_binaries import native
resource.setrlimit(resource.RLIMIT_FSIZE, (int(sys.argv[2]), int(sys.argv[2])))
build(Params.paper(), Path(sys.argv[1]), fmi="2.0", start_load=1.0, platforms=[native()], libraries={})
"""


@pytest.mark.parametrize("room", [1000, 200_000])
def test_a_unit_that_finds_no_room_where_it_is_made_is_named(room: int, tmp_path: Path) -> None:
    """Neither the source that was copied nor a file of the folder for temporary files, which the caller does not know."""
    file = tmp_path / "contact.fmu"
    done = subprocess.run([sys.executable, "-c", UNIT, str(file), str(room)], capture_output=True, text=True, timeout=60, check=False)
    assert re.search(rf"OSError: .*cannot be made in the folder for temporary files, .*File too large.*: '{file}'", done.stderr), done.stderr
    assert list(tmp_path.iterdir()) == []


def test_no_message_sends_to_a_name_of_a_registry_that_is_not_ours(root: Path) -> None:
    """The package is installed from a checkout or a file: who follows "pip install asperity" gets whatever has that name."""
    for path in (root / "python" / "src").rglob("*.py"):
        assert not re.search(r"pip install [^\n]*\basperity\b", path.read_text(encoding="utf-8")), path
