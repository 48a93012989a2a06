"""The compiled law as NumPy arrays, the page about arrays and its example."""

from __future__ import annotations

import gc
import re
import subprocess
import sys
from pathlib import Path

import differentiable_slider
import jax
import numpy as np
import pytest
from arrays_common import SURFACES, exact, loads_of

import asperity.jax
from asperity import Model, Warnings, table

DOCS = Path(__file__).parents[2] / "docs"


@pytest.mark.parametrize("surface", SURFACES)
def test_the_indexing_rule_gives_the_librarys_answers(surface: str) -> None:
    model = Model(SURFACES[surface])
    view, loads = model.table(), loads_of(model, np.float64)
    value, slope = table.at_excess(view, loads - view.pull_off_load)
    exact_value, exact_slope = exact(model, "friction_force", loads)
    np.testing.assert_allclose(value, exact_value, rtol=1e-15)
    np.testing.assert_allclose(slope, exact_slope, rtol=2e-15)


def test_the_view_is_read_only_and_keeps_the_model() -> None:
    model = Model(SURFACES["adhesive"])
    rows = model.table().rows[3:]
    kept = rows.copy()
    assert rows.base is not None and not rows.flags.writeable and rows.dtype == np.float64
    model.close()
    del model
    gc.collect()
    others = [Model(SURFACES["sticky"]) for _ in range(20)]
    np.testing.assert_array_equal(rows, kept)
    assert others


def test_the_floats_are_those_of_the_header(compile_c: object, root: Path, tmp_path: Path) -> None:
    """A program in C makes the same rows: other sums, so other last bits of a few small coefficients."""
    program = tmp_path / "rows"
    source = tmp_path / "rows.c"
    source.write_text(HEADER_ROWS, encoding="utf-8")
    library = Path(asperity._library.PATH)
    assert callable(compile_c)
    compile_c(source, "-I", root / "include", "-o", program, library, f"-Wl,-rpath,{library.parent}", "-lm")
    theirs = np.frombuffer(subprocess.run([program], check=True, capture_output=True).stdout, np.float32).reshape(-1, 8)
    ours = Model(SURFACES["adhesive"]).table("float32")
    assert abs(theirs.shape[0] - ours.rows.shape[0]) <= 16
    whole = slice(0, ours.row_count)
    answers = ~np.isnan(ours.rows[whole, 0]) & ~np.isnan(theirs[whole, 0])
    assert answers.sum() > 0.99 * ours.row_count
    np.testing.assert_allclose(ours.rows[whole][answers, :2], theirs[whole][answers, :2], rtol=2e-7)


HEADER_ROWS = """
#include <asperity_eval.h>
#include <stdio.h>
#include <stdlib.h>

int main(void)
{
    asperity_params params;
    asperity_model *model = NULL;
    asperity_table table = {sizeof table};
    asperity_float_table single;
    float *rows;
    uint32_t count;
    if (asperity_params_init(&params, sizeof params) != ASPERITY_OK ||
        asperity_params_set_dimensionless(&params, 0.01, 1000.0, 0.001, 1.0, 0.3) != ASPERITY_OK)
        return 1;
    if (asperity_create(&params, &model) != ASPERITY_OK || asperity_table_of(model, ASPERITY_TABLE_FRICTION, &table) != ASPERITY_OK)
        return 1;
    count = asperity_eval_make_float(&table, NULL, NULL);
    rows = (float *)malloc(count * 8 * sizeof *rows);
    if (!rows)
        return 1;
    asperity_eval_make_float(&table, rows, &single);
    return fwrite(rows, 8 * sizeof *rows, count, stdout) == count ? 0 : 1;
}
"""


def test_other_types_are_refused() -> None:
    with pytest.raises(ValueError, match="float16: must be float64 or float32"):
        Model(SURFACES["adhesive"]).table(np.float16)


def test_the_slider_is_differentiated_through_time() -> None:
    law = asperity.jax.friction_force(Model(differentiable_slider.SURFACE))
    place = jax.jit(lambda load: differentiable_slider.slide(law, load))
    slope = jax.jit(jax.grad(place))
    for load in (5e-4, 1e-3, 1.9e-3):
        difference = (place(load * 1.00001) - place(load * 0.99999)) / (2e-5 * load)
        assert float(slope(load)) == pytest.approx(float(difference), rel=1e-6)
    told = Warnings.UNCALIBRATED | Warnings.BROAD
    assert Model(differentiable_slider.SURFACE).check(5e-4, 2e-3) & ~told == 0


def test_the_example_finds_the_load_of_the_place(root: Path) -> None:
    program = root / "python" / "examples" / "differentiable_slider.py"
    printed = subprocess.run([sys.executable, program], check=True, capture_output=True, text=True).stdout
    assert printed.startswith("with 1.000 mN the block is ")
    assert re.findall(r"^  load (\S+) mN$", printed, re.MULTILINE)[-1] == "1.000000000"
    assert re.search(r"^UNCALIBRATED: ", printed, re.MULTILINE)


def test_the_programs_of_the_page_print_what_it_says(tmp_path: Path) -> None:
    page = (DOCS / "python.md").read_text(encoding="utf-8")
    programs = re.findall(r"^```python (\S+)\n(.*?)^```\n+```text\n(.*?)^```$", page, re.DOTALL | re.MULTILINE)
    assert len(programs) == 1  # in JAX
    for name, program, expected in programs:
        (tmp_path / name).write_text(program, encoding="utf-8")
        done = subprocess.run([sys.executable, tmp_path / name], check=True, capture_output=True, text=True)
        assert done.stdout == expected
