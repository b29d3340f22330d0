"""CSV files with their provenance in comment lines at the top: what made them, with which programs,
at which commits."""

import csv
import io
import textwrap
from pathlib import Path

IMAGES = "images/comparison"  # the pictures' folder beside docs/comparison.md


def number(text):
    try:
        return float(text)
    except ValueError:
        return text


def shown(value):
    if value is None:
        return ""
    if isinstance(value, float):
        return f"{value:.0f}" if value.is_integer() and abs(value) < 1e15 else f"{value:.6g}"
    return str(value)


def provenance(records):
    """One line per program: its hash, the commits it was run at, how many different runs."""
    seen = {}
    for record in {record["identity"]: record for record in records}.values():
        entry = seen.setdefault((record["program"], record["program_sha256"][:12]), [set(), 0])
        entry[0].add(record["commit"])
        entry[1] += 1
    return [
        f"{name} {digest}: {count} runs at {', '.join(sorted(commits))}"
        for (name, digest), (commits, count) in sorted(seen.items())
    ]


def provenance_text(notes):
    """A read table's provenance below what is made from it."""
    return paragraph("Made from: " + "; ".join(notes[1:]) + ".")


def write_table(path, rows, notes=()):
    """rows: dictionaries with the same keys; notes: the comment lines."""
    out = io.StringIO()
    for note in notes:
        out.write(f"# {note}\n")
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(rows[0])
    for row in rows:
        writer.writerow(map(shown, row.values()))
    Path(path).parent.mkdir(parents=True, exist_ok=True)
    Path(path).write_text(out.getvalue())


def read_table(path):
    """The rows as dictionaries, numbers as numbers, empty cells as None; and the comment lines."""
    lines = Path(path).read_text().splitlines()
    notes = [line[2:] for line in lines if line.startswith("# ")]
    rows = [
        {key: None if text == "" else number(text) for key, text in row.items()}
        for row in csv.DictReader(line for line in lines if not line.startswith("#"))
    ]
    return rows, notes


def extended(path, keys, plan, rows, notes):
    """The table at `path` with `rows` in the place of those with the same `keys`, in the order of
    `plan` (a list of the keys' values), and its comment lines: so a plan can grow without all of it
    being run again. A row that is no longer in the plan is left out."""

    def as_read(values):  # a name that is a number is read as one
        return tuple(number(one) if isinstance(one, str) else one for one in values)

    def by_keys(some):
        return {as_read(row[key] for key in keys): row for row in some}

    old_rows, old_notes = read_table(path) if Path(path).exists() else ([], [])
    fresh, old = by_keys(rows), by_keys(old_rows)
    merged = []
    for values in map(as_read, plan):
        if values in fresh:
            merged.append(fresh[values])
        elif values in old:
            merged.append({name: old[values].get(name) for name in rows[0]})
    kept = len(merged) - len(fresh)
    return merged, [*notes, *(f"{kept} rows from before, {note}" for note in old_notes[1:] if kept)]


def write_extended(path, keys, plan, rows, records, note):
    """`rows` and what made them, in the table that was there before; nothing without rows."""
    if rows:
        write_table(path, *extended(path, keys, plan, rows, [note, *provenance(records)]))


def replace_rows(path, keys, rows, note):
    """Puts `rows` in the place of the table's rows with the same `keys`, and `note` below its
    comment lines. Columns that only the new rows have are empty in the others."""
    old, notes = read_table(path)
    fresh = {tuple(row[key] for key in keys): row for row in rows}
    columns = list(old[0]) + [name for name in rows[0] if name not in old[0]]
    if "failure" in columns:  # the last column of every table that has it
        columns.append(columns.pop(columns.index("failure")))
    merged = [fresh.get(tuple(row[key] for key in keys), row) for row in old]
    write_table(path, [{name: row.get(name) for name in columns} for row in merged], [*notes, note])


def value_or_range(values, form):
    low, high = form(min(values)), form(max(values))
    return low if low == high else f"{low} to {high}"


def paragraph(*parts):
    """Text of a page in lines of at most 100 columns."""
    text = " ".join(parts)
    return textwrap.fill(text, 100, break_long_words=False, break_on_hyphens=False) + "\n"


def markdown(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + " --- |" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows]) + "\n"


def outcomes(head, rows, start, numbers):
    """A table with a line per row: start(row), then numbers(row), or why the run has none."""

    def line(row):
        first = start(row)
        if row["failure"]:
            return [*first, row["failure"], *["-"] * (len(head) - len(first) - 1)]
        return [*first, *numbers(row)]

    return markdown(head, [line(row) for row in rows])


def percent(value, digits=2):
    """A share in percent; "-" where there is none."""
    return "-" if value is None else f"{100 * value:.{digits}f}"


def signed(value):
    """A difference in percent, always with its sign; "-" where there is none."""
    return "-" if value is None else f"{100 * value:+.2f}"
