"""The ctypes layer says what include/asperity.h says: the text of the header, and what a C compiler makes of it."""

from __future__ import annotations

import ctypes
import json
import re
import subprocess
from dataclasses import fields
from pathlib import Path
from typing import Any, Callable

import pytest

from asperity import Params, State, Status, Summary, Warnings, _header

STRUCTS = (
    "asperity_params",
    "asperity_state",
    "asperity_summary",
    "asperity_table",
    "asperity_sensitivities",
    "asperity_microslip",
    "asperity_material_data",
    "asperity_pair_data",
    "asperity_interface_data",
)
TYPES = {
    "double": ctypes.c_double,
    "uint64_t": ctypes.c_uint64,
    "uint32_t": ctypes.c_uint32,
    "int32_t": ctypes.c_int32,
    "size_t": ctypes.c_size_t,
    "asperity_status": ctypes.c_int32,
    "void": None,
    **{name: getattr(_header, name) for name in (*STRUCTS, "asperity_model")},
}


@pytest.fixture(scope="module")
def header(root: Path) -> str:
    """The declarations, without comments."""
    text = (root / "include" / "asperity.h").read_text(encoding="utf-8")
    return re.sub(r"/\*.*?\*/|//[^\n]*", "", text, flags=re.DOTALL)


def ctype(text: str) -> Any:
    """The ctypes form of a C type."""
    if text.replace(" ", "") == "constchar*":
        return ctypes.c_char_p
    stars = text.count("*")
    name = re.sub(r"\b(const|struct)\b|\*", "", text).strip()
    name, _, length = name.partition("[")
    found = ctypes.c_char if name == "char" else TYPES[name]
    if length:
        return found * int(length.rstrip("]"))
    for _ in range(stars):
        found = ctypes.POINTER(found)
    return found


def declaration(text: str) -> tuple[str, str]:
    """A C declaration, cut into type and name."""
    match = re.fullmatch(r"(.*?)(\w+)(\[\d+\])?", text.strip(), re.DOTALL)
    assert match, text
    return " ".join(match[1].split()) + (match[3] or ""), match[2]


def constants(header: str) -> dict[str, Any]:
    found = re.findall(r"^#define (ASPERITY_\w+) (.+)$", header, re.MULTILINE)
    return {name: json.loads(value) for name, value in found}


def test_constants_are_those_of_the_header_in_its_order(header: str) -> None:
    ours = {name: value for name, value in vars(_header).items() if name.startswith("ASPERITY_")}
    assert list(ours.items()) == list(constants(header).items())
    assert len(ours) > 10


@pytest.mark.parametrize("name", STRUCTS)
def test_fields_are_those_of_the_header_in_its_order(header: str, name: str) -> None:
    body = re.search(rf"typedef struct {name} \{{(.*?)\}} {name};", header, re.DOTALL)
    assert body, name
    theirs = [declaration(line) for line in body[1].split(";") if line.strip()]
    assert getattr(_header, name)._fields_ == [(field, ctype(kind)) for kind, field in theirs]


def test_there_are_no_other_structs(header: str) -> None:
    assert set(re.findall(r"typedef struct (\w+)", header)) == {*STRUCTS, "asperity_model"}


def test_prototypes_are_those_of_the_header_in_its_order(header: str) -> None:
    theirs = {}
    for returned, name, taken in re.findall(r"^([\w \*]+?)\b(asperity_\w+)\(([^)]*)\);", header, re.MULTILINE):
        arguments = [] if taken.strip() == "void" else [declaration(one)[0] for one in taken.split(",")]
        theirs[name] = (ctype(returned.strip()), [ctype(one) for one in arguments])
    assert list(_header.PROTOTYPES.items()) == list(theirs.items())
    assert len(theirs) == len(set(re.findall(r"\b(asperity_\w+)\(", header))) > 10


def test_sizes_offsets_and_constants_agree_with_a_c_compiler(
    root: Path, header: str, compile_c: Callable[..., None], tmp_path: Path
) -> None:
    lines = [f'printf("\\"{name}\\": %zu,\\n", sizeof({name}));' for name in STRUCTS]
    for name in STRUCTS:
        for field, _ in getattr(_header, name)._fields_:
            lines.append(f'printf("\\"{name}.{field}\\": %zu,\\n", offsetof({name}, {field}));')
    whole = [name for name, value in constants(header).items() if isinstance(value, int)]
    lines += [f'printf("\\"{name}\\": %lld,\\n", (long long){name});' for name in whole]
    source = "#include <asperity.h>\n#include <stdio.h>\nint main(void)\n{\n" + "\n".join(lines) + "\nreturn 0;\n}\n"
    (tmp_path / "layout.c").write_text(source)
    compile_c(tmp_path / "layout.c", "-I", root / "include", "-o", tmp_path / "layout")
    printed = subprocess.run([tmp_path / "layout"], capture_output=True, text=True, check=True, timeout=10).stdout
    theirs = json.loads("{" + printed.rstrip().rstrip(",") + "}")

    ours = {}
    for name in STRUCTS:
        struct = getattr(_header, name)
        ours[name] = ctypes.sizeof(struct)
        ours.update({f"{name}.{field}": getattr(struct, field).offset for field, _ in struct._fields_})
    ours.update({name: getattr(_header, name) for name in whole})
    assert ours == theirs


@pytest.mark.parametrize("python, c", list(zip((Params, State, Summary), STRUCTS)))
def test_dataclasses_have_the_fields_of_the_structs(python: Any, c: str) -> None:
    theirs = [name for name, _ in getattr(_header, c)._fields_ if name not in ("struct_size", "table_length")]
    assert [field.name.rstrip("_") for field in fields(python)] == theirs


def test_warnings_are_those_of_the_header(header: str) -> None:
    theirs = {name: value for name, value in constants(header).items() if "WARNING" in name}
    assert {f"ASPERITY_WARNING_{warning.name}": int(warning) for warning in Warnings} == theirs


def test_statuses_are_those_of_the_header(header: str) -> None:
    names = [name for name in constants(header) if not re.search("VERSION|HEIGHTS|CONTACT|SLIP|TABLE|WARNING", name)]
    assert [f"ASPERITY_{status.name}" for status in Status] == names
