"""Installs a conda package by conda's rules into a new environment: conda_check.py PACKAGE.conda FOLDER."""

import asyncio
import os
import shutil
import sys
from pathlib import Path

from rattler import BuildString, GenericVirtualPackage, PackageName, Subdir, Version, install, solve
from rattler.index import index_fs

# What a conda on the oldest systems says of them.
SYSTEMS = {"linux": ("__glibc", "2.17"), "osx": ("__osx", "11.0"), "win": ("__win", "0")}


async def main(package, folder):
    shutil.rmtree(folder, ignore_errors=True)
    platform = package.stem.split("-")[-1].removesuffix("_0").replace("_", "-")
    for subdir in (platform, "noarch"):
        (folder / "channel" / subdir).mkdir(parents=True)
    shutil.copy2(package, folder / "channel" / platform)
    await index_fs(folder / "channel")
    name, version = SYSTEMS[platform.split("-")[0]]
    records = await solve(
        [(folder / "channel").as_uri()], ["libasperity"], platforms=[platform, "noarch"],
        virtual_packages=[GenericVirtualPackage(PackageName(name), Version(version), BuildString("0"))],
    )  # fmt: skip
    environment = folder / "environment"
    await install(records, environment, cache_dir=folder / "cache", platform=Subdir(platform), show_progress=False)
    top = environment / "Library" if platform.startswith("win") else environment
    for file in ("include/asperity.h", "lib/pkgconfig/asperity.pc", "lib/cmake/asperity/asperity-config.cmake"):
        assert (top / file).is_file(), f"{file} is not installed"
    print(f"solved and installed for {platform} with {name} {version}: {len(list(top.rglob('*.*')))} files")


if __name__ == "__main__":
    asyncio.run(main(Path(sys.argv[1]), Path(sys.argv[2]).resolve()))
    # Threads of py-rattler may outlive the interpreter, which then crashes at its end.
    sys.stdout.flush()
    os._exit(0)
