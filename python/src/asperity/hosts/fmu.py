"""A surface as a functional mock-up unit (FMI 2.0 or 3.0): description, C sources and binaries in one archive."""

from __future__ import annotations

import contextlib
import hashlib
import io
import json
import re
import shutil
import tempfile
import uuid
import zipfile
from pathlib import Path
from typing import Iterator, Mapping, Sequence

from ..model import Model
from ..params import Params
from ..tools import output
from .fmu_binaries import PLATFORMS, add_binaries, library_for
from .fmu_description import build_description, model_description

_PHYSICAL = {
    "composite_modulus": "E* [stress]",
    "effective_shear_modulus": "G* [stress]",
    "work_of_adhesion": "w [force/length]",
    "adhesion_range": "h [length]",
    "burgers_vector": "b [length]",
    "height_std": "sigma [length], standard deviation of summit heights",
    "summit_radius": "R [length], mean radius of curvature of the asperities",
    "asperity_count": "N, number of asperities",
    "radius_amplitude": "epsilon, growth of the radius with height",
    "radius_rate": "rho, how fast it grows",
    "slip_radius_1": "a_1/b",
    "slip_stress_1": "tau_1/G*",
    "slip_radius_2": "a_2/b",
    "slip_stress_2": "tau_2/G*",
    "pressure_coefficient": "kappa, the part of the strength that grows with pressure",
    "max_friction_coefficient": "cap on the friction coefficient",
}
_HEIGHTS = {
    "weibull": {"weibull_shape": "omega of the Weibull heights"},
    "johnson": {"skew": "of the summit heights", "kurtosis": "of the summit heights"},
}


# The C files of a unit beside the one with the functions of FMI: what they are in this package, and in the unit.
_SOURCES = {
    "fmu_unit.h": "asperity_unit.h",
    "fmu_microslip.h": "asperity_unit_microslip.h",
    "fmu_saved.h": "asperity_unit_saved.h",
    "fmu_dll.h": "asperity_dll.h",
}


def build(
    params: Params, file: Path, *, fmi: str, start_load: float, platforms: Sequence[str], libraries: Mapping[str, Path],
    microslip: bool = False,
) -> None:  # fmt: skip
    """Writes a unit with binaries for the platforms; `ImportError` names the compiler or library that is missing for one."""
    found = {platform: library_for(platform, libraries.get(platform)) for platform in platforms}
    with Model(params) as model:  # refuses what no unit could be initialised with
        model.friction_force_at_load(start_load)
    name = re.sub(r"\W", "_", file.stem, flags=re.ASCII)
    name = name if re.match(r"[A-Za-z_]", name) else f"_{name}"
    parameters = _parameters(params)
    surface = _surface(params, parameters, start_load, microslip)
    guid = f"{{{uuid.UUID(bytes=hashlib.sha256((fmi + name + surface).encode()).digest()[:16])}}}"
    surface += f"#define GUID {json.dumps(guid)}\n"
    with _named(file), tempfile.TemporaryDirectory(prefix="asperity-fmu-") as made:
        sources = Path(made, "sources")
        sources.mkdir()
        (sources / "surface.h").write_text(surface, encoding="utf-8")
        shutil.copy(Path(__file__).with_name(f"fmu{fmi[0]}.c"), sources / "asperity_fmu.c")
        for packed, inside in _SOURCES.items():
            shutil.copy(Path(__file__).with_name(packed), sources / inside)
        for header in ("asperity.h", "asperity_loads.h"):
            shutil.copy(_c_header(header), sources / header)
        for platform, library in found.items():
            folder = platform if fmi == "2.0" else PLATFORMS[platform].fmi3
            add_binaries(Path(made, "binaries", folder), platform, library, sources, name)
        if fmi == "3.0":
            (sources / "buildDescription.xml").write_text(build_description(name), encoding="utf-8")
        starts = {parameter: getattr(params, parameter) for parameter in parameters}
        description = model_description(fmi, name, guid, start_load, parameters, starts, microslip)
        Path(made, "modelDescription.xml").write_text(description, encoding="utf-8")
        packed_unit = io.BytesIO()
        with zipfile.ZipFile(packed_unit, "w", zipfile.ZIP_DEFLATED) as archive:
            for path in sorted(Path(made).rglob("*")):
                if path.is_file():
                    archive.write(path, path.relative_to(made))
    output.write(file, packed_unit.getvalue())


@contextlib.contextmanager
def _named(file: Path) -> Iterator[None]:
    """Errors of the files that the unit is made in, as where the disk is full, are those of the unit: no other is the caller's."""
    try:
        yield
    except OSError as error:
        says = f"cannot be made in the folder for temporary files, {tempfile.gettempdir()} ({error.strerror or error})"
        raise OSError(error.errno, says, str(file)) from None


def _parameters(params: Params) -> dict[str, str]:
    """The numbers that this surface reads, with what they mean."""
    parameters = _PHYSICAL | _HEIGHTS.get(params.height_distribution, {})
    if params.contact_law == "elastic-plastic":
        parameters["hardness"] = "H [stress]"
    return parameters


def _surface(params: Params, parameters: dict[str, str], start_load: float, microslip: bool) -> str:
    """A header with the surface file, which has all digits."""
    lines = ["/* The surface of this unit, the names of its parameters, and whether it has microslip. */"]
    lines += ["static const char *const PARAMETER_NAMES[] = {"]
    lines += [f'    "{name}",' for name in parameters]
    lines += ["};", f"enum {{ PARAMETER_COUNT = {len(parameters)} }};", f"#define START_LOAD {start_load.hex()}"]
    lines += [f"#define MICROSLIP {int(microslip)}", "", "static const char SURFACE[] ="]
    lines += [f"    {json.dumps(line)}" for line in params._as_text().splitlines(keepends=True)]
    return "\n".join([*lines, "    ;", ""])


def _c_header(name: str) -> Path:
    """In the package, or in the checkout whose sources these are."""
    packed = Path(__file__).parents[1] / name
    return packed if packed.exists() else Path(__file__).parents[4] / "include" / name
