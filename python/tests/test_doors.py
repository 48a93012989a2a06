"""A text has one meaning: what a solver's curve says is the median that `friction` prints, or the answer says by how much it is not.

The texts are those of the pages that are whole surfaces, each as it is and altered as users alter them.
"""

from __future__ import annotations

import re
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from asperity import Error, Model, Params
from asperity.__main__ import main
from asperity._library import find
from asperity.estimate import estimate

ROOT = Path(__file__).resolve().parents[2]
PAGES = sorted(ROOT.glob("docs/*.md")) + [ROOT / "README.md"]
# As it is, and with other parts or other numbers.
ALTERED = (
    ("", ""),
    (r"^measured = .*$", ""),
    (r"^measured = \[?\[(\S+), ([^\],]+).*$", r"measured = [[\1, \2], [10, 0.2]]"),
    (r"^nominal_area = .*$", "nominal_area = 3e-5"),
    (r"\A", 'interface_kind = "clean"\n'),
    (r"\A", "pressure_coefficient = 0.02\n"),
    (r'^process = .*$', "Rdq = 0.1"),
    (r"\A", "size_effect = 0.5\n"),
    (r"^measured = .*$", "slip_stress_1 = 0.02"),
    (r"^measured = .*$", 'interface = "MoS2 film in dry air"'),
    (r"^measured = .*$", 'interface = "steel/steel dry"'),
    (r"^measured = .*$", "pressure_coefficient = 0.4"),
)
# What a tool of Modelica does with a surface file: mu at the loads.
MODELICA = """
#include <asperity_modelica.h>
#include <stdio.h>

void ModelicaFormatError(const char *format, ...) { fputs(format, stderr); exit(1); }
void ModelicaFormatMessage(const char *format, ...) { (void)format; }
int main(int count, char **word)
{
    void *law = asperity_modelica_create(word[1], "");
    for (int i = 2; i < count; i++) printf("%.17g ", asperity_modelica_force(law, atof(word[i])) / atof(word[i]));
    asperity_modelica_free(law);
    return 0;
}
"""
_HEIGHTS = [2e-7 * z - 5e-9 * z * z for z in range(-6, 7)]
_GROUND = 'pair = "steel/steel"\nnominal_area = 1e-4\nmeasured = [[100, 0.16]]\n'
# What pages say of no whole surface: tables, a lay, waves, devices, specimens that were measured on another surface.
SURFACES = (
    f"{_GROUND}[roughness]\nheights_at_scores = {_HEIGHTS}\nslopes_at_scores = {[0.1] * 13}\n",
    f"{_GROUND}[roughness]\nSq = 4e-7\nSdq = 0.12\nSsk = -0.9\nSku = 4.6\n",
    f"{_GROUND}[roughness]\nRq = 4e-7\nRdq = 0.1\nlay = 5\n",
    f'waviness_height = 1e-6\nwaviness_width = 2e-3\nwaviness_shape = "ridges"\n{_GROUND}[roughness]\nprocess = "ground"\nRa = 4e-7\n',
    'pair = "Si/Si"\nnominal_area = 6e-11\nspecimens = 1\nmeasured = [[1e-5, 0.27]]\n[roughness]\nSq = 12e-9\nSdq = 0.2\n',
    f"{_GROUND}[measured_on]\nSq = 8e-7\nSdq = 0.15\nSsk = -0.5\nSku = 3.5\n[roughness]\nprocess = 'ground'\n",
    'pair = "Si/Si"\nnominal_area = 1e-8\nmeasured = [[1e-3, 0.3]]\n[measured_on]\nnominal_area = 3e-8\n[roughness]\nSq = 5e-9\nSdq = 0.05\n',
)


