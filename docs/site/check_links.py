"""Every link and picture of the site leads to a file of it, and to a place in it that exists.

usage: python docs/site/check_links.py FOLDER      the pages; those of rustdoc are followed to, but checked by rustdoc
"""

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class Page(HTMLParser):
    """What a page refers to, and the places in it."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.links: set[str] = set()
        self.places: set[str] = set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        for name, value in attributes:
            if value and name in ("href", "src"):
                self.links.add(value)
            if value and (name == "id" or (tag, name) == ("a", "name")):
                self.places.add(value)


def main(folder: Path) -> None:
    pages = {path: Page(path) for path in sorted(folder.rglob("*.html")) if path.relative_to(folder).parts[0] != "rust"}
    wrong, count = [], 0
    for path, page in pages.items():
        for link in sorted(page.links):
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            count += 1
            target = path if not parts.path else (path.parent / unquote(parts.path)).resolve()
            if parts.path.startswith("/"):
                target = folder / parts.path.lstrip("/")
            if target.is_dir():
                target = target / "index.html"
            if not target.is_file():
                wrong.append(f"{path.relative_to(folder)}: {link}: no such file")
            elif parts.fragment and target in pages and unquote(parts.fragment) not in pages[target].places:
                wrong.append(f"{path.relative_to(folder)}: {link}: no such place")
    print(f"{len(pages)} pages, {count} links")
    if wrong or not count:
        sys.exit("\n".join(wrong) or "docs/site/check_links.py: no links")


main(Path(sys.argv[1]).resolve())
