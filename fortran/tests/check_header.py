#!/usr/bin/env python3
"""Holds fortran/asperity.f90 against include/asperity.h, so that neither changes without the other.

usage: check_header.py HEADER MODULE OBJECT DIRECTORY

Compares every constant, every field of every struct and every function, by name, order and type. Checks that the
symbols of OBJECT, a compiled test, name every function. Writes layout.c and layout.f90 into DIRECTORY: compiled, both
print the size of each struct and the offset of each field.
"""

import re
import subprocess
import sys
from pathlib import Path

# Fortran does not tell these constants from the functions of the same name.
RENAMED = {"ASPERITY_VERSION": "ASPERITY_HEADER_VERSION", "ASPERITY_ABI_VERSION": "ASPERITY_HEADER_ABI_VERSION"}

# Macros in C and functions of the module in Fortran: what the library exports under these names is for programs that
# were compiled with the first version of a struct.
FOR_OLD_PROGRAMS = {"asperity_params_init", "asperity_params_init_unset", "asperity_get_params"}

FIELD_TYPES = {
    "uint64_t": "integer(c_int64_t)",
    "uint32_t": "integer(c_int32_t)",
    "int32_t": "integer(c_int32_t)",
    "double": "real(c_double)",
    "double [2]": "real(c_double)(2)",
    "double [4]": "real(c_double)(4)",
    "const double *": "type(c_ptr)",
    "const char *": "type(c_ptr)",
}

VALUE_TYPES = {
    "double": "real(c_double), value",
    "size_t": "integer(c_size_t), value",
    "uint64_t": "integer(c_int64_t), value",
    "asperity_status": "integer(c_int32_t), value",
    "uint64_t *": "integer(c_int64_t)",
    "const double *": "type(c_ptr), value",
    "double *": "type(c_ptr), value",
    "char *": "type(c_ptr), value",
    "const char *": "type(c_ptr), value",
    "const char *const *": "type(c_ptr), value",
    "const uint32_t *": "type(c_ptr), value",
    "const struct asperity_model *const *": "type(c_ptr), value",
    "const struct asperity_model *": "type(c_ptr), value",
    "struct asperity_model *": "type(c_ptr), value",
    "struct asperity_model **": "type(c_ptr)",
    "const struct asperity_params *": "type(asperity_params)",
    "struct asperity_params *": "type(asperity_params)",
    "struct asperity_state *": "type(asperity_state)",
    "struct asperity_summary *": "type(asperity_summary)",
    "struct asperity_table *": "type(asperity_table)",
    "struct asperity_sensitivities *": "type(asperity_sensitivities)",
    "struct asperity_microslip *": "type(asperity_microslip)",
    "struct asperity_material_data *": "type(asperity_material_data)",
    "struct asperity_pair_data *": "type(asperity_pair_data)",
    "struct asperity_interface_data *": "type(asperity_interface_data)",
}

RESULT_TYPES = {
    "asperity_status": "integer(c_int32_t)",
    "uint32_t": "integer(c_int32_t)",
    "size_t": "integer(c_size_t)",
    "double": "real(c_double)",
    "const char *": "type(c_ptr)",
    "void": "subroutine",
}


def read_header(path):
    text = re.sub(r"/\*.*?\*/", " ", path.read_text(), flags=re.S)
    constants = dict(re.findall(r"^#define (ASPERITY_\w+) (\S+)$", text, flags=re.M))
    constants.pop("ASPERITY_H", None)
    structs = {
        name: [split_declaration(line) for line in body.split(";") if line.strip()]
        for name, body in re.findall(r"typedef struct (\w+) \{(.*?)\}", text, flags=re.S)
    }
    functions = {}
    for result, name, arguments in re.findall(r"^([\w ]+?[ *]+)(asperity_\w+)\(([^)]*)\);", text, flags=re.M | re.S):
        pairs = [] if arguments.strip() == "void" else [split_declaration(a) for a in arguments.split(",")]
        functions[name] = (spaced(result), pairs)
    macros = set(re.findall(r"^#define (asperity_\w+)\(", text, flags=re.M))
    if macros != FOR_OLD_PROGRAMS:
        sys.exit(f"check_header.py: the macros of the header are {sorted(macros)}")
    return constants, structs, {name: function for name, function in functions.items() if name not in macros}


def split_declaration(text):
    kind, name, length = re.fullmatch(r"\s*(.*?)(\w+)(?:\[(\d+)\])?\s*", text, flags=re.S).groups()
    return name.lower(), spaced(kind) + (f" [{length}]" if length else "")


def spaced(kind):
    return re.sub(r"\s*(\*+)", r" \1", " ".join(kind.split()))