def texts() -> list[str]:
    found = []
    blocks = [block for page in PAGES for block in re.findall(r"```toml\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)]
    for block in (*blocks, *SURFACES):
        for old, new in ALTERED:
            text = re.sub(old, new, block, flags=re.MULTILINE)
            if "nominal_area" in text and "[vary]" not in text and text not in found:
                found.append(text)
    return found


@pytest.fixture(scope="module")
def modelica(tmp_path_factory: pytest.TempPathFactory, compile_c: Callable[..., None]) -> Path:
    folder = tmp_path_factory.mktemp("modelica")
    (folder / "main.c").write_text(MODELICA, encoding="utf-8")
    includes = ("-Iinclude", "-Ihosts/modelica/Asperity/Resources/Include", "-Itests/consumers/modelica")
    compile_c(*(f"-I{ROOT / one[2:]}" for one in includes), folder / "main.c", "-o", folder / "law", find(), "-lm")
    return folder / "law"


def doors(text: str, path: Path, loads: np.ndarray, modelica: Path) -> dict[str, np.ndarray]:
    path.write_text(text, encoding="utf-8")
    of_host = subprocess.run([modelica, path, *map(repr, loads.tolist())], check=True, capture_output=True, text=True).stdout
    made = {"from_text": Params.from_text(text), "from_toml": Params.from_toml(path), "written": Params.from_text(Params.from_text(text).to_text())}
    return {"Modelica": np.array(of_host.split(), float), **{name: np.asarray(Model(params).friction_at_load(loads)) for name, params in made.items()}}


def test_every_text_of_the_pages_means_the_same_through_all_doors(tmp_path: Path, modelica: Path) -> None:
    asked = 0
    for text in texts():
        area = float(re.findall(r"nominal_area = (\S+)", text)[0])
        loads = np.array([1e5, 1e6, 1e7]) * area
        try:
            found = estimate(text, loads)
        except Error:
            with pytest.raises(Error):
                Params.from_text(text)
            continue
        asked += 1
        for name, friction in doors(text, tmp_path / "surface.toml", loads, modelica).items():
            assert friction == pytest.approx(found.curve, rel=1e-5), (name, text)
        for load, value, curve in zip(loads, found.value, found.curve):
            says = f"a solver's curve has {curve:.3g} at {load:g} N".replace("e-0", "e-") in found.text
            assert says or curve == pytest.approx(value, rel=6e-3), text
    assert asked >= 50


@pytest.mark.filterwarnings("ignore::asperity.ValidityWarning")
@pytest.mark.parametrize("kappa", [None, 0.02, 0.1, 0.24])
def test_a_strength_that_nobody_measured_has_one_band(kappa: float | None) -> None:
    """A text, the parameters that it makes, their text and their curve: what a given pressure coefficient makes is known in all of them."""
    given = "" if kappa is None else f"pressure_coefficient = {kappa}\n"
    known = "model_error = 0\n[known_to]\nslope = 1\nhardness = 1\nwork_of_adhesion = 1\n"
    text = f'{given}pair = "Si/Si"\nnominal_area = 1e-6\nwork_of_adhesion = 0\ncontact_law = "maugis"\nsize_effect = 1\n[roughness]\nSq = 5e-9\nSdq = 0.08\n'
    load, params = np.array([1.0, 100.0]), Params.from_text(text)
    curve = Model(params).curve(load)
    assert curve.low is not None and curve.high is not None
    written = estimate(known.replace("[", params.to_text() + "[", 1), load)
    assert written.low == pytest.approx(curve.low, rel=2e-3) and written.high == pytest.approx(curve.high, rel=2e-3)
    asked = estimate(known.replace("[", text + "[", 1), load)
    # What is not given may also be by pressure.
    near = 0.06 if kappa is None else 2e-3
    assert asked.low == pytest.approx(curve.low, rel=near) and asked.high == pytest.approx(curve.high, rel=near)
    assert kappa is None or (curve.low > 0.9 * kappa).all()


@pytest.mark.filterwarnings("ignore::asperity.ValidityWarning")
@pytest.mark.parametrize("text", [re.sub("measured.*\n", "", _GROUND) + '[roughness]\nprocess = "ground"\nRa = 0.8e-6\n', *SURFACES[:3], SURFACES[5]])
def test_exported_tables_have_it_too(tmp_path: Path, capsys: pytest.CaptureFixture[str], text: str) -> None:
    path = tmp_path / "surface.toml"
    path.write_text(text, encoding="utf-8")
    main(["export", str(path), "--format", "csv", "--range", "1e5:1e7"])
    pressure, mu = np.loadtxt(capsys.readouterr().out.splitlines(), delimiter=",", skiprows=1).T
    assert mu == pytest.approx(estimate(text, pressure * 1e-4).curve, rel=2e-3)
