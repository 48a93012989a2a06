"""Sources: the checkout with the crates that it needs, which builds without a network; and the crate for crates.io."""

import shutil
import tarfile
import time

from archives import pack_tar
from targets import WORK, run, version

CONFIG = """[source.crates-io]
replace-with = "vendored-sources"

[source.vendored-sources]
directory = "vendor"
"""


def unpack_commit(folder):
    """The files of the commit, with the date of now: with the commit's, cargo could take earlier builds for newer."""
    folder.mkdir(parents=True)
    archive = folder.with_suffix(".tar")
    run("git", "archive", "--format=tar", "-o", archive, "HEAD")
    with tarfile.open(archive) as tar:
        tar.extractall(folder, filter=lambda info, path: tarfile.data_filter(info, path).replace(mtime=time.time()))
    archive.unlink()


def build_source_archive(out, env):
    """asperity-VERSION-source.tar.xz."""
    folder = WORK / "source"
    shutil.rmtree(folder, ignore_errors=True)
    unpack_commit(folder)
    run("cargo", "vendor", "--locked", "--versioned-dirs", folder / "vendor", cwd=folder, env=env)
    (folder / ".cargo").mkdir()
    (folder / ".cargo" / "config.toml").write_text(CONFIG, encoding="utf-8")
    name = f"asperity-{version()}-source"
    pack_tar(folder, out / f"{name}.tar.xz", int(env["SOURCE_DATE_EPOCH"]), name)
    return out / f"{name}.tar.xz"


def build_crate(out, env):
    """asperity-VERSION.crate, as `cargo publish` would upload it; built once from what is in it."""
    run("cargo", "package", "--locked", env=env)
    name = f"asperity-{version()}.crate"
    return shutil.copy2(WORK / "cargo" / "package" / name, out / name)
