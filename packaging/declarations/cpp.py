"""C++: the enumerations of asperity.hpp, and a reader and a setter of class Params for each parameter."""

from words import WIDTH, first_sentence, flagged, word, wrapped


def enumerations(header):
    """An enum class for each parameter that is one of several constants."""
    for number, (name, words) in enumerate(header.words.items()):
        doc = next(one.doc for one in header.params if one.name == name)
        yield from [""] * bool(number) + wrapped(first_sentence(doc), "/// ")
        yield f"enum class {enum(name)} : std::int32_t {{"
        for one, constant in words.items():
            yield from wrapped(constant.doc, "    /// ")
            yield f"    {word(one).replace('-', '_')} = {constant.name},"
        yield "};"


def accessors(header):
    """Of all parameters but the table of heights, which is set as a whole."""
    first = True
    for one in header.params:
        if one.is_pointer or one.type == "uint64_t":
            continue
        kind, read, written = "double", "c_.{}", "value"
        if one.name in header.words:
            kind, read, written = enum(one.name), f"static_cast<{enum(one.name)}>(c_.{{}})", "static_cast<std::int32_t>(value)"
        elif one.type == "int32_t":
            kind, read, written = "bool", "c_.{} != 0", "value ? 1 : 0"
        yield from ([] if first else [""]) + wrapped(flagged(one.doc, "true", "false"), "    /// ")
        yield f"    {kind} {one.name}() const noexcept {{ return {read.format(one.name)}; }}"
        yield "    /// Sets it."
        signature, body = f"    Params &{one.name}({kind} value) noexcept {{", f"return assign(c_.{one.name}, {written});"
        short = f"{signature} {body} }}"
        yield from [short] if len(short) <= WIDTH else [signature, f"        {body}", "    }"]
        first = False


def enum(name):
    """height_distribution as Heights, contact_law as ContactLaw."""
    return "Heights" if name == "height_distribution" else "".join(part.capitalize() for part in name.split("_"))
