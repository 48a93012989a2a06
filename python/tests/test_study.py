"""Studies: what the dataset has, against models made one by one, and Sobol' indices against closed forms and SciPy's."""

from __future__ import annotations

import math
import sys
from pathlib import Path
from typing import Any
from unittest import mock

import numpy as np
import pytest
import xarray
from scipy import stats
from study_workers import LOADS, PARAMS, SMALL

from asperity import Error, Model, Status, Warnings, __version__
from asperity.study import plot_sobol_indices, sobol_indices, study


@pytest.fixture(scope="module")
def small() -> xarray.Dataset:
    return study(PARAMS, **SMALL)


def test_each_surface_is_that_of_a_model_of_its_own(small: xarray.Dataset) -> None:
    kept = np.flatnonzero(small["status"].values == 0)
    assert kept.size > 10
    for i in kept[:: kept.size // 5]:
        stress = float(small["slip_stress"][i])
        params = PARAMS.replace(
            height_std=float(small["height_std"][i]),
            radius_amplitude=float(small["radius_amplitude"][i]),
            slip_stress_1=stress,
            slip_stress_2=stress / PARAMS.slip_stress_1 * PARAMS.slip_stress_2,
        )
        with Model(params) as model:
            assert np.array_equal(small["friction_coefficient"][i], model.friction_at_load(LOADS))
            assert np.array_equal(small["friction_force"][i], model.friction_force_at_load(LOADS))
            assert np.array_equal(small["tangential_stiffness"][i], model.tangential_stiffness_at_load(LOADS))
            assert np.array_equal(small["warnings"][i], model.state_at_load(LOADS).warning_bits)


def test_refused_surfaces_are_counted_and_stay_nan_with_the_reason(small: xarray.Dataset) -> None:
    refused = small["status"].values != 0
    assert 0 < refused.sum() < refused.size and small.attrs["refused"] == refused.sum()
    outside = np.abs(small["radius_amplitude"].values) > 1
    assert outside.any() and refused[outside].all()  # drawn, and kept as drawn
    for i in np.flatnonzero(refused):
        assert small["status"][i] == Status.INVALID_PARAMETER
        assert f"radius_amplitude = {float(small['radius_amplitude'][i])}" in str(small["reason"][i].values)
        assert np.isnan(small["friction_force"][i]).all()
    assert np.isfinite(small["friction_force"].values[~refused]).all()
    assert set(small["reason"].values[~refused]) == {""}


def test_a_load_that_is_too_heavy_is_nan_alone() -> None:
    loads = [1.0, 1e200, 2.0]
    found = study(PARAMS, {"height_std": [10.0, 11.0]}, loads, progress=False)
    assert np.isnan(found["friction_force"].values).tolist() == [[False, True, False]] * 2
    assert (found["status"] != 0).all() and "load = 1e200" in str(found["reason"][0].values)


def test_a_bug_of_the_library_is_no_verdict_on_a_surface() -> None:
    with mock.patch("asperity.fits.many_surfaces.Handle", side_effect=Error("a bug", Status.INTERNAL)):
        with pytest.raises(Error, match="^a bug$"):
            study(PARAMS, **SMALL)


def test_below_pull_off_friction_is_zero_and_there_is_nothing_to_warn_of() -> None:
    found = study(PARAMS, {"height_std": [10.0]}, [-1e6, 1.0], progress=False)
    assert found["friction_force"].values[0, 0] == 0 and found["friction_force"].values[0, 1] > 0
    assert found["warnings"].values[0, 0] == 0 and found.attrs["refused"] == 0


def test_the_dataset_says_what_it_is(small: xarray.Dataset) -> None:
    assert dict(small.sizes) == {"sample": 32, "load": 4}
    assert small.attrs["asperity_version"] == __version__ and small.attrs["seed"] == 5
    assert small.attrs["params"] == repr(PARAMS) and "height_std: log-normal about 10.0" in small.attrs["vary"]
    units = {name: small[name].attrs.get("units") for name in ("load", "friction_force", "tangential_stiffness", "height_std")}
    assert units == {"load": "force", "friction_force": "force", "tangential_stiffness": "force/length", "height_std": "length"}
    flags = small["warnings"].attrs
    assert flags["flag_meanings"].split()[0] == "PLASTIC" and flags["flag_masks"].tolist() == [int(one) for one in Warnings]
    metric = study(PARAMS.replace(in_si=True), {"height_std": [10.0]}, [1.0], warnings=False, progress=False)
    assert metric["tangential_stiffness"].attrs["units"] == "N/m" and "warnings" not in metric


def test_progress_tells_part_rate_and_time_left() -> None:
    told: list[tuple[float, str]] = []
    study(PARAMS, **{**SMALL, "progress": lambda part, doing: told.append((part, doing))})
    assert told[0] == (0.0, "0 of 32 surfaces") and told[-1][0] == 1.0
    assert told[-1][1].startswith("32 of 32 surfaces, ") and told[-1][1].endswith("/s, 0:00:00 left")


def additive(**changes: Any) -> xarray.Dataset:
    """What a study would be if friction were x + 2 y + 0 z of independent standard normal parameters, with n = 256."""
    from asperity.studies.draws import _points

    n = 256
    unit = stats.norm.ppf(_points(6, n, 3, "sobol"))
    a, b = unit[:, :3], unit[:, 3:]
    sheets = [a, b, *(np.where(np.arange(3) == j, b, a) for j in range(3))]
    friction = np.concatenate([sheet @ [1.0, 2.0, 0.0] for sheet in sheets])[:, None] + 10.0
    attributes = {"sampling": "saltelli", "samples": n, "parameters": "x y z", "asperity_version": "", "seed": 3, "vary": ""}
    return xarray.Dataset(
        {"friction_coefficient": (("sample", "load"), friction)}, {"load": ("load", [1.0])}, {**attributes, **changes}
    )


def test_indices_of_an_additive_law_are_the_parts_of_the_variance() -> None:
    found = sobol_indices(additive())
    expected = np.array([1 / 5, 4 / 5, 0.0])
    assert np.allclose(found["first_order"][:, 0], expected, atol=0.03)
    assert np.allclose(found["total_order"][:, 0], expected, atol=0.03)
    assert (found["total_order_low"] <= found["total_order"]).all() and (found["total_order"] <= found["total_order_high"]).all()
    assert found["total_order"][2, 0] == 0 and found["rows"].values.tolist() == [256]


def test_indices_are_those_of_scipy() -> None:
    given = additive()
    sheets = given["friction_coefficient"].values.reshape(5, 1, 256)
    functions: Any = {"f_A": sheets[0], "f_B": sheets[1], "f_AB": sheets[2:]}
    theirs, ours = stats.sobol_indices(func=functions, n=256), sobol_indices(given)
    assert np.allclose(ours["first_order"].values[:, 0], theirs.first_order.ravel(), rtol=1e-10, atol=1e-12)
    assert np.allclose(ours["total_order"].values[:, 0], theirs.total_order.ravel(), rtol=1e-10, atol=1e-12)


def test_rows_with_a_refused_surface_are_left_out() -> None:
    given = additive()
    given["friction_coefficient"][[3, 256 + 7, 512 + 3]] = math.nan
    found = sobol_indices(given)
    assert found["rows"].values.tolist() == [254]
    assert np.allclose(found["total_order"][:, 0], [0.2, 0.8, 0], atol=0.03)
    given["friction_coefficient"][:250] = math.nan
    with pytest.raises(ValueError, match="only 6 of 256 rows are whole at the load 1; indices need 8 or more"):
        sobol_indices(given)


def test_indices_of_a_study_and_their_picture(tmp_path: Path) -> None:
    vary = {"asperity_count": 0.3, "slip_stress": 0.3, "hardness": stats.uniform(1.0, 1.0)}
    found = study(PARAMS, vary, [1e-2, 1.0], 16, sampling="saltelli", warnings=False, progress=False)
    assert found.sizes["sample"] == 16 * 5
    indices = sobol_indices(found, "friction_force")
    assert indices["parameter"].values.tolist() == list(vary)
    # The force is proportional to the strength; the hardness is read only by warnings.
    assert (indices["total_order"].sel(parameter="slip_stress") > 0.5).all()
    assert (indices["total_order"].sel(parameter="hardness") == 0).all()
    plot_sobol_indices(indices, tmp_path / "indices.svg")
    assert (tmp_path / "indices.svg").read_text(encoding="utf-8").startswith("<?xml")
    with pytest.raises(ValueError, match="need sampling=\"saltelli\""):
        sobol_indices(found.assign_attrs(sampling="sobol"))


@pytest.mark.parametrize("missing", ["xarray", "netCDF4", "scipy.stats"])
def test_a_missing_package_is_named_with_what_installs_it(missing: str) -> None:
    with mock.patch.dict(sys.modules, {missing: None}), pytest.raises(ImportError, match=r'pip install scipy xarray netCDF4$'):
        study(PARAMS, **SMALL)
