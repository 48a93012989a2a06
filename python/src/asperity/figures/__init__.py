"""The figures of Adams and Müftü (2005), section 3, and the page that compares them with what the paper says; and the
figures of where the model is valid.

`curves` has the surfaces behind each figure, `drawing` the pictures, `page` the comparison in numbers. `contacts` has
real contacts and `measured` measured friction, both drawn by `validity`; `calibrated` has the model calibrated at one
load against measurements at others, drawn by `front`.
Drawing needs matplotlib (extra `plot`).
"""

from __future__ import annotations

from pathlib import Path

from .. import _output
from . import drawing, page


def write(directory: Path) -> list[Path]:
    """Writes the page `dev/gallery.md` and the pictures `figures/*.svg` below a directory; returns the files.

    What is written depends on the library and, in the pictures, on matplotlib's version alone: no dates, no chance.

    Raises:
        ImportError: matplotlib is missing.
        OSError: a file cannot be written.
    """
    pictures = directory / "figures"
    pictures.mkdir(parents=True, exist_ok=True)
    files = drawing.draw_all(pictures)
    gallery = directory / "dev" / "gallery.md"
    gallery.parent.mkdir(exist_ok=True)
    _output.write(gallery, page.text())
    return [*files, gallery]
