"""What is wrong with a written page: read from its HTML and the files beside it, by no code of the
page's own."""

import json
import re
from html.parser import HTMLParser

import yaml


class Page(HTMLParser):
    """Pictures, links, panels, and the numbers with the file and key they claim to come from."""

    def __init__(self, text):
        super().__init__()
        self.pictures, self.links, self.panels, self.numbers = [], [], [], []
        self._number = None
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        if tag == "img":
            self.pictures.append(attrs["src"])
        if "href" in attrs:
            self.links.append(attrs["href"])
        if tag == "section":
            self.panels.append(attrs["id"])
        if "data-key" in attrs:
            self._number = attrs

    def handle_data(self, data):
        if self._number is not None:
            self.numbers.append((self._number, data))
            self._number = None


def number_fault(folder, claim, shown):
    value = json.loads((folder / claim["data-file"]).read_text())
    for word in claim["data-key"].split("/"):
        value = value[int(word)] if isinstance(value, list) else value[word]
    expected = value * float(claim["data-times"])
    found = float(shown.replace(",", ""))
    right = abs(found - expected) <= 6e-4 * abs(expected)  # four digits; zero must be zero
    return None if right else f"{claim['data-file']} {claim['data-key']}: {shown}, not {expected}"


def faults(folder):
    text = (folder / "index.html").read_text()
    page, found = Page(text), []
    for file in (*page.pictures, *page.links):
        if not (folder / file).is_file():
            found.append(f"{file} is not there")
    if re.search(r"(https?:)?//\w", text) or "@import" in text or "<script" in text:
        found.append("the page needs something from elsewhere")
    found += [fault for one in page.numbers if (fault := number_fault(folder, *one))]
    listed = yaml.safe_load((folder / "codecheck.yml").read_text())["manifest"]
    files = [entry["file"] for entry in listed]
    found += [
        f"{file} of the manifest is not there" for file in files if not (folder / file).is_file()
    ]
    found += [f"{one['file']} has no command" for one in listed if not one.get("command")]
    wanted = {"index.html", *page.pictures, *(claim["data-file"] for claim, _ in page.numbers)}
    if wanted != set(files) or len(files) != len(set(files)):
        found.append(f"page and manifest differ: {sorted(wanted ^ set(files))}")
    return found
