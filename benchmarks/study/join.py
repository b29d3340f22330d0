"""The join: two generated tubes in a T, the vein's end on a slit or on an elliptic hole, or end to
end, against the reference's 7-parameter shell of the same law. Over thickness, mesh and length of
the incision."""

import copy

import yaml

import counts
from cases import text_of
from measure import converged, finished_rows, result_of, vessels_apart
from regression import accepted
from runs import Run, hybrid_arguments, reference_arguments
from store import REPOSITORY
from tables import read_table, replace_rows, write_extended

CASES = REPOSITORY / "benchmarks" / "cases"
OPENINGS = {  # the scene and what is added to its surgery
    "slit": (CASES / "glenn" / "tubes.yaml", {}),
    "ellipse": (CASES / "glenn" / "tubes.yaml", {"incision_shape": {"ellipse": 0.5}}),
    "end to end": (CASES / "end_to_end" / "tubes.yaml", {}),
}
THICKNESS = (1.0, 0.5, 0.25)  # factors on both walls
LAWS = ("biot", "neo-hookean")
AROUND = (40, 60, 80)  # points around the first vessel; the second's mesh is as fine
FINEST = 120  # of full thickness and neo-Hookean walls, for the order of convergence
LENGTHS = (1.0, 1.1, 1.2, 1.3, 1.4, 1.5)  # of a slit, over half the rim's perimeter
CELLS = 24  # of the shell around the seam, and those refined by 3/2
TOLERANCE = 0.005  # of a mouth's area and an energy in `check`
QUICK = (("slit", 1.0), ("ellipse", 0.5), ("end to end", 1.0))  # opening and thickness, neo-Hookean
FILE = "join.csv"
KEYS = ("opening", "thickness", "law", "length", "fidelity", "around")


def scene(opening, thickness, law, around, length):
    path, added = OPENINGS[opening]
    made = copy.deepcopy(yaml.safe_load(path.read_text()))
    (operation,) = made["surgery"].values()
    operation.update(added)
    if length != 1:
        operation["incision_length"] = length
    finer = around / made["vessels"][0]["tube"]["around"]
    for vessel in made["vessels"]:
        vessel["wall"]["thickness"] *= thickness
        vessel["law"] = law
        for key in ("around", "along"):
            vessel["tube"][key] = 2 * round(vessel["tube"][key] * finer / 2)
    return text_of(made)


def name_of(opening, thickness, length):
    return f"join-{opening.replace(' ', '_')}-t{thickness:g}-l{length:g}"


def hybrid_run(opening, thickness, law, fidelity="coupled", around=60, length=1.0):
    return Run(
        f"{name_of(opening, thickness, length)}/{fidelity}-{law}-{around}",
        "vasorod",
        hybrid_arguments(fidelity),
        {"scene.yaml": scene(opening, thickness, law, around, length)},
    )


def shell_run(opening, thickness, law, length=1.0):
    """Kept when the program is rebuilt, as the tube's references are."""
    return Run(
        f"{name_of(opening, thickness, length)}/shell-{law}-{CELLS}",
        "vasorod-fem",
        reference_arguments("shell", (CELLS, 0), 1),
        {"scene.yaml": scene(opening, thickness, law, 60, length)},
        keep=True,
    )


def pairs():
    """(opening, thickness, law, length, fidelity, around, run, the shell it is measured against)"""
    for opening in OPENINGS:
        for thickness in THICKNESS:
            for law in LAWS:
                shell = shell_run(opening, thickness, law)
                finest = (FINEST,) if thickness == 1 and law == "neo-hookean" else ()
                for around in (*AROUND, *finest):
                    run = hybrid_run(opening, thickness, law, around=around)
                    yield opening, thickness, law, 1.0, "coupled", around, run, shell
            run = hybrid_run(opening, thickness, "biot", "paper")
            shell = shell_run(opening, thickness, "biot")
            yield opening, thickness, "biot", 1.0, "paper", 60, run, shell
    for length in LENGTHS[1:]:
        run = hybrid_run("slit", 1.0, "neo-hookean", length=length)
        shell = shell_run("slit", 1.0, "neo-hookean", length=length)
        yield "slit", 1.0, "neo-hookean", length, "coupled", 60, run, shell


def all_runs():
    runs = {run.identity: run for pair in pairs() for run in pair[-2:]}
    return list(runs.values())


def distances(store, run, shell):
    """RMS distance of each vessel's material points over its radius, in the scene's order."""
    vessels = vessels_apart(store, run.identity, shell.identity)
    return [vessel["surface"]["rms"] for vessel in vessels]


def mouth_of(result):
    """The mouth of the operation, whichever it is."""
    return (result.get("glenn") or result["end_to_end"])["mouth"]


def support(result):
    """The largest force of a support."""
    return max(sum(x * x for x in end["force"]) ** 0.5 for end in result["ends"])


