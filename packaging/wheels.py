"""Wheels of the Python package, around the library of a stage: built by the package's own setup.py, compiled by nothing."""

import shutil

from targets import ROOT, VENV, WORK, demand_size, run

# What a wheel may weigh.
WHEEL_LIMIT = 1_010_000


def build_wheel(target, stage, out, env):
    """Writes the wheel for a target into `out` and returns it."""
    folder = WORK / f"wheel-{target.name}"
    shutil.rmtree(folder, ignore_errors=True)
    env = env | {
        "ASPERITY_PREBUILT": str(stage / target.shared),
        "ASPERITY_NOTICES": str(stage / "share" / "licenses" / "asperity"),
    }
    run(
        VENV / "bin" / "python", "-m", "build", "--wheel", "--no-isolation", "--outdir", folder,
        f"-C--build-option=--plat-name={target.wheel}", ROOT / "python", env=env,
    )  # fmt: skip
    (wheel,) = folder.glob(f"asperity-*-py3-none-{target.wheel}.whl")
    demand_size(wheel, WHEEL_LIMIT, target.name)
    return shutil.move(wheel, out / wheel.name)


def build_sdist(out, env):
    """The source distribution for PyPI, with one date for all of its files."""
    import tarfile

    from archives import pack_tar

    folder = WORK / "sdist"
    shutil.rmtree(folder, ignore_errors=True)
    run(VENV / "bin" / "python", "-m", "build", "--sdist", "--no-isolation", "--outdir", folder, ROOT / "python", env=env)
    (sdist,) = folder.glob("asperity-*.tar.gz")
    with tarfile.open(sdist) as tar:
        tar.extractall(folder / "unpacked", filter="data")
    pack_tar(folder / "unpacked", out / sdist.name, int(env["SOURCE_DATE_EPOCH"]), "")
    return out / sdist.name
