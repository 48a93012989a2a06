"""Debian packages: packaging/debian laid into the commit's files, and Debian's own tools."""

import shutil

from sources import unpack_commit
from targets import WORK, linker_environment, read_targets, run, small_std_environment


def build_debian(out, env):
    """Writes the packages for amd64 into `out` and returns them."""
    work = WORK / "debian"
    shutil.rmtree(work, ignore_errors=True)
    source = work / "asperity"
    unpack_commit(source)
    shutil.copytree(source / "packaging" / "debian", source / "debian")  # with the date of the commit
    target = read_targets()["x86_64-linux-gnu"]
    env = env | linker_environment(target) | small_std_environment()
    env |= {"CARGO_BUILD_TARGET": target.rust, "DEB_BUILD_OPTIONS": "noautodbgsym"}
    # -d: cargo may be of rustup, not of Debian.
    run("dpkg-buildpackage", "-b", "-uc", "-us", "-d", cwd=source, env=env)
    return [shutil.move(file, out / file.name) for file in sorted(work.glob("*.deb"))]
