"""The fenced code blocks of a Markdown page."""

import re
from dataclasses import dataclass

FENCE = re.compile(r"^( *)```(\S*)\s*$")
NOTE = re.compile(r"^ *<!-- (not run|needs):? (.+?) -->\s*$")


@dataclass
class Block:
    """One block: its tag (sh, yaml, text, ...), its text without the indentation of a list, the
    line it begins in, and the note in the comment before it: `not run: REASON` or
    `needs THING and THING`.
    """

    tag: str
    text: str
    line: int
    not_run: str = ""
    needs: tuple = ()


def blocks_of(page):
    """All blocks of a page's text, in its order."""
    found, note, start = [], None, None
    for number, line in enumerate(page.splitlines(), 1):
        fence = FENCE.match(line)
        if start is None and fence:
            start, indent, lines = Block(fence[2], "", number), len(fence[1]), []
            if note and note[1] == "needs":
                start.needs = tuple(note[2].split(" and "))
            elif note:
                start.not_run = note[2]
        elif start is not None and fence and not fence[2]:
            start.text = "".join(f"{text[indent:]}\n" for text in lines)
            found.append(start)
            start, note = None, None
        elif start is not None:
            lines.append(line)
        elif line.strip():
            note = NOTE.match(line)
    if start is not None:
        raise ValueError(f"line {start.line}: the block has no end")
    return found
