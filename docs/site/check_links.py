"""Checks a built site:

    check_links.py FOLDER

Every link of every page leads to a file of the site and, where it has one, to an anchor in it.
Nothing that a browser loads by itself (scripts, styles, pictures, fonts) comes from another
machine.
Links to other sites are not followed.
"""

import sys
from functools import lru_cache
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

LOADED = {("script", "src"), ("img", "src"), ("iframe", "src"), ("source", "src"), ("link", "href")}
# what a browser does not load: a name of the page's own address, and of its neighbours
NAMES_ONLY = {"canonical", "next", "prev", "edit"}


class Page(HTMLParser):
    """The anchors of one page and its links: (address, whether it is loaded by itself)."""

    def __init__(self):
        super().__init__()
        self.anchors, self.links = set(), []

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        self.anchors.update(values[key] for key in ("id", "name") if values.get(key))
        for key in ("href", "src"):
            if values.get(key):
                loaded = (tag, key) in LOADED and values.get("rel") not in NAMES_ONLY
                self.links.append((values[key], loaded))


@lru_cache(maxsize=None)
def read(path):
    page = Page()
    page.feed(path.read_text())
    return page


def fault(root, path, address, loaded):
    """What is wrong with a link, or None."""
    parts = urlsplit(address)
    if parts.scheme in ("http", "https") or parts.netloc:
        return "is loaded from another machine" if loaded else None
    if parts.scheme:  # data:, mailto:, javascript:
        return None
    target = path if not parts.path else (path.parent / unquote(parts.path)).resolve()
    if target.is_dir():
        target = target / "index.html"
    if not target.is_file() or root not in target.parents:
        return "leads to nothing"
    anchor = unquote(parts.fragment)
    if anchor and target.suffix == ".html" and anchor not in read(target).anchors:
        return "leads to a page that has no such anchor"
    return None


def main():
    root = Path(sys.argv[1]).resolve()
    found, count = [], 0
    paths = sorted(path for path in root.rglob("*.html") if path.name != "404.html")
    for path in paths:
        for address, loaded in read(path).links:
            count += 1
            if what := fault(root, path, address, loaded):
                found.append(f"{path.relative_to(root)}: {address} {what}")
    for path in root.rglob("*.css"):
        if "url(http" in path.read_text() or "url(//" in path.read_text():
            found.append(f"{path.relative_to(root)}: a style is loaded from another machine")
    print("\n".join(sorted(set(found))) or f"site: {len(paths)} pages, {count} links, all lead on")
    return 1 if found or not count else 0


if __name__ == "__main__":
    sys.exit(main())
