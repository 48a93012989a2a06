"""The C interface in Fortran: constants, types and an interface block, as the first part of the module asperity."""

import re

from words import WIDTH, first_sentence, wrapped

# Fortran does not tell these constants from the functions of the same name.
RENAMED = {"ASPERITY_VERSION": "ASPERITY_HEADER_VERSION", "ASPERITY_ABI_VERSION": "ASPERITY_HEADER_ABI_VERSION"}
KINDS = {
    "double": "real(c_double)",
    "size_t": "integer(c_size_t)",
    "uint64_t": "integer(c_int64_t)",
    "int64_t": "integer(c_int64_t)",
    "uint32_t": "integer(c_int32_t)",
    "int32_t": "integer(c_int32_t)",
    "asperity_status": "integer(c_int32_t)",
}
COLUMN = 52  # at which comments begin


def declarations(header, module):
    """The lines between the marks of the module, whose other functions hide those of C that have their names."""
    own = set(re.findall(r"^  (?:function|subroutine) (asperity_\w+)\(", module, re.MULTILINE))
    wrappers = own | {function.name for function in header.functions if takes_a_text(function, header)}
    yield "  ! ---- The C interface: constants ----"
    for constant in header.constants:
        yield from constant_lines(constant)
    yield from ("", "  ! ---- The C interface: types ----")
    for struct in header.structs.values():
        yield from type_lines(struct, header)
    yield from ("", "  ! ---- The C interface: functions ----")
    yield "  ! A model is a type(c_ptr). Functions of type integer(c_int32_t) return a status."
    yield from ("", "  interface")
    yield from (line for function in header.functions for line in function_lines(function, header, wrappers))
    yield from ("  end interface", "")
    names = ", ".join(function.name for function in header.functions if function.name not in own)
    yield from (line.removesuffix(",") for line in wrapped(names, "  public :: "))


def takes_a_text(function, header):
    """Whether it is a call with one text beside structs, which a Fortran text can stand for."""
    kinds = [one.type.removesuffix(" *") for one in function.arguments if one.type != "size_t"]
    return function.result == "asperity_status" and kinds.count("const char") == 1 and set(kinds) <= {"const char", *header.structs}


def texts(header):
    """Subroutines with the names of the C functions that take a text."""
    for function in header.functions:
        if not takes_a_text(function, header):
            continue
        listed = [one for one in function.arguments if one.type != "size_t"]
        (given,) = (one.name for one in listed if one.type == "const char *")
        passed = {given: "c_loc(characters)", "length": f"len_trim({given}, kind=c_size_t)"}
        yield from wrapped(text(first_sentence(function.doc)), "  ! ")
        yield f"  subroutine {function.name}({', '.join(one.name for one in listed)}, stat, errmsg)"
        for one in listed:
            kind = "character(*), intent(in)" if one.name == given else argument_type(one, header)
            yield from commented(f"    {kind} :: {one.name}", one.doc, COLUMN)
        yield "    integer, intent(out), optional :: stat"
        yield "    character(*), intent(inout), optional :: errmsg"
        yield f"    character(kind=c_char), target :: characters(len({given}) + 1)"
        yield f"    characters = c_string({given}, size(characters))"
        yield f"    call report({function.name}_c({', '.join(passed.get(one.name, one.name) for one in function.arguments)}), stat, errmsg)"
        yield from (f"  end subroutine {function.name}", "")


def constant_lines(constant):
    name = RENAMED.get(constant.name, constant.name)
    if isinstance(constant.value, str):
        yield f"  character(*), parameter, public :: {name} = '{constant.value}'"
        return
    kind = "integer(c_int64_t)" if constant.bare.startswith("WARNING_") else "integer(c_int32_t)"
    code, said = f"  {kind}, parameter, public :: {name} = {constant.value}", text(first_sentence(constant.doc))
    if len(code) + len(said) + 4 <= WIDTH:
        yield f"{code}  ! {said}"
    else:
        yield from (*wrapped(said, "  ! "), code)


