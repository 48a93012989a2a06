"""Writes the gallery: `python docs/gallery [DIR]`, the page DIR/dev/gallery.md and the pictures DIR/figures/*.svg.

DIR is docs by default. What is written depends on the library and, in the pictures, on matplotlib's version alone. Needs the
package with the extra `plot`.
"""

from __future__ import annotations

import sys
from pathlib import Path

DOCS = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(DOCS))

from gallery import drawing, page  # noqa: E402


def main(directory: Path) -> None:
    pictures, text = directory / "figures", directory / "dev" / "gallery.md"
    for folder in (pictures, text.parent):
        folder.mkdir(parents=True, exist_ok=True)
    files = drawing.draw_all(pictures)
    text.write_text(page.text(), encoding="utf-8", newline="\n")
    print(f"wrote {len(files)} pictures and {text}")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else DOCS)
