"""The binaries of a mock-up unit: for the platforms of FMI that have a library, on this machine or for another."""

from __future__ import annotations

import importlib.util
import os
import platform
import re
import shutil
import subprocess
import sys
import zipfile
from dataclasses import dataclass
from pathlib import Path

from .. import _header, _library


@dataclass(frozen=True)
class _Platform:
    """What units for a platform need: its name in FMI 3.0, its system, its library and the ending of its files, the platform of
    its wheel, its compilers with Debian's package, zig's name of it, and flags."""

    fmi3: str
    system: str
    library: str
    ending: str
    wheel: str
    native_compiler: str
    cross_compiler: str
    cross_package: str
    zig: str
    flags: tuple[str, ...]


PLATFORMS = {
    "linux64": _Platform(
        "x86_64-linux", "Linux", "libasperity.so", ".so", "manylinux_2_17_x86_64", "cc", "x86_64-linux-gnu-gcc",
        "gcc-x86-64-linux-gnu", "x86_64-linux-gnu.2.17",
        ("-fPIC", "-fvisibility=hidden", "-Wl,-rpath,$ORIGIN", "-Wl,--no-undefined"),
    ),
    "win64": _Platform(
        "x86_64-windows", "Windows", "asperity.dll", ".dll", "win_amd64", "gcc", "x86_64-w64-mingw32-gcc",
        "gcc-mingw-w64-x86-64", "x86_64-windows-gnu", (),
    ),
}  # fmt: skip


def native() -> str | None:
    """The platform of this machine, if units can have binaries for it."""
    if platform.machine().lower() not in ("x86_64", "amd64"):
        return None
    return {"linux": "linux64", "win32": "win64"}.get(sys.platform)


def library_for(name: str, given: Path | None) -> bytes:
    """The library of a platform: the one that is given, alone or in a wheel or zip, else that of this package."""
    wanted = PLATFORMS[name]
    if given is None:
        if name != native():
            raise ImportError(
                f"a unit for {name} needs the library of {wanted.system}: give it with --library {name}=FILE, where FILE is the "
                f"wheel asperity-{_header.ASPERITY_VERSION}-py3-none-{wanted.wheel}.whl, the archive of a release for that "
                f"system, if it is a zip, or {wanted.library}"
            )
        given = Path(_library.PATH)
    content = _taken(given, wanted.library) if zipfile.is_zipfile(given) else given.read_bytes()
    if not _is_of(name, content):
        raise ImportError(f"{given}: is not a library for {wanted.system} on x86-64")
    return content


def _taken(archive: Path, library: str) -> bytes:
    with zipfile.ZipFile(archive) as opened:
        members = [member for member in opened.namelist() if member.rsplit("/", 1)[-1] == library]
        if len(members) != 1:
            raise ImportError(f"{archive}: has {len(members)} files named {library}; it must have one")
        return opened.read(members[0])


def _is_of(name: str, content: bytes) -> bool:
    """By the head of the file: 62 is the machine x86-64 in ELF, 0x8664 in the PE of Windows."""
    if name == "linux64":
        return content[:5] == b"\x7fELF\x02" and content[18:20] == b"\x3e\x00"
    start = int.from_bytes(content[60:64], "little")
    return content[:2] == b"MZ" and content[start : start + 6] == b"PE\0\0\x64\x86"


def _soname(library: bytes) -> str | None:
    """The name that a unit linked with the library looks for: releases for Linux have one, with the number of the interface."""
    found = re.search(rb"\0(libasperity\.so\.\d+)\0", library)
    return found[1].decode() if found else None


def add_binaries(folder: Path, name: str, library: bytes, sources: Path, unit: str) -> None:
    """The library and the unit, compiled from the sources, in a new folder."""
    wanted = PLATFORMS[name]
    compiler = _compiler(name)
    folder.mkdir(parents=True)
    file = _soname(library) or wanted.library
    (folder / file).write_bytes(library)
    command = [*compiler, "-std=c99", "-O2", "-Wall", "-Wextra", "-shared", "-I.", "asperity_fmu.c"]
    command += ["-o", str(folder / f"{unit}{wanted.ending}"), *wanted.flags]
    if name == "linux64":  # in Windows the unit loads the library itself
        command += [f"-L{folder}", f"-l:{file}"]
    done = subprocess.run(command, cwd=sources, capture_output=True, text=True, check=False)
    if done.returncode != 0 or done.stderr:
        raise ImportError(f"{' '.join(compiler)} does not make the unit of its C source:\n{done.stderr}")


def _compiler(name: str) -> list[str]:
    """CC for this machine, else the usual compiler, else that of the Python package ziglang."""
    wanted, own = PLATFORMS[name], name == native()
    named = os.environ.get("CC") if own else None
    command = named or (wanted.native_compiler if own else wanted.cross_compiler)
    if shutil.which(command) is not None:
        return [command]
    if named is None and importlib.util.find_spec("ziglang") is not None:
        return [sys.executable, "-m", "ziglang", "cc", "-target", wanted.zig]
    package = "gcc libc6-dev" if own else wanted.cross_package
    raise ImportError(
        f"making a unit for {name} needs a C compiler, and there is no {command}: "
        f"pip install ziglang, or on Debian apt-get install {package}"
    )