def type_lines(struct, header):
    size, _ = struct.layout(pointer=8)
    made = any(function.name == f"{struct.name}_init" for function in header.functions)
    yield ""
    yield from wrapped(text(first_sentence(struct.doc.split("\n\n")[0])), "  ! ")
    yield f"  type, bind(c), public :: {struct.name}"
    for one in struct.fields:
        kind = "type(c_ptr)" if one.is_pointer else KINDS[one.type]
        shape = f"({one.count})" if one.count else ""
        default, doc = " = c_null_ptr" if one.is_pointer else "", one.doc
        if one.name == "struct_size":
            default = f" = {0 if made else size}"
            doc = f"bytes of this type; set by {struct.name}_init" if made else "bytes of this type; leave it"
        yield from commented(f"    {kind} :: {one.name}{shape}{default}", doc, COLUMN)
    yield f"  end type {struct.name}"


def function_lines(function, header, wrappers):
    name = function.name + ("_c" if function.name in wrappers else "")
    bound = f"bind(c, name='{function.name}')" if name != function.name else "bind(c)"
    kind = "subroutine" if function.result == "void" else "function"
    # A number of a model that numbers alone tell.
    pure = function.result == "double" and all(one.type in ("double", "const asperity_model *") for one in function.arguments)
    yield from wrapped(text(first_sentence(function.doc)), "    ! ")
    listed = ", ".join(one.name for one in function.arguments)
    opening = f"    {'pure ' if pure else ''}{kind} {name}({listed}) {bound}"
    if len(opening) > WIDTH:
        lines = wrapped(opening.strip().replace(f") {bound}", ")"), "    ", "        ")
        opening = "".join(f"{line} &\n" for line in lines) + f"        {bound}"
    yield opening
    yield "      import"
    for one in function.arguments:
        yield from commented(f"      {argument_type(one, header)} :: {one.name}", pointed_to(one) + one.doc, COLUMN)
    if kind == "function":
        yield f"      {'type(c_ptr)' if '*' in function.result else KINDS[function.result]} :: {name}"
    yield from (f"    end {kind} {name}", "")


def argument_type(one, header):
    """The type of an argument with its attributes: structs by reference, arrays and strings as addresses."""
    pointed = one.type.removeprefix("const ").removesuffix(" *")
    if one.type in KINDS:
        return f"{KINDS[one.type]}, intent(in), value"
    if pointed in header.structs:
        return f"type({pointed}), intent({'in' if one.type.startswith('const') else 'inout'})"
    if one.type == "uint64_t *":
        return "integer(c_int64_t), intent(inout)"
    if one.type == "asperity_model **":
        return "type(c_ptr), intent(inout)"
    if one.is_pointer:
        return "type(c_ptr), intent(in), value"
    raise ValueError(f"{one.name}: the type {one.type} is not known to packaging/declarations/fortran.py")


def pointed_to(one):
    """What stands at an address, which its type does not say."""
    pointed = one.type.removeprefix("const ").removesuffix(" *")
    if one.type.endswith(" *") and pointed in KINDS and one.type != "uint64_t *":
        return f"{KINDS[pointed]}: "
    return {"const char *": "characters, the last c_null_char: ", "char *": "characters: "}.get(one.type, "")


def commented(code, doc, column):
    """A declaration with the first sentence of its comment, which goes on below it."""
    said = text(first_sentence(doc))
    if not said:
        return [code]
    margin = " " * column + "! "
    lines = wrapped(said, margin)
    if len(code) + 1 <= column:
        lines[0] = code.ljust(column) + lines[0].lstrip()
        return lines
    room = f"{code} ! "
    if len(room) + len(said) <= WIDTH:
        return [room + said]
    return [code, *lines]


def text(doc):
    """A comment without what holds for C alone."""
    doc = re.sub(r"(; |, |^)must not be NULL(?: unless [^;,]*)?(?=[;,]|$)", "", doc).strip("; ")
    doc = doc.replace("; NUL-terminated", "").replace("`", "").replace("INFINITY", "infinity").replace("NULL", "c_null_ptr")
    doc = doc.removeprefix("Bit of warnings: ")
    return doc if doc.endswith("..") or ". " in doc.replace("i.e. ", "") else doc.removesuffix(".")


