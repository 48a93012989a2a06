"""The numbers on the pages of hosts that the library decides, and the program that looks at all others, `hosts/page_numbers.py`."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from asperity import Model, Params

# Text of a page around the number that the library decides, and what is kept of a contact beside that of the library: held_pair of
# mujoco/microslip.h, and SUMMITS of lammps/law.h.
STATES = {"abaqus": (r"DEPVAR=(\d+)", 0), "lammps": (r"A contact has (\d+) numbers", 12), "mujoco": (r"State is (\d+) doubles", 10)}


@pytest.mark.parametrize("host", STATES)
def test_the_length_of_a_state_is_that_of_the_library(host: str, root: Path) -> None:
    pattern, beside = STATES[host]
    told = re.findall(pattern, (root / "hosts" / host / "README.md").read_text(encoding="utf-8"))
    with Model(Params.from_toml(root / "hosts" / "surface.toml")) as model:
        length = len(model.microslip().state)
    assert told and set(map(int, told)) == {length + beside}


@pytest.mark.parametrize("words, holds", [
    ("within 3e-4 of it", True), ("within 1e-4 of it", False), ("within 4e-3 of it", False), ("0.2341 N", True), ("0.2351 N", False),
    ("23.4 %", True), ("23.5 %", False), ("`0.777`, on 7 March 2026", True), ("of 117 runs", False),
])  # fmt: skip
def test_a_number_of_a_page_that_no_run_printed_is_found(words: str, holds: bool, root: Path, tmp_path: Path) -> None:
    (tmp_path / "hosts" / "mock").mkdir(parents=True)
    program = tmp_path / "hosts" / "page_numbers.py"
    program.write_text((root / "hosts" / "page_numbers.py").read_text(encoding="utf-8"), encoding="utf-8")
    (tmp_path / "hosts" / "mock" / "README.md").write_text(f"The friction is {words}.\n", encoding="utf-8")
    (tmp_path / "log").write_text("friction 0.23412, off by 2.6e-04\n", encoding="utf-8")
    done = subprocess.run([sys.executable, program, "mock", tmp_path / "log"], capture_output=True, text=True, check=False)
    assert (done.returncode == 0) == holds, done.stdout
