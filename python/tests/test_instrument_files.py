"""Files of instruments: what was written is read, in metres; what cannot be read is said."""

from __future__ import annotations

import re
import sys
import zipfile
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
            surface.read(file, unit="nm", physical_sizes=sizes)
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
    (tmp_path / "empty").touch()
    with pytest.raises(ValueError, match="empty: is empty"):
        surface.read(tmp_path / "empty")
    line = np.stack([np.arange(20), np.arange(20) % 3], axis=1)
    np.savetxt(tmp_path / "profile.xyz", line)
    z = line[:, 1] - np.polyval(np.polyfit(line[:, 0], line[:, 1], 1), line[:, 0])
    slope = np.sqrt(np.mean(np.diff(z) ** 2))
    with pytest.raises(ValueError, match=rf"is a profile: .*Params.from_profile\(Rq={1e-9 * z.std():.4g}, Rdq={slope:.4g},"):
        surface.read(tmp_path / "profile.xyz", unit="nm")


# ---- Text ----

NM: dict[str, Any] = dict(unit="nm", physical_sizes=(40.0, 30.0))


def heights(sep: str = " ") -> tuple[Array, str]:
    """Six decimals of 30 rows and 40 columns."""
    z = np.round(np.random.default_rng(0).normal(size=(30, 40)), 6)
    return z, "\n".join(sep.join(f"{one:.6f}" for one in row) for row in z) + "\n"


@pytest.mark.parametrize("sep", [" ", "\t", ";", ","])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "latin-1"])
def test_text_is_read_however_it_is_written(tmp_path: Path, sep: str, encoding: str) -> None:
    z, text = heights(sep)
    if sep != ",":
        text = text.replace(".", ",")
    (tmp_path / "map.txt").write_bytes(("# Größe\n" + text).encode(encoding))
    found = surface.read(tmp_path / "map.txt", **NM)
    np.testing.assert_allclose(found.height_map, 1e-9 * z, rtol=1e-12)
    assert (found.dx, found.dy) == pytest.approx((1e-9, 1e-9)) and found.channels == ("Default",)


@pytest.mark.parametrize("word", ["---", "--", "N/A", "null", "***", "BAD", "nan", "missing"])
@pytest.mark.parametrize("sep", [" ", ";"])
def test_what_stands_for_a_missing_point_takes_no_row_away(tmp_path: Path, word: str, sep: str) -> None:
    z, text = heights(sep)
    (tmp_path / "map.txt").write_text(text.replace(f"{z[3, 4]:.6f}", word), encoding="utf-8")
    found = surface.read(tmp_path / "map.txt", **NM)
    assert found.height_map.shape == (30, 40) and np.isnan(found.height_map).sum() == 1 and np.isnan(found.height_map[3, 4])


def test_three_columns_are_points_of_which_some_may_be_missing(tmp_path: Path) -> None:
    z, _ = heights()
    y, x = np.mgrid[:30, :40]
    points = np.stack([0.1 * x.ravel(), 0.2 * y.ravel(), z.ravel()], axis=1)
    np.savetxt(tmp_path / "whole.xyz", points)
    np.savetxt(tmp_path / "fewer.xyz", np.random.default_rng(0).permutation(np.delete(points, 501, 0)))
    for name, missing in (("whole", 0), ("fewer", 1)):
        found = surface.read(tmp_path / f"{name}.xyz", unit="µm")
        assert (found.dx, found.dy) == pytest.approx((1e-7, 2e-7)) and np.isnan(found.height_map).sum() == missing
        np.testing.assert_allclose(found.height_map[0], 1e-6 * z[0], rtol=1e-9)
    with pytest.raises(ValueError, match="fewer.xyz: three columns are x, y and z of points, and the file names no unit"):
        surface.read(tmp_path / "fewer.xyz")
    np.savetxt(tmp_path / "off.xyz", points + 0.03 * np.random.default_rng(0).normal(size=points.shape))
    with pytest.raises(ValueError, match="off.xyz: its points x, y, z are not on a grid: interpolate them"):
        surface.read(tmp_path / "off.xyz", unit="nm")


# ---- Measured files, and damaged ones ----

CORPUS = Path(__file__).with_name("maps")


