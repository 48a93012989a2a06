"""The notebooks run from top to bottom, and print what they should. They are kept without outputs: what they print is held
here, a picture of one version of matplotlib says nothing about another, and changes stay readable."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import nbformat
import pytest
from nbclient import NotebookClient

from asperity import friction

FOLDER = Path(__file__).resolve().parents[1] / "examples"
# In each notebook: numbers of pictures, and texts that it prints, in this order.
EXPECTED = {
    "first_number": (2, [r"^not measured: mu\(100000 Pa\) about 0\.33\d*, 0\.03\d* to 3\.\d*$", r"0\.063 J/m\^2: oxide skins", r"160\.0 GPa", r"^UNCALIBRATED: the strength of the interface"]),
    "map_to_solver": (1, [r"\(512, 512\) 1\.953e-08 m", r"0 missing and 0 spikes", r"recommended: ", r"^Sq 4\.7\d+e-09 \+- .* m, Sdq 0\.029\d+ \+- ", r"^UNCALIBRATED: ",
                          r"^\*FRICTION$", r"\(0\.\d+, -"]),
    "fit_with_uncertainty": (2, [r"work_of_adhesion = 0\.08\d* \+- 0\.01\d", r"height_std = 5\.2\d*e-09 \+- ",
                                 r"20\.0 N: "]),
}  # fmt: skip


def test_every_notebook_is_expected_here_and_kept_without_outputs() -> None:
    assert {file.stem for file in FOLDER.glob("*.ipynb")} == set(EXPECTED)
    for file in FOLDER.glob("*.ipynb"):
        for cell in nbformat.read(file, as_version=4).cells:  # type: ignore[no-untyped-call]
            assert cell.cell_type != "code" or (cell.outputs == [] and cell.execution_count is None), file.name


@pytest.mark.parametrize("name", EXPECTED)
def test_a_notebook_runs_and_prints_what_it_should(name: str) -> None:
    notebook: Any = nbformat.read(FOLDER / f"{name}.ipynb", as_version=4)  # type: ignore[no-untyped-call]
    NotebookClient(notebook, timeout=600, kernel_name="python3", resources={"metadata": {"path": str(FOLDER)}}).execute()
    outputs = [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]
    texts = [output["text"] if "text" in output else output["data"].get("text/plain", "") for output in outputs]
    pictures = sum("image/png" in output.get("data", {}) or "text/html" in output.get("data", {}) for output in outputs)
    count, expected = EXPECTED[name]
    printed = "\n".join(texts)
    assert pictures == count, printed
    place = 0
    for pattern in expected:
        found = re.compile(pattern, re.MULTILINE).search(printed, place)
        assert found, f"{pattern} is not in what follows:\n{printed[place:]}"
        place = found.end()
    # Nobody measured the strength of these interfaces, and they say so.
    printed = re.sub(r".*ValidityWarning: .*: (UNCALIBRATED|BROAD): .*", "", printed)
    assert "Warning" not in printed and "Error" not in printed, printed


@pytest.mark.filterwarnings("ignore:.*UNCALIBRATED", "ignore:.*BROAD")
def test_the_first_number_is_that_of_the_package() -> None:
    assert friction("Si/Si", Sq=5e-9, Sdq=0.05, load=1e5).value == pytest.approx(0.331, rel=0.02)
