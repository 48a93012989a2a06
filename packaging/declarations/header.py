"""include/asperity.h as cbindgen writes it: constants, structs with their layout, functions, and what their comments say."""

import json
import re
from dataclasses import dataclass, field
from functools import cached_property

COMMENT = r"/\*\*((?:(?!\*/).)*)\*/"
DECLARATIONS = re.compile(
    rf"^/\* ---- (?P<heading>[^\n]+?) ---- \*/$|^(?:{COMMENT.replace('((', '(?P<comment>(')}\n)?(?:"
    r"#define (?P<constant>ASPERITY_\w+) (?P<value>-?\d+|\"[^\"\n]*\")$"
    r"|typedef struct (?P<struct>\w+) \{\n(?P<body>.*?)^\} (?P=struct);$"
    r"|(?P<declaration>(?P<result>\w[\w ]*?[ *]+)(?P<function>asperity_\w+)\((?P<arguments>[^;]*)\);)$)",
    re.MULTILINE | re.DOTALL,
)
FIELD = re.compile(COMMENT + r"\s*([^;/]+);", re.DOTALL)
DECLARATION = re.compile(r"(.*?)(\w+)(?:\[(\d+)\])?", re.DOTALL)
# Symbol or words, unit in brackets, then the domain where there is one: "omega [-], 1 to 200: shape of the heights".
DOMAIN = re.compile(
    r"^[^\[\]]*?\[[^\]]+\], (> [^,;:. ]+ and at most [^,;: ]+|>=? [^,;: ]+|at least [^,;: ]+|[^,;:]+? to [^,;:]+?)(?=[,;:]|\.?$|\. )"
)
SIZES = {"double": 8, "uint64_t": 8, "int64_t": 8, "int32_t": 4, "uint32_t": 4}


@dataclass
class Constant:
    """A number or a string that a macro stands for."""

    name: str
    value: int | str
    doc: str

    @property
    def bare(self):
        """The name without the library's."""
        return self.name.removeprefix("ASPERITY_")


@dataclass
class Variable:
    """A field of a struct or an argument of a function."""

    name: str
    type: str
    count: int | None = None
    doc: str = ""

    @property
    def is_pointer(self):
        return "*" in self.type

    @property
    def unit(self):
        """The dimension in brackets; empty where there is none."""
        found = re.search(r"\[([^\]]+)\]", self.doc)
        return "" if found is None or found[1] == "-" else found[1]

    @property
    def domain(self):
        """What the number may be, as the comment says right after the unit; empty where it does not."""
        found = DOMAIN.match(self.doc)
        return found[1] if found else ""


@dataclass
class Struct:
    name: str
    doc: str
    fields: list[Variable]

    def layout(self, pointer):
        """The size of the struct and the offsets of its fields, on a machine whose pointers have so many bytes."""
        end, alignment, offsets = 0, 1, []
        for one in self.fields:
            size = pointer if one.is_pointer else SIZES[one.type]
            offsets.append(-(-end // size) * size)
            end = offsets[-1] + size * (one.count or 1)
            alignment = max(alignment, size)
        return -(-end // alignment) * alignment, offsets


@dataclass
class Function:
    name: str
    result: str
    arguments: list[Variable]
    declaration: str
    comment: str
    heading: str

    @property
    def doc(self):
        """The first paragraph of the comment, on one line."""
        return one_line(self.comment.split("\n\n")[0].split("\n@")[0])


@dataclass
class Header:
    constants: list[Constant] = field(default_factory=list)
    structs: dict[str, Struct] = field(default_factory=dict)
    functions: list[Function] = field(default_factory=list)

    @cached_property
    def words(self):
        """For each field that is one of several constants: these, by the last part of their names."""
        groups = {}
        for constant in self.constants:
            group, _, word = constant.bare.partition("_")
            groups.setdefault(group, {})[word] = constant
        return {
            one.name: words
            for one in self.structs["asperity_params"].fields
            for group, words in groups.items()
            # HEIGHTS are those of height_distribution.
            if one.type == "int32_t" and one.name.startswith((f"{group.lower()}_", f"{group.lower().rstrip('s')}_"))
        }

    @property
    def statuses(self):
        """ASPERITY_OK to the last of those that functions return."""
        names = [constant.name for constant in self.constants]
        return self.constants[names.index("ASPERITY_OK") : names.index("ASPERITY_INTERNAL") + 1]

    @property
    def warnings(self):
        return [constant for constant in self.constants if constant.bare.startswith("WARNING_")]

    @property
    def params(self):
        """The parameters: all fields of asperity_params but its size."""
        return self.structs["asperity_params"].fields[1:]

    @property
    def inputs(self):
        """The names of the physical inputs, which have no default: they come before what describes the heights."""
        names = [one.name for one in self.params]
        return names[: names.index("height_distribution")]


def parse(text):
    """The header; refuses one of which a part would be passed over."""
    header, heading = Header(), ""
    for found in DECLARATIONS.finditer(text):
        comment = plain(found["comment"] or "")
        if found["heading"]:
            heading = found["heading"]
        elif found["constant"]:
            header.constants.append(Constant(found["constant"], json.loads(found["value"]), one_line(comment)))
        elif found["struct"]:
            fields = [variable(declared, one_line(plain(doc))) for doc, declared in FIELD.findall(found["body"])]
            header.structs[found["struct"]] = Struct(found["struct"], comment, fields)
        else:
            listed = [] if found["arguments"] == "void" else found["arguments"].split(",")
            docs = argument_docs(comment)
            arguments = [variable(one) for one in listed]
            for one in arguments:
                one.doc = docs.get(one.name, "")
            result = spaced(found["result"])
            header.functions.append(Function(found["function"], result, arguments, found["declaration"], comment, heading))
    check_whole(header, text)
    return header


def check_whole(header, text):
    """Counts by other means what was found."""
    bare = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
    for what, found, counted in (
        ("structs", len(header.structs), len(re.findall(r"^typedef struct \w+ \{", bare, re.MULTILINE))),
        ("fields", sum(len(one.fields) for one in header.structs.values()), len(re.findall(r"^ +[^;{}()]+;", bare, re.MULTILINE))),
        ("functions", len(header.functions), len(re.findall(r"\basperity_\w+\([^)]*\);", bare))),
        ("constants", len(header.constants), len(re.findall(r"^#define ASPERITY_\w+ .", bare, re.MULTILINE))),
    ):
        if found != counted or not found:
            raise ValueError(f"include/asperity.h has {counted} {what}, of which {found} are understood")


def variable(declaration, doc=""):
    kind, name, count = DECLARATION.fullmatch(declaration.strip()).groups()
    return Variable(name, spaced(kind), int(count) if count else None, doc)


def spaced(kind):
    """A type with one space before its stars: "const double *"."""
    return re.sub(r"\s*(\*+)", r" \1", " ".join(kind.replace("struct ", "").split()))


def argument_docs(comment):
    """What @param says of each argument; several may share one line: "@param m0,m2  variances"."""
    found = {}
    for names, text in re.findall(r"^@param\s+(\S+)\s+(.*?)(?=^@|^\n|\Z)", comment, re.MULTILINE | re.DOTALL):
        found |= dict.fromkeys(names.split(","), one_line(text))
    return found


def plain(comment):
    """A comment without its stars."""
    return re.sub(r"(?m)^[ \t]*\* ?", "", comment).strip()


def one_line(text):
    return " ".join(text.split())