@pytest.mark.parametrize(
    "name, given, shape, step, rms, square_slope",
    [
        ("top-1.top.gz", {}, (256, 256), 2.34375e-9, 3.1530986e-9, 1.37799796e-2),
        ("matrix-4.txt.gz", {}, (305, 75), 3.69862e-7, 1.17458915e-7, 2.30627953e-3),
        ("sdf-1.sdf", {}, (4, 7), 1e-6, 1.36028973e-8, 1.42405927e-4),
        ("nc-1.nc", {}, (10, 5), 1e-9, 5.74456265e-9, 2.0),
        ("xyz-2.txt", {"unit": "nm"}, (4, 4), 1e-9, 4.948717e-10, 0.1875),
    ],
)
def test_measured_maps_are_as_they_were(
    name: str, given: dict[str, Any], shape: tuple[int, int], step: float, rms: float, square_slope: float
) -> None:
    found = surface.read(CORPUS / name, **given)
    z = found.height_map
    assert z.shape == shape and (found.dx, found.dy) == pytest.approx((step, step), rel=1e-9)
    slopes = [np.nanmean((np.diff(z, axis=axis) / step) ** 2) for axis in (0, 1)]
    assert (np.nanstd(z), np.mean(slopes)) == pytest.approx((rms, square_slope), rel=1e-6)


def test_a_damaged_file_is_said_to_be(tmp_path: Path) -> None:
    whole = (CORPUS / "top-1.top.gz").read_bytes()
    (tmp_path / "map.top.gz").write_bytes(whole[:5000])
    with pytest.raises(ValueError, match="map.top.gz: damaged gzip file .*: copy it again"):
        surface.read(tmp_path / "map.top.gz")
    import gzip

    (tmp_path / "map.top").write_bytes(gzip.decompress(whole)[:20000])
    with pytest.raises(ValueError, match="map.top: "):
        surface.read(tmp_path / "map.top")
    # Of Gwyddion's format, whole but without an image.
    (tmp_path / "map.gwy").write_bytes(b"GWYPGwyContainer\0" + (17).to_bytes(4, "little") + b"/0/title\0s" + b"nothin\0")
    with pytest.raises(ValueError, match="map.gwy: holds no channel with data"):
        surface.read(tmp_path / "map.gwy")


def test_one_of_several_maps_must_be_chosen(tmp_path: Path) -> None:
    for name in ("Height trace", "Height retrace", "Phase"):
        header = f"Channel: {name}\nWidth: 2 µm\nHeight: 6 µm\nValue units: µm"
        np.savetxt(tmp_path / "one", 1e-3 * COUNTS, header=header, encoding="utf-8")
        with open(tmp_path / "map.txt", "a", encoding="utf-8") as file:
            file.write((tmp_path / "one").read_text(encoding="utf-8"))
    with pytest.raises(ValueError, match=r"has 2 maps of heights: give channel = one of 0 'Height trace', 1 'Height retrace'"):
        surface.read(tmp_path / "map.txt")
    found = surface.read(tmp_path / "map.txt", channel=1)
    assert (found.channel, found.channels) == ("Height retrace", ("Height trace", "Height retrace", "Phase"))


def test_sizes_that_no_map_has_are_refused_and_may_be_given(tmp_path: Path) -> None:
    text = sdf(tmp_path / "map.sdf").read_text(encoding="ascii")
    for old, new, says in (
        ("Xscale = 5.0E-7", "Xscale = 0.3125", r"the map is 1.25 m long along x, as no map is: give physical_sizes"),
        ("Zscale = 1.0E-10", "Zscale = 0.1", r"heights range over 4.5 m, as those of no map: the unit is wrong"),
        ("Zscale = 1.0E-10", "Zscale = 1.0E-5", r"slopes are 1.3e.02, as those of no map: a unit is wrong"),
    ):
        (tmp_path / "bad.sdf").write_text(text.replace(old, new), encoding="ascii", newline="")
        with pytest.raises(ValueError, match=f"bad.sdf: {says}"):
            surface.read(tmp_path / "bad.sdf")
    (tmp_path / "bad.sdf").write_text(text.replace("Xscale = 5.0E-7", "Xscale = 0.3125"), encoding="ascii", newline="")
    found = surface.read(tmp_path / "bad.sdf", physical_sizes=(2e-6, 6e-6))
    assert (found.dx, found.dy) == pytest.approx((5e-7, 2e-6))


def test_without_surfacetopography_it_says_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "SurfaceTopography", None)
    with pytest.raises(ImportError, match=r"needs SurfaceTopography .*pip install SurfaceTopography"):
        surface.read(sdf(tmp_path / "map.sdf"))


# ---- What a file says beside its heights ----