# What the smoke test passes for an argument by its type, and each output a place of its own.
PASSED = {
    "double": "0.4_c_double",
    "size_t": "1_c_size_t",
    "int32_t": "0_c_int32_t",
    "asperity_status": "ASPERITY_INTERNAL",
    "uint64_t": "ASPERITY_WARNING_FEW",
    "uint64_t *": "bits",
    "const double *": "c_loc(given)",
    "double *": "out({place})",
    "const uint32_t *": "c_loc(which)",
    "const char *": "c_loc(name)",
    "char *": "c_loc(text)",
    "const asperity_model *const *": "c_loc(models)",
    "const char *const *": "c_loc(names)",
    "asperity_params *": "changed",
    "size_t length": "1000_c_size_t",
}
SMOKE = """! Each function of the C interface, called under its own name: it returns, and something of the right kind.
! Generated by packaging/declarations from include/asperity.h: run `make header`. What the module wraps is asked by the other tests.
program smoke
  use, intrinsic :: iso_c_binding
  use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
  use asperity
  use checking
  implicit none
"""
BEGIN = """  type(asperity_params) :: changed
  type(c_ptr) :: model
  type(c_ptr), target :: models(1), names(1), out(13)
  real(c_double), target :: given(256), found(256, 13)
  integer(c_int32_t), target :: which(1)
  integer(c_int64_t) :: bits
  character(kind=c_char), target :: text(1000), name(9) = ['h', 'a', 'r', 'd', 'n', 'e', 's', 's', c_null_char]
  integer :: i

  model = c_null_ptr
  params = paper_case()
  changed = params
  call asperity_check(asperity_create(params, model))
  models = model
  names = c_loc(name)
  given = 0
  found = 0
  out = [(c_loc(found(1, i)), i=1, 13)]
  which = 0
"""
END = """  call finish('every function of the C interface')

contains

  ! The next call finds the parameters as they were.
  function is_status(status)
    integer(c_int32_t), intent(in) :: status
    logical :: is_status
    is_status = status >= ASPERITY_OK .and. status <= ASPERITY_NOT_CONVERGED
    changed = params
  end function is_status

end program smoke
"""


def smoke(header, module):
    """fortran/tests/smoke.f90: a call of each function that the module does not hide."""
    own = set(re.findall(r"^  (?:function|subroutine) (asperity_\w+)\(", module, re.MULTILINE))
    # What frees the model comes last.
    called = own | {"asperity_create"}
    functions = [one for one in header.functions if one.name not in called and not takes_a_text(one, header)]
    functions.sort(key=lambda one: one.result == "void")
    filled = {one.type.removesuffix(" *") for function in functions for one in function.arguments}
    yield from SMOKE.splitlines()
    yield from (f"  type({name}) :: {name.removeprefix('asperity_')}" for name in header.structs if name in filled)
    yield from BEGIN.splitlines()
    for function in functions:
        call = f"{function.name}({', '.join(passed(one, place, header) for place, one in enumerate(function.arguments, 1))})"
        holds = {
            "asperity_status": f"is_status({call})",
            "double": f".not. ieee_is_nan({call})",
            "const char *": f"c_associated({call})",
        }.get(function.result, f"{call} > 0")
        line = f"call {call}" if function.result == "void" else f"call check('{function.name}', {holds})"
        yield from " &\n".join(wrapped(line, "  ", "      ", WIDTH - 2)).splitlines()
    yield from END.splitlines()


def passed(one, place, header):
    """An argument that is in order, and means nothing."""
    known = PASSED.get(f"{one.type} {one.name}") or PASSED.get(one.type)
    if known:
        return known.format(place=place)
    pointed = one.type.removeprefix("const ").removesuffix(" *")
    return pointed.removeprefix("asperity_") if pointed in header.structs else "model"
