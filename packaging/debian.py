"""Debian packages: packaging/debian laid into the commit's files, and Debian's own tools."""

import shutil

from sources import unpack_commit
from targets import WORK, read_targets, run, small_std_environment

# Debian's name of an architecture, and the target whose library its packages have.
ARCHITECTURES = {"amd64": "x86_64-linux-gnu", "arm64": "aarch64-linux-gnu"}


def build_debian(architecture, out, env):
    """Writes the packages for an architecture into `out` and returns them."""
    work = WORK / "debian"
    shutil.rmtree(work, ignore_errors=True)
    source = work / "asperity"
    unpack_commit(source)
    shutil.copytree(source / "packaging" / "debian", source / "debian")
    target = read_targets()[ARCHITECTURES[architecture]]
    env = env | small_std_environment()
    env |= {"CARGO_BUILD_TARGET": target.rust, "DEB_BUILD_OPTIONS": "noautodbgsym nocheck"}
    # -d: cargo may be of rustup, not of Debian.
    run("dpkg-buildpackage", "-b", "-uc", "-us", "-d", f"--host-arch={architecture}", cwd=source, env=env)
    return [shutil.move(file, out / file.name) for file in sorted(work.glob("*.deb"))]
