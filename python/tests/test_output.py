"""Every output is written whole or not at all: on a full disk the old file stays, and one line says which file it was."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
from pathlib import Path

import pytest
from full_disk import OUTPUTS

from asperity.tools import output

FILES = {"fmu": "old.fmu", "gallery": "dev/gallery.md", "block": "new.nc", "study": "new.nc", "curve": "old.svg", "indices": "old.svg"}
OLD = b"good\n" * 1000


def ran(name: str, file: Path, room: str, work: Path, *before: str) -> None:
    """Writes an output where there is no room, and looks at what is left."""
    writes_anew = file.suffix == ".nc"  # a file that is there is a study that is done
    prepared = [] if writes_anew else ["sh", "-c", 'yes good | head -n 1000 >"$0" && exec "$@"', str(file)]
    left = ["sh", "-c", '"$@"; s=$?; ls -A "$0" >ls; cat "$0"/old* "$0"/gallery.md >kept 2>/dev/null; exit $s', str(file.parent)]
    program = [sys.executable, str(Path(__file__).with_name("full_disk.py")), name, str(file), room]
    done = subprocess.run([*before, *prepared, *left, *program], cwd=work, capture_output=True, text=True, timeout=300, check=False)
    lines = done.stderr.splitlines()
    assert done.returncode == 1, done.stderr
    assert "Traceback" not in done.stderr and str(file) in lines[-1], done.stderr
    reason = "No space left on device" if room == "disk" else "File too large"
    assert reason in lines[-1], done.stderr
    assert sum(str(file) in line for line in lines) == 1, done.stderr
    names = {*(work / "ls").read_text(encoding="utf-8").split()} - {"filler", "figures"}
    assert names == ({"new.nc.blocks"} if writes_anew else {file.name})
    assert (work / "kept").read_bytes() == (b"" if writes_anew else OLD)


@pytest.mark.parametrize("name", OUTPUTS)
def test_an_output_that_finds_no_room_leaves_what_was_there(name: str, tmp_path: Path) -> None:
    folder = tmp_path / "out"
    folder.mkdir()
    file = folder / FILES.get(name, "old.inc")
    file.parent.mkdir(exist_ok=True)
    ran(name, file, "100", tmp_path)
    if file.suffix == ".nc":
        assert not list(folder.glob("*/*.part"))


@pytest.mark.parametrize("name", ["export", "curve", "fmu", "block", "study"])
def test_a_disk_that_is_full_leaves_what_was_there(name: str, tmp_path: Path) -> None:
    """A disk of 512 KiB in a mount namespace of its own; where the system allows none, a limit on files is as near as one gets."""
    folder = tmp_path / "disk"
    folder.mkdir()
    inside = ["unshare", "--mount", "--map-root-user", "sh", "-c", f'mount -t tmpfs -o size=512k none "{folder}" && exec "$@"', "sh"]
    file = folder / FILES.get(name, "old.inc")
    try:
        mounts = subprocess.run([*inside, "true"], capture_output=True, timeout=60, check=False).returncode == 0
    except FileNotFoundError:
        pytest.fail("this test needs unshare: apt-get install util-linux")
    ran(name, file, "disk", tmp_path, *inside) if mounts else ran(name, file, "200", tmp_path)


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
