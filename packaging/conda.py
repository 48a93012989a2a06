"""
Conda packages of the C library, `libasperity`: the files of a stage with the metadata that conda installs by. The format is
that of CEP PR 3, "package format 2": a zip archive of two tar archives.
"""

import hashlib
import json
import shutil
import zipfile

from archives import pack_tar, sorted_files
from targets import WORK, run, version

# The oldest systems on which the libraries run, as conda's virtual packages.
SYSTEMS = {"linux": ["__glibc >=2.17,<3.0.a0"], "osx": ["__osx >=11.0"], "win": ["__win"]}
PROCESSORS = {"64": "x86_64", "aarch64": "aarch64", "arm64": "arm64"}


def build_string(target):
    """The platform, so that the files of all of them have names of their own."""
    return f"{target.conda.replace('-', '_')}_0"


def index(target, epoch):
    """index.json: what a solver of dependencies reads."""
    system, processor = target.conda.split("-")
    return {
        "name": "libasperity",
        "version": version(),
        "build": build_string(target),
        "build_number": 0,
        "depends": SYSTEMS[system],
        "license": "MIT OR Apache-2.0",
        "platform": system,
        "arch": PROCESSORS[processor],
        "subdir": target.conda,
        "timestamp": epoch * 1000,
    }


def paths(payload):
    """paths.json: every file with its sum."""
    described = [
        {
            "_path": file.relative_to(payload).as_posix(),
            "path_type": "softlink" if file.is_symlink() else "hardlink",
            "sha256": hashlib.sha256(file.read_bytes()).hexdigest(),
            "size_in_bytes": file.stat().st_size,
        }
        for file in sorted_files(payload)
    ]
    return {"paths": described, "paths_version": 1}


def write_json(file, data):
    """In the same bytes every time."""
    file.write_text(json.dumps(data, indent=2, sort_keys=True) + "\n", encoding="utf-8")


def build_conda(target, stage, out, env):
    """Writes the package for a target into `out` and returns it."""
    epoch = int(env["SOURCE_DATE_EPOCH"])
    work = WORK / f"conda-{target.name}"
    shutil.rmtree(work, ignore_errors=True)
    payload = work / "payload"
    # On Windows conda has what other systems have at the top of an environment in this folder.
    shutil.copytree(stage, payload / "Library" if target.conda.startswith("win") else payload, symlinks=True)
    for readme in payload.rglob("README.md"):
        readme.unlink()  # the top belongs to all packages

    info = work / "info" / "info"
    shutil.copytree(stage / "share" / "licenses" / "asperity", info / "licenses")
    write_json(info / "index.json", index(target, epoch))
    write_json(info / "paths.json", paths(payload))
    write_json(info / "about.json", {"license": "MIT OR Apache-2.0", "summary": "Friction laws from contact physics"})
    (info / "files").write_text("".join(f"{path['_path']}\n" for path in paths(payload)["paths"]), encoding="utf-8")

    name = f"libasperity-{version()}-{build_string(target)}"
    package = out / f"{name}.conda"
    with zipfile.ZipFile(package, "w", zipfile.ZIP_STORED) as packed:
        packed.writestr(zipfile.ZipInfo("metadata.json"), json.dumps({"conda_pkg_format_version": 2}))
        for part, folder in (("info", work / "info"), ("pkg", payload)):
            pack_tar(folder, work / f"{part}.tar", epoch, "")
            run("zstd", "-q", "-19", "--single-thread", work / f"{part}.tar")
            packed.writestr(zipfile.ZipInfo(f"{part}-{name}.tar.zst"), (work / f"{part}.tar.zst").read_bytes())
    return package
