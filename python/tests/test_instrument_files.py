"""Files of instruments: what was written is read, in metres; what cannot be read is said."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

from asperity import surface

Array = npt.NDArray[np.float64]

# Rows along y: 3 of them, 2 um apart; 4 columns, 0.5 um apart. Heights in units of 0.1 nm.
COUNTS = np.array([[1, 2, 3, 4], [10, 20, 30, 40], [-5, 0, 5, 7]])


def sdf(path: Path, last: str = "7") -> Path:
    """An ISO 25178-71 file, written by hand after the standard: lengths in metres, profile after profile."""
    header = {
        "ManufacID": "asperity", "CreateDate": "010120250000", "ModDate": "010120250000", "NumPoints": 4,
        "NumProfiles": 3, "Xscale": "5.0E-7", "Yscale": "2.0E-6", "Zscale": "1.0E-10", "Zresolution": -1,
        "Compression": 0, "DataType": 7, "CheckType": 0,
    }  # fmt: skip
    rows = [" ".join(map(str, row)) for row in COUNTS]
    rows[-1] = rows[-1].rsplit(" ", 1)[0] + " " + last
    lines = ["aISO-1.0", *(f"{key} = {value}" for key, value in header.items()), "*", *rows, "*", "", "*"]
    path.write_text("\r\n".join(lines) + "\r\n", encoding="ascii")
    return path


@pytest.fixture(scope="module")
def synthetic() -> Any:
    """A self-affine surface that SurfaceTopography made; its first axis is x."""
    import warnings

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ImportWarning)
        from SurfaceTopography.Generation import fourier_synthesis
    return fourier_synthesis(
        (192, 96), (3.0, 3.0), hurst=0.8, rms_height=2e-3, short_cutoff=0.2, long_cutoff=1.0, unit="µm", rng=7
    )


def test_an_iso_file_has_its_heights_and_distances_in_metres(tmp_path: Path) -> None:
    heights, dx, dy = surface.read(sdf(tmp_path / "map.sdf"))
    np.testing.assert_allclose(heights, 1e-10 * COUNTS, rtol=1e-12)
    assert (dx, dy) == pytest.approx((5e-7, 2e-6), rel=1e-12)


@pytest.mark.parametrize("writer", ["x3p", "gwy", "netcdf"])
def test_summits_of_a_file_are_those_of_its_surface(tmp_path: Path, synthetic: Any, writer: str) -> None:
    file = tmp_path / f"map.{writer}"
    getattr(synthetic, f"to_{writer}")(str(file))
    measured = surface.read(file)
    assert measured.height_map.shape == (96, 192)
    assert (measured.dx, measured.dy) == pytest.approx((3e-6 / 192, 3e-6 / 96), rel=1e-9)
    summits = surface.summits(*measured)
    direct = surface.summits(1e-6 * synthetic.heights().T, 3e-6 / 192, 3e-6 / 96)
    assert summits.count == direct.count > 50
    assert summits.radius.value == pytest.approx(direct.radius.value, rel=1e-6)
    # SurfaceTopography's own figure of the same surface.
    assert summits.iso.Sdq == pytest.approx(synthetic.rms_gradient(), rel=0.02)


def test_points_not_measured_are_nan_and_summits_names_them(tmp_path: Path) -> None:
    measured = surface.read(sdf(tmp_path / "map.sdf", last="BAD"))
    assert np.isnan(measured.height_map[2, 3]) and np.isfinite(measured.height_map).sum() == 11
    with pytest.raises(ValueError, match=r"1 of 12 heights are masked or not finite, the first is nan at \[2, 3\]"):
        surface.summits(*measured)


def test_what_a_text_file_does_not_say_must_be_given(tmp_path: Path) -> None:
    file = tmp_path / "map.txt"
    np.savetxt(file, COUNTS)
    with pytest.raises(ValueError, match="the file names no unit of length: give unit='nm'"):
        surface.read(file)
    with pytest.raises(ValueError, match="the file has no size: give physical_sizes="):
        surface.read(file, unit="nm")
    for sizes in ((1.0,), (1.0, -1.0), (1.0, np.nan)):
        with pytest.raises(ValueError, match="physical_sizes = .*: must be two finite numbers > 0"):
            surface.read(file, unit="nm", physical_sizes=sizes)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="Unknown unit 'furlong'"):
        surface.read(file, unit="furlong", physical_sizes=(1.0, 1.0))
    heights, dx, dy = surface.read(file, unit="nm", physical_sizes=(2000.0, 6000.0))
    np.testing.assert_allclose(heights, 1e-9 * COUNTS, rtol=1e-12)
    assert (dx, dy) == pytest.approx((5e-7, 2e-6), rel=1e-12)


@pytest.mark.parametrize("given", [{"unit": "nm"}, {"physical_sizes": (1.0, 1.0)}])
def test_what_the_file_says_cannot_be_given_too(tmp_path: Path, given: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match=r"map\.sdf: .*already fixed"):
        surface.read(sdf(tmp_path / "map.sdf"), **given)


def test_channels_are_chosen_by_number_or_name(tmp_path: Path) -> None:
    file = sdf(tmp_path / "map.sdf")
    assert np.array_equal(surface.read(file, channel=0).height_map, surface.read(file, channel="Default").height_map)
    with pytest.raises(ValueError, match=r"channel = 'Phase': must be one of 0 'Default'"):
        surface.read(file, channel="Phase")


def test_what_holds_no_map_is_refused(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="nowhere"):
        surface.read(tmp_path / "nowhere.x3p")
    with pytest.raises(IsADirectoryError):
        surface.read(tmp_path)
    (tmp_path / "noise").write_bytes(bytes(range(256)))
    with pytest.raises(ValueError, match="noise: no format that SurfaceTopography knows"):
        surface.read(tmp_path / "noise")
    np.savetxt(tmp_path / "table.csv", np.zeros((20, 20)), delimiter=",")
    with pytest.raises(ValueError, match=r"table.csv: no format .* numpy.loadtxt\(file, delimiter=','\)"):
        surface.read(tmp_path / "table.csv")
    np.savetxt(tmp_path / "profile.xyz", np.stack([np.arange(20), np.arange(20) % 3], axis=1))
    with pytest.raises(ValueError, match="is a profile: must be a map"):
        surface.read(tmp_path / "profile.xyz", unit="nm")


def test_without_surfacetopography_it_says_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "SurfaceTopography", None)
    with pytest.raises(ImportError, match=r"needs SurfaceTopography .*pip install 'asperity\[topography\]'"):
        surface.read(sdf(tmp_path / "map.sdf"))
