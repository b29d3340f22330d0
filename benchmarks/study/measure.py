"""How far one result is from the reference's: `vasorod compare` for shapes, result.json for
reactions and sections."""

import json
import math
import re
import subprocess


def result_of(store, identity):
    return json.loads((store.folder(identity) / "result" / "result.json").read_text())


def converged(store, record):
    """True where the run ended with a result whose status is converged."""
    return record is not None and record["exit"] == 0


def failure_of(store, record):
    """Why a run does not count: its status where it wrote a result (exit 1), else its sentence."""
    if record["exit"] == 1:
        return "status " + result_of(store, record["identity"])["status"]
    return record["sentence"] or f"exit {record['exit']}"


def norm(vector):
    return math.sqrt(sum(x * x for x in vector))


def moved_end(result):
    """Force and moment (about that end's centre) of the support at the moved end: the second of a
    case's ends."""
    end = result["ends"][1]
    return end["force"], end["moment"]


def reactions(result, reference, radius):
    """Force and moment differences over S = max(|F|, |M|/R) of the reference, and the signed
    relative difference of the whole reaction along the reference's own: positive where the model is
    stiffer."""
    (f, m), (F, M) = moved_end(result), moved_end(reference)
    scale = max(norm(F), norm(M) / radius)
    a, b = [*f, *(x / radius for x in m)], [*F, *(x / radius for x in M)]
    along = sum(x * y for x, y in zip(a, b)) / sum(y * y for y in b) - 1
    return {
        "force": norm([x - y for x, y in zip(f, F)]) / scale,
        "moment": norm([x - y for x, y in zip(m, M)]) / radius / scale,
        "reaction_signed": along,
    }


def own_error(reference):
    """The reference's own numerical error as it states it: of displacements (RMS over R) and of
    reactions (relative)."""
    notes = " ".join(reference["certificate"]["notes"])

    def value(what):
        found = re.search(rf"u_num of {what}[^:]*: ([0-9.e+-]+)", notes)
        return float(found.group(1)) if found else None

    return {"u_shape": value("displacements"), "u_reaction": value("reactions")}


def vessels_apart(store, a, b):
    """What `vasorod compare` says of each vessel of two results of one scene."""
    done = subprocess.run(
        [
            str(store.programs["vasorod"]),
            "compare",
            str(store.folder(a) / "result"),
            str(store.folder(b) / "result"),
            "--json",
        ],
        capture_output=True,
        text=True,
    )
    if done.returncode != 0:
        raise SystemExit(f"{a}, {b}: {done.stderr.strip()}")
    return json.loads(done.stdout)["vessels"]


def shapes(store, a, b, radius, length):
    """RMS and largest distance of material points over R (None without a surface), of the
    centerline over L; of a scene's first vessel."""
    vessel = vessels_apart(store, a, b)[0]
    surface, line = vessel["surface"], vessel["centerline"]
    to_length = vessel["radius"] / length
    return {
        "rms": surface and surface["rms"],
        "largest": surface and surface["largest"],
        "centerline_rms": line and line["rms"] * to_length,
        "centerline_largest": line and line["largest"] * to_length,
    }


def compared(store, case, run, reference_run):
    """All errors of one run against one reference run."""
    radius, length = case.tube["radius"], case.tube["length"]
    a, b = result_of(store, run.identity), result_of(store, reference_run.identity)
    has_surface = a["metrics"] and a["model"]["vertices"] > 0
    return {
        **shapes(store, run.identity, reference_run.identity, radius, length),
        **reactions(a, b, radius),
        "flattening": a["metrics"][0]["flattening"] if has_surface else None,
        "flattening_reference": b["metrics"][0]["flattening"],
        **own_error(b),
    }


def failed_of(store, records, solved=converged):
    """Why the first of these runs that has no solution has none; None where all have one."""
    failed = next((record for record in records if not solved(store, record)), None)
    return None if failed is None else failure_of(store, failed)


def finished_rows(store, named, columns, numbers, solved=converged):
    """Rows and records of what is finished. named: (what a row begins with, its runs). A row has
    `columns`, which numbers(*runs) gives where all its runs have a solution, the processor time of
    its first run, and `failure`."""
    rows, records = [], []
    for names, *runs in named:
        its = [store.record(one.identity) for one in runs]
        if None in its:
            continue
        records += its
        row = {**names, **dict.fromkeys(columns), "seconds": its[0]["processor_seconds"]}
        row["failure"] = failed_of(store, its, solved)
        if row["failure"] is None:
            row |= numbers(*runs)
        rows.append(row)
    return rows, records


def outcome(store, case, run, other, columns):
    """These columns of one run's errors against another's, and `failure`: where one of the two did
    not converge its sentence, and no numbers."""
    failure = failed_of(store, [store.record(one.identity) for one in (run, other)])
    if failure is not None:
        return {**dict.fromkeys(columns), "failure": failure}
    numbers = compared(store, case, run, other)
    return {**{name: numbers[name] for name in columns}, "failure": None}