def numbers(store, run, shell):
    mine, its = result_of(store, run.identity), result_of(store, shell.identity)
    coupled = mine["fidelity"] == "coupled"
    # `paper` solves no rod of the artery and so states no support of it: nothing to compare with
    first, second = distances(store, run, shell) if coupled else (None, None)
    mouth = mouth_of(mine)
    energy = mine["energy"]["total"] if coupled else None
    return {
        "mouth": mouth["area"],
        "mouth_reference": mouth_of(its)["area"],
        "span": mouth["span"],
        "width": mouth["width"],
        "energy": energy,
        "energy_reference": its["energy"]["total"],
        "support": support(mine) if coupled else None,
        "support_reference": support(its),
        "rms_first": first,
        "rms_second": second,
        "own_error": its["discretisation"]["error_estimate"],
        "seconds": store.record(run.identity)["processor_seconds"],
        "seconds_reference": store.record(shell.identity)["processor_seconds"],
        **counts.counts_of(mine),
    }


COLUMNS = (
    *("mouth", "mouth_reference", "span", "width", "energy", "energy_reference", "support"),
    *("support_reference", "rms_first", "rms_second", "own_error", "seconds", "seconds_reference"),
    *counts.COLUMNS,
)


def measured(store, named_pairs, solved=converged):
    """Rows and records of the finished pairs. named_pairs: (what a row begins with, run, shell)."""
    return finished_rows(
        store, named_pairs, COLUMNS, lambda run, shell: numbers(store, run, shell), solved
    )


def make_table(store, path):
    plan = list(pairs())
    note = "Joins against the reference's shell of the same law: mouth in mm2, energy in N mm,"
    note += " largest support force in N, RMS over R, processor time in s; own_error is the shell's"
    named = ((dict(zip(KEYS, pair)), *pair[-2:]) for pair in plan)
    write_extended(path, KEYS, [pair[: len(KEYS)] for pair in plan], *measured(store, named), note)


def drifts(old_rows, new_numbers, tolerance=TOLERANCE):
    """Sentences of the mouths, energies and counts of `coupled` that moved; new_numbers: a row's as
    they are now, or None where the run does not converge."""
    found = []
    for row, now in zip(old_rows, new_numbers):
        what = f"join: {row['opening']}, thickness x {row['thickness']:g}, {row['law']}"
        what += f", length {row['length']:g}, {row['around']:g} around"
        if (now is None) != (row["failure"] is not None):
            found.append(f"{what}: {'does not converge' if now is None else 'converges'} now")
            continue
        for quantity in ("mouth", "energy") if now else ():
            change = now[quantity] / row[quantity] - 1
            if abs(change) > tolerance:
                found.append(f"{what}: {quantity} {row[quantity]} -> {now[quantity]}")
        for name, old, new, _ in counts.moved(row, now or {}):
            found.append(f"{what}: {name} {old:g} -> {new:g}")
    return found


def is_quick(row):
    return (
        (row["opening"], row["thickness"]) in QUICK
        and row["law"] == "neo-hookean"
        and row["around"] == min(AROUND)
    )


def now_of(store, rows, again=False):
    """Mouth, energy and counts of the rows as they are now; None where a run does not converge."""
    now = []
    for row in rows:
        run = hybrid_run(
            row["opening"],
            row["thickness"],
            row["law"],
            around=int(row["around"]),
            length=row["length"],
        )
        record = store.ensure(run, again)
        if not converged(store, record):
            now.append(None)
            continue
        result = result_of(store, run.identity)
        mouth, energy = mouth_of(result)["area"], result["energy"]["total"]
        now.append({"mouth": mouth, "energy": energy, **counts.counts_of(result)})
    return now


def checked_rows(path, quick):
    return [
        row
        for row in read_table(path)[0]
        if row["fidelity"] == "coupled" and (not quick or is_quick(row))
    ]


def accept_quick(store, baselines, reason):
    """Writes mouth, energy and counts of the rows that a quick check repeats, where they
    drifted."""
    path = baselines / FILE
    rows = checked_rows(path, quick=True)
    moved = [
        {**row, **now}
        for row, now in zip(rows, now_of(store, rows))
        if now is not None and drifts([row], [now])
    ]
    if moved:
        replace_rows(path, KEYS, moved, f"{len(moved)} rows {accepted(reason)}")


def check(store, baselines, quick=False, again=False):
    """True where no mouth, energy or count of `coupled` moved; else says which. Quick: one of each
    opening, 40 around."""
    path = baselines / FILE
    if not path.exists():
        return True
    rows = checked_rows(path, quick)
    found = drifts(rows, now_of(store, rows, again))
    for sentence in found:
        print(sentence)
    if not found:
        print(
            f"{len(rows)} joins of {FILE}: no mouth and no energy moved by {TOLERANCE:.1%}, and no"
            " count beyond its tolerance"
        )
    return not found