def read_module(path):
    lines = [re.sub(r"!.*", "", line).rstrip() for line in path.read_text().splitlines()]
    text = re.sub(r"&\s*\n\s*", "", "\n".join(lines))
    constants = dict(re.findall(r"parameter, public :: (ASPERITY_\w+) = (\S+)", text))
    structs = {}
    for name, body in re.findall(r"type, bind\(c\), public :: (\w+)\n(.*?)end type", text, flags=re.S):
        structs[name] = [declared(line)[0] for line in body.splitlines() if "::" in line]
    interface = re.search(r"\n  interface\n(.*?)\n  end interface", text, flags=re.S).group(1)
    functions = {}
    pattern = r"(?:pure )?(function|subroutine) (\w+)\(([^)]*)\)(?:\s*result\((\w+)\))? bind\(c\)\n(.*?)end \1 \2"
    for kind, name, arguments, result, body in re.findall(pattern, interface, flags=re.S):
        types = {n.lower(): t for line in body.splitlines() if "::" in line and "import" not in line
                 for n, t in declared(line)}
        names = [a.strip().lower() for a in arguments.split(",") if a.strip()]
        returned = "subroutine" if kind == "subroutine" else types[result.lower()]
        functions[name] = (returned, [(n, types[n]) for n in names])
    return constants, structs, functions


def declared(line):
    """(name, type) pairs of a declaration, the intent left out."""
    kind, names = line.split("::")
    parts = [p.strip() for p in kind.split(",") if not p.strip().startswith("intent")]
    found = [re.fullmatch(r"(\w+)(\(\d+\))?", re.sub(r"=.*", "", n).strip()).groups("") for n in names.split(",")]
    return [(name, ", ".join(parts) + shape) for name, shape in found]


def compare(header, module):
    """All differences, as sentences."""
    (c_constants, c_structs, c_functions), (f_constants, f_structs, f_functions) = header, module
    expected = {RENAMED.get(name, name): value.replace('"', "'") for name, value in c_constants.items()}
    yield from differences("constant", expected, f_constants)
    fields = {s: [(name, FIELD_TYPES[kind]) for name, kind in body] for s, body in c_structs.items()}
    yield from differences("struct", fields, f_structs)
    functions = {
        name: (RESULT_TYPES[result], [(n, VALUE_TYPES[kind]) for n, kind in arguments])
        for name, (result, arguments) in c_functions.items()
    }
    yield from differences("function", functions, f_functions)


def differences(what, expected, found):
    for name in sorted(expected.keys() | found.keys()):
        if name not in found:
            yield f"{what} {name} of the header is missing in the module"
        elif name not in expected:
            yield f"{what} {name} of the module is not in the header"
        elif expected[name] != found[name]:
            yield f"{what} {name}: " + first_difference(expected[name], found[name])


def first_difference(expected, found):
    if isinstance(expected, list) and len(expected) == len(found):
        expected, found = next((e, f) for e, f in zip(expected, found) if e != f)
    return f"the header makes it {expected}, the module has {found}"


def uncalled(functions, object_file):
    symbols = subprocess.run(["nm", "-u", object_file], check=True, capture_output=True, text=True).stdout.split()
    return [f"function {name} is called by no test" for name in functions if name not in symbols]


def write_layout(structs, directory):
    c, f = [], []
    for name, fields in structs.items():
        c.append(f'    printf("{name} %zu\\n", sizeof({name}));')
        f.append(f"  write (*, '(a, i0)') '{name} ', c_sizeof({name}_1)")
        for field, _ in fields:
            c.append(f'    printf("{name}.{field} %zu\\n", offsetof({name}, {field}));')
            f.append(f"  write (*, '(a, i0)') '{name}.{field} ', &\n"
                     f"    address(c_loc({name}_1%{field})) - address(c_loc({name}_1))")
    (directory / "layout.c").write_text(
        "#include <asperity.h>\n#include <stdio.h>\n\nint main(void)\n{\n" + "\n".join(c) + "\n    return 0;\n}\n")
    variables = "".join(f"  type({name}), target :: {name}_1\n" for name in structs)
    (directory / "layout.f90").write_text(
        "program layout\n  use, intrinsic :: iso_c_binding\n  use asperity\n  implicit none\n" + variables
        + "\n".join(f)
        + "\ncontains\n  function address(p)\n    type(c_ptr), intent(in) :: p\n    integer(c_intptr_t) :: address\n"
        "    address = transfer(p, address)\n  end function address\nend program layout\n")


def main():
    header = read_header(Path(sys.argv[1]))
    module = read_module(Path(sys.argv[2]))
    if len(header[0]) < 10 or len(header[1]) != 9 or len(header[2]) < 20:
        sys.exit("check_header.py: the header was not understood")
    problems = list(compare(header, module)) + uncalled(header[2], sys.argv[3])
    write_layout(header[1], Path(sys.argv[4]))
    for problem in problems:
        print(f"FAIL: {problem}", file=sys.stderr)
    if problems:
        sys.exit(1)
    constants, structs, functions = header
    fields = sum(len(body) for body in structs.values())
    print(f"the module has all of the header: {len(constants)} constants, {len(structs)} structs with {fields} fields, "
          f"{len(functions)} functions")


if __name__ == "__main__":
    main()
