"""Data goes one way through the package: each module imports from its own layer of docs/dev/architecture.md or from lower
ones, and none imports, by whatever detour, what imports it. Imports inside functions count, and those for types alone."""

from __future__ import annotations

import ast
import re
from fnmatch import fnmatchcase
from graphlib import TopologicalSorter
from pathlib import Path

import pytest


@pytest.fixture(scope="module")
def imports(root: Path) -> dict[str, set[str]]:
    """Modules by their names within the package, a front as `__init__`, and what of the package each imports."""
    package = root / "python" / "src" / "asperity"
    paths = {".".join(path.relative_to(package).with_suffix("").parts): path for path in package.rglob("*.py")}
    return {name: set(imported(name, path, set(paths))) - {name} for name, path in paths.items()}


def imported(name: str, path: Path, modules: set[str]) -> list[str]:
    found = []
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found += [one.name.partition(".")[2] for one in node.names if one.name.split(".")[0] == "asperity"]
        elif isinstance(node, ast.ImportFrom):
            stem = (node.module or "").split(".") if node.module else []
            if node.level:
                stem = name.split(".")[: -node.level] + stem
            elif stem[:1] == ["asperity"]:
                stem = stem[1:]
            else:
                continue
            found += [".".join([*stem, one.name]) for one in node.names]
    return [module_of(one, modules) for one in found]


def module_of(name: str, modules: set[str]) -> str:
    """The module that has a name: itself one, a package's front, or one in which the name is defined."""
    stem = name.rpartition(".")[0]
    candidates = (name, f"{name}.__init__", stem, f"{stem}.__init__", "__init__")
    return next(one for one in candidates if one in modules)


def test_no_module_imports_in_a_circle(imports: dict[str, set[str]]) -> None:
    assert "studies.file" in imports["studies.study_command"] and "maps.summits" in imports["params"]  # in a function, and for types
    list(TopologicalSorter(imports).static_order())  # CycleError names the circle


def test_modules_import_from_their_layer_or_lower_ones(imports: dict[str, set[str]], root: Path) -> None:
    page = (root / "docs" / "dev" / "architecture.md").read_text(encoding="utf-8")
    rows = page.partition("\n| layer | modules |\n|---|---|\n")[2].partition("\n\n")[0].splitlines()
    patterns = sorted(((one, i) for i, row in enumerate(rows) for one in re.findall("`(.*?)`", row)), key=lambda of: -len(of[0]))
    # The longest pattern says it: `maps.cutoffs` before `maps.*`.
    layers = {name: next((i for one, i in patterns if fnmatchcase(name, one)), None) for name in imports}
    assert [name for name, layer in layers.items() if layer is None] == []
    upward = [f"{name} -> {one}" for name, used in imports.items() for one in used if (layers[one] or 0) > (layers[name] or 0)]
    assert upward == []
