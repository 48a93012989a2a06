"""
What macOS asks of a library before it runs it, read from the file: macos.py PREFIX. The install name must be one that -rpath
resolves, the system not later than 11, every page as the signature says, and all functions of the header exported. Apple's
processors run nothing without a signature, Intel's do.
"""

import hashlib
import re
import struct
import subprocess
import sys
from pathlib import Path

LC_ID_DYLIB, LC_CODE_SIGNATURE, LC_BUILD_VERSION = 0xD, 0x1D, 0x32
CODE_DIRECTORY = 0xFADE0C02
ARM64 = 0x0100000C


def commands(data):
    """Load commands of a 64-bit Mach-O file: their numbers and bytes."""
    magic, count = struct.unpack_from("<I12xI", data)
    assert magic == 0xFEEDFACF, "no 64-bit Mach-O file"
    at = 32
    for _ in range(count):
        number, size = struct.unpack_from("<II", data, at)
        yield number & 0x7FFFFFFF, data[at : at + size]
        at += size


def check_signature(data, command):
    """Every page has the hash that the signature's code directory has for it."""
    start, size = struct.unpack_from("<II", command, 8)
    assert start + size == len(data), "bytes after the signature"
    count = struct.unpack_from(">I", data, start + 8)[0]
    places = [struct.unpack_from(">I", data, start + 16 + 8 * i)[0] for i in range(count)]
    (directory,) = (start + p for p in places if struct.unpack_from(">I", data, start + p)[0] == CODE_DIRECTORY)
    hashes, _, _, pages, limit = struct.unpack_from(">5I", data, directory + 16)
    hash_size, kind, _, log_page = struct.unpack_from(">BBBB", data, directory + 36)
    assert limit == start, "the signature covers another length"
    assert (hash_size, kind) == (32, 2), "the hashes are not SHA-256"
    assert pages == -(-limit >> log_page), "wrong number of pages"
    for page in range(pages):
        part = data[page << log_page : min((page + 1) << log_page, limit)]
        signed = data[directory + hashes + 32 * page : directory + hashes + 32 * (page + 1)]
        assert hashlib.sha256(part).digest() == signed, f"page {page} was changed after signing"
    return pages


def main(prefix):
    library = prefix / "lib" / "libasperity.dylib"
    data = library.read_bytes()
    found = dict(commands(data))
    name = found[LC_ID_DYLIB][24:].rstrip(b"\0").decode()
    assert re.fullmatch(r"@rpath/libasperity\.\d+\.dylib", name), f"install name {name}"
    assert (prefix / "lib" / name.removeprefix("@rpath/")).is_file(), f"{name} is not there"
    oldest = struct.unpack_from("<I", found[LC_BUILD_VERSION], 12)[0]
    assert oldest <= 11 << 16, f"needs macOS {oldest >> 16}"
    signed = "not signed"
    if LC_CODE_SIGNATURE in found:
        signed = f"{check_signature(data, found[LC_CODE_SIGNATURE])} signed pages"
    assert LC_CODE_SIGNATURE in found or struct.unpack_from("<I", data, 4)[0] != ARM64, "no signature"
    declared = set(re.findall(r"\b(asperity_\w+)\(", (prefix / "include" / "asperity.h").read_text(encoding="utf-8")))
    listed = subprocess.run(["llvm-nm", "-gU", library], capture_output=True, text=True, check=True).stdout
    exported = {line.split()[-1].removeprefix("_") for line in listed.splitlines()}
    # zig's linker exports three names of Rust's standard library as well.
    assert declared <= exported, f"not exported: {sorted(declared - exported)}"
    print(f"{name}, for macOS 11, {len(declared)} functions, {signed}; not run")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