@pytest.mark.parametrize("says", ["NODATA_value -9999", "# No data: -9999", "missing value = -9999.0"])
def test_a_number_that_the_header_says_is_no_height_is_none(tmp_path: Path, says: str) -> None:
    z, _ = heights()
    z[4:9, 7:10] = -9999
    file = tmp_path / "grid.asc"
    file.write_text(f"ncols 40\nnrows 30\n{says}\n" + "\n".join(" ".join(map(str, row)) for row in z), encoding="utf-8")
    found = surface.read(file, **NM).height_map
    assert np.array_equal(np.isnan(found), z == -9999) and np.nanmax(np.abs(found)) < 1e-8


@pytest.mark.parametrize("header", [True, False, "places"])
@pytest.mark.parametrize("index", [True, False])
def test_numbers_of_rows_and_columns_are_no_heights(tmp_path: Path, header: Any, index: bool) -> None:
    pandas = pytest.importorskip("pandas")
    z, _ = heights()
    frame = pandas.DataFrame(z, columns=np.round(np.arange(40) / 3, 3) if header == "places" else None)
    frame.to_csv(tmp_path / "map.csv", header=bool(header), index=index)
    np.testing.assert_allclose(surface.read(tmp_path / "map.csv", **NM).height_map, 1e-9 * z, rtol=1e-9)


def test_a_header_may_have_decimal_commas_where_the_heights_have_points(tmp_path: Path) -> None:
    z, text = heights()
    file = tmp_path / "map.txt"
    file.write_text(f"# Channel: Topography\n# Width: 6,000 µm\n# Height: 4,500 µm\n# Value units: nm\n{text}", encoding="utf-8")
    found, dx, dy = surface.read(file)
    np.testing.assert_allclose(found, 1e-9 * z, rtol=1e-9)
    assert (dx, dy) == pytest.approx((0.15e-6, 0.15e-6))


def test_axes_may_have_units_of_their_own(tmp_path: Path) -> None:
    z, text = heights()
    y, x = np.mgrid[:30, :40] * 0.01
    points = np.column_stack([x.ravel(), y.ravel(), 1e-3 * z.ravel()])
    np.savetxt(tmp_path / "named.txt", points, header="x [mm] y [mm] z [µm]", encoding="utf-8")
    np.savetxt(tmp_path / "points.txt", points)
    (tmp_path / "rows.txt").write_text(text, encoding="utf-8")
    for found in (
        surface.read(tmp_path / "named.txt"),
        surface.read(tmp_path / "points.txt", unit=("mm", "µm")),
        surface.read(tmp_path / "rows.txt", unit=("mm", "nm"), physical_sizes=(0.4, 0.3)),
    ):
        np.testing.assert_allclose(found.height_map, 1e-9 * z, rtol=1e-9)
        assert (found.dx, found.dy) == pytest.approx((1e-5, 1e-5))


BY_INDEX: dict[str, tuple[tuple[str, str], str]] = {
    "dash": (("ISO5436 - 2000", "ISO5436 – 2000"), "Revision should be 'ISO5436 - 2000'.*its Revision is 'ISO5436 – 2000'"),
    "kind": (("<FeatureType>SUR", "<FeatureType>PCL"), "FeatureType should be 'SUR'.*its FeatureType is 'PCL'"),
    "inline": (("<DataLink>.*</DataLink>", "<DataList><Datum>1</Datum></DataList>"), "its heights are in the index itself"),
    "cloud": (("<MatrixDimension>.*</MatrixDimension>", "<ListDimension>9</ListDimension>"), "it is a cloud of points"),
    "axis": (("<AxisType>I", "<AxisType>A"), "CX AxisType is not 'I'"),
    "folder": (("", ""), "its index is scan/main.xml, in a folder, .*: pack the contents of the folder"),
}


@pytest.mark.parametrize("case", BY_INDEX)
def test_an_x3p_that_is_not_read_says_why(tmp_path: Path, synthetic: Any, case: str) -> None:
    (pattern, new), words = BY_INDEX[case]
    synthetic.to_x3p(str(tmp_path / "right.x3p"))
    with zipfile.ZipFile(tmp_path / "right.x3p") as right, zipfile.ZipFile(tmp_path / "map.x3p", "w") as wrong:
        for name in right.namelist():
            content = right.read(name)
            if name == "main.xml" and pattern:
                content = re.sub(pattern, new, content.decode(), flags=re.DOTALL).encode()
            wrong.writestr(f"scan/{name}" if case == "folder" else name, content)
    with pytest.raises(ValueError, match=f"map.x3p: an X3P that SurfaceTopography does not read: .*{words}") as raised:
        surface.read(tmp_path / "map.x3p")
    assert "export it as X3P" not in str(raised.value)
