"""Baselines: has a curve moved, or what a solver does for it? `check` repeats the runs of a
baseline and names every number that drifted beyond its tolerance. `accept` takes the new numbers
and writes the reason into the file."""

import time

import counts
import sensitivity
from store import commit
from tables import extended, provenance, read_table, replace_rows, shown, write_table

TOLERANCE = 0.005  # of the largest value the same quantity takes on its curve
QUANTITIES = (
    "variation",
    "force",
    "moment",
    "energy",
    "bending_energy",
    "stretching_energy",
    "binding_energy",
    "flattening",
)
FILE = "sensitivity.csv"


def key(row):
    return row["load"], row["modulus"], row["fidelity"], float(f"{row['factor']:.4g}")


def drifts(old_rows, new_rows, tolerance=TOLERANCE):
    """[(key, quantity, old, new, drift)] beyond the tolerance; a number that came or went has drift
    None."""
    old = {key(row): row for row in old_rows}
    largest = {}
    for row in old_rows:
        for quantity in QUANTITIES:
            curve = (*key(row)[:3], quantity)
            largest[curve] = max(largest.get(curve, 0.0), abs(row[quantity] or 0.0))
    found = []
    for row in new_rows:
        before = old.get(key(row))
        if before is None:
            continue
        for quantity in QUANTITIES:
            a, b = before[quantity], row[quantity]
            if a is None and b is None:
                continue
            if a is None or b is None:
                found.append((key(row), quantity, a, b, None))
                continue
            # 1e-9 R: round-off of a shape that does not change at all
            scale = max(largest[(*key(row)[:3], quantity)], 1e-9)
            if abs(b - a) > tolerance * scale + 1e-9:
                found.append((key(row), quantity, a, b, (b - a) / scale))
        found += [(key(row), *moved) for moved in counts.moved(before, row)]
    return found


def new_rows(store, old_rows, quick, again):
    """The baseline's own points (hybrid only), run with the programs as they are now."""
    few = {float(f"{factor:.4g}") for factor in sensitivity.FEW}
    wanted = [
        row
        for row in old_rows
        if row["fidelity"] != "shell"
        and (not quick or (key(row)[3] in few and row["load"] in sensitivity.QUICK_LOADS))
    ]
    rows, records = [], []
    for row in wanted:
        load, modulus, fidelity = row["load"], row["modulus"], row["fidelity"]
        factor = min(sensitivity.FACTORS, key=lambda f, at=row["factor"]: abs(f - at))
        run = sensitivity.hybrid_run(load, modulus, factor, fidelity)
        base = sensitivity.hybrid_run(load, modulus, 1.0, fidelity)
        for one in (base, run):
            store.ensure(one, again)
        rows.append(sensitivity.point(store, load, modulus, factor, fidelity, run, base, records))
    return rows, records


def picture(found, old_rows, rows, path):
    """The curves with the largest drift, before and now."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    worst = {}
    for k, quantity, _, _, drift in found:
        size = abs(drift) if drift is not None else float("inf")
        worst[(*k[:3], quantity)] = max(worst.get((*k[:3], quantity), 0.0), size)
    curves = sorted(worst, key=worst.get, reverse=True)[:6]
    figure, axes = plt.subplots(2, 3, figsize=(12, 7), squeeze=False)
    for axis, (load, modulus, fidelity, quantity) in zip(axes.flat, curves):
        for name, table, style in (("baseline", old_rows, "o-"), ("now", rows, "x--")):
            mine = sorted(
                (row["factor"], row[quantity])
                for row in table
                if key(row)[:3] == (load, modulus, fidelity) and row.get(quantity) is not None
            )
            axis.semilogx([x for x, _ in mine], [y for _, y in mine], style, label=name)
        axis.set_title(f"{fidelity}, {load}: {quantity}", fontsize=9)
        axis.set_xlabel(f"factor on {modulus}")
        axis.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def check(store, baselines, quick=False, again=False, image=None):
    """True where nothing drifted; else says what did, and draws it where matplotlib is there."""
    old_rows, _ = read_table(baselines / FILE)
    rows, _ = new_rows(store, old_rows, quick, again)
    found = drifts(old_rows, rows)
    if not found:
        print(
            f"{len(rows)} points of {FILE}: no quantity moved by more than {TOLERANCE:.1%} of its"
            " curve's largest value, and no count beyond its tolerance"
        )
        return True
    print(
        f"{len(found)} numbers of {FILE} moved by more than {TOLERANCE:.1%} of their curve's"
        " largest value, counts beyond their own tolerance:"
    )
    for (load, modulus, fidelity, factor), quantity, a, b, drift in sorted(
        found, key=lambda f: -abs(f[4]) if f[4] is not None else float("-inf")
    )[:40]:
        shown = f"{drift:+.2%}" if drift is not None else "came or went"
        print(f"  {fidelity} {load}, {modulus} x {factor:g}: {quantity} {a} -> {b} ({shown})")
    if image is not None:
        try:
            picture(found, old_rows, rows, image)
            print(f"  drawn in {image}")
        except ImportError:
            print("  no picture: python3-matplotlib is not there")
    return False


def accepted(reason):
    """The comment line of a table whose numbers were taken anew."""
    return f"accepted {time.strftime('%Y-%m-%d', time.gmtime())} at {commit()}: {reason}"


def accept_quick(store, baselines, reason):
    """Writes the points that a quick check repeats, where they drifted or have counts for the first
    time."""
    old_rows, _ = read_table(baselines / FILE)
    rows, _ = new_rows(store, old_rows, quick=True, again=False)
    before = {key(row): row for row in old_rows}
    rows = [
        {**row, "factor": before[key(row)]["factor"]}
        for row in rows
        if drifts(old_rows, [row]) or before[key(row)].get("gradients") is None
    ]
    if rows:
        names = ("load", "modulus", "factor", "fidelity")
        replace_rows(baselines / FILE, names, rows, f"{len(rows)} points {accepted(reason)}")


def accept(store, baselines, reason):
    """Writes new curves; those that were not run stay, and so do the reasons given so far."""
    path = baselines / FILE
    earlier = (
        [note for note in read_table(path)[1] if note.startswith("accepted ")]
        if path.exists()
        else []
    )
    rows, records = sensitivity.make_rows(store)
    if not rows:
        return
    line = accepted(reason)
    note = "Moduli alone: variation is the RMS distance of material points to factor 1's shape"
    note += " over R, force and moment those at the moved end; law Biot"
    plan = [
        (load, modulus, fidelity, float(shown(factor)))
        for load in sensitivity.LOADS
        for modulus in sensitivity.MODULI
        for fidelity, factors in (
            *((name, sensitivity.FACTORS) for name in sensitivity.FIDELITIES),
            ("shell", sensitivity.REFERENCE_FACTORS),
        )
        for factor in factors
    ]
    rows = [{**row, "factor": float(shown(row["factor"]))} for row in rows]
    keys = ("load", "modulus", "fidelity", "factor")
    merged, notes = extended(path, keys, plan, rows, [note, *provenance(records)])
    notes = [one for one in notes if "accepted " not in one]
    write_table(path, merged, [*notes, *earlier, line])
