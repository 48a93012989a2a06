"""Gathers the pages of the site: those of the repository with what they link to, and the references made from the sources.

usage: python docs/site/build.py FOLDER      writes FOLDER anew
"""

import re
import shutil
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "packaging" / "declarations"))
import header as declarations  # noqa: E402
from pages import cell  # noqa: E402

LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)\s]*)?\)")
FENCE = re.compile(r"^```(\w+) .*$", re.MULTILINE)


def gather(folder: Path) -> None:
    """Pages and the files that they link to, at the places that they have in the repository."""
    waiting = [*sorted((ROOT / "docs").glob("*.md")), *sorted((ROOT / "docs" / "dev").glob("*.md"))]
    waiting += [ROOT / "CHANGELOG.md", ROOT / "README.md"]
    done = set()
    while waiting:
        source = waiting.pop()
        if source in done:
            continue
        done.add(source)
        target = folder / source.relative_to(ROOT)
        target.parent.mkdir(parents=True, exist_ok=True)
        if source.suffix != ".md":
            shutil.copy(source, target)
            continue
        text = source.read_text(encoding="utf-8")
        # Words after the language of a block are for the tests of the page.
        target.write_text(FENCE.sub(r"```\1", text), encoding="utf-8")
        for link in LINK.findall(text):
            linked = (source.parent / link).resolve()
            if ":" not in link and linked.is_relative_to(ROOT) and linked.is_file():
                waiting.append(linked)


def c_reference(text: str) -> str:
    """include/asperity.h as a page: constants, structs and functions, with their comments."""
    header = declarations.parse(text)
    parts = [f"# C reference\n\n`include/asperity.h` of version {header.constants[0].value}.\n"]
    opening = text[text.index("/*") + 2 : text.index("*/")]
    # With four backticks, since it has examples in three.
    parts.append(f"````text\n{declarations.plain(opening)}\n````\n")
    parts.append("## Constants\n\n| | value | |\n|---|---|---|")
    parts += [f"| `{one.name}` | `{one.value}` | {cell(one.doc)} |" for one in header.constants]
    parts.append("\n## Structs\n")
    for struct in header.structs.values():
        parts.append(f"### {struct.name}\n\n{markdown(struct.doc)}\n\n| field | type | |\n|---|---|---|")
        parts += [f"| `{one.name}` | `{one.type}{f'[{one.count}]' if one.count else ''}` | {cell(one.doc)} |" for one in struct.fields]
        parts.append("")
    parts.append("## Functions\n")
    for function in header.functions:
        parts.append(f"### {function.name}\n\n```c\n{function.declaration}\n```\n\n{markdown(function.comment)}\n")
    return "\n".join(parts) + "\n"


def markdown(comment: str) -> str:
    """A comment as paragraphs, its tags as a list."""
    text = re.sub(r"(?m)^@param\s+(\S+)\s+", r"- **\1**: ", comment)
    text = re.sub(r"(?m)^@return\s+", "\n**Returns** ", text)
    return re.sub(r"([^\n])\n(- \*\*)", r"\1\n\n\2", text, count=1)


def main(folder: Path) -> None:
    shutil.rmtree(folder, ignore_errors=True)
    gather(folder / "guide")
    shutil.copy(ROOT / "js" / "dist" / "explorer.html", folder / "explorer.html")
    shutil.copy(Path(__file__).with_name("site.css"), folder / "site.css")
    (folder / "index.md").write_text(home((ROOT / "README.md").read_text(encoding="utf-8")), encoding="utf-8")
    (folder / "guide" / "docs" / "explorer.md").write_text(EXPLORER, encoding="utf-8")
    reference = folder / "reference"
    reference.mkdir()
    header = (ROOT / "include" / "asperity.h").read_text(encoding="utf-8")
    (reference / "c.md").write_text(c_reference(header), encoding="utf-8")
    (reference / "python.md").write_text(PYTHON, encoding="utf-8")
    (reference / "rust.md").write_text(RUST, encoding="utf-8")


def home(readme: str) -> str:
    """The front page of the repository as that of the site: its picture comes first, then two buttons, and its links lead to the guide."""
    title, words, picture, rest = readme.split("\n\n", 3)
    text = "\n\n".join([title, picture, "BUTTONS", words, rest])
    return LINK.sub(lambda link: link[0].replace("](", "](guide/", 1) if ":" not in link[1] else link[0], text).replace("BUTTONS", BUTTONS, 1)


BUTTONS = """\
[Open the explorer](explorer.html){ .md-button .md-button--primary } [Install](guide/docs/install.md){ .md-button }"""
EXPLORER = """# Explorer

[Open it](../../explorer.html){ .md-button .md-button--primary } in this browser; nothing is sent anywhere.
[javascript.md](javascript.md#the-explorer) says what it computes.

[![The explorer](figures/explorer.png)](../../explorer.html)
"""

# What people use first; then the rest of the package; then its modules.
FIRST = ("friction", "Model", "Params")
MODULES = (
    ".materials", ".surface", ".studies.pads", ".fits.fit", ".fits.uncertainty", ".study", ".loads", ".table", ".jax", ".warp",
    ".mujoco", ".kratos",
)
REST = f"\n    options:\n      filters: ['!^_', '!^({'|'.join(FIRST)})$']"
PYTHON = "# Python reference\n\n[python.md](../guide/docs/python.md) is the guide.\n\n" + "".join(
    f"::: asperity{name}\n\n" for name in (*(f".{name}" for name in FIRST), REST, *MODULES)
)

# HTML, since the link leads out of MkDocs' pages; docs/site/check_links.py follows it.
RUST = """# Rust reference

<a href="../rust/asperity/index.html">The crate</a>, as `cargo doc` writes it.
"""

if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve())
