"""The limits of each solver: groups of the rod as `rod_extremes` prints them, one run for each wall
scene of extremes/wall_extremes.py, and the ends of the reference runs in the sensitivity sweeps and
outside the range of the model. Written to docs/extremes.md."""

import re
import sys

from measure import result_of
from runs import Run, hybrid_arguments
from store import REPOSITORY
from tables import (
    markdown,
    paragraph,
    provenance,
    provenance_text,
    read_table,
    value_or_range,
    write_table,
)

sys.path.insert(0, str(REPOSITORY / "benchmarks" / "extremes"))
import wall_extremes  # noqa: E402

TIME_LIMIT = 120  # seconds a run may take
MOST_COUPLED = (
    100_000  # vertices: the factor of more does not fit beside other programs on a small machine
)


def rod_run():
    return Run("extremes/rod", "rod_extremes", (), {})


def wall_run(case, fidelity):
    name = re.sub(r"[^A-Za-z0-9.+-]+", "_", f"{case.family}-{case.name}")
    return Run(
        f"extremes/{fidelity}-{name}",
        "vasorod",
        (*hybrid_arguments(fidelity), "--time-limit", str(TIME_LIMIT)),
        {"scene.yaml": case.scene},
    )


def wall_cases():
    return [
        (case, fidelity)
        for case in wall_extremes.cases()
        for fidelity in case.fidelities
        if not (
            fidelity == "coupled" and case.family == "vertices" and int(case.name) > MOST_COUPLED
        )
    ]


def all_runs():
    return [rod_run(), *(wall_run(*pair) for pair in wall_cases())]


def rod_rows(text):
    """The table rod_extremes prints: a row per group."""
    rows = []
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if line.startswith("|") and len(cells) == 7 and cells[2].isdigit():
            rows.append(
                {
                    "group": cells[0],
                    "range": cells[1],
                    "cases": int(cells[2]),
                    "certified": int(cells[3]),
                    "most_iterations": cells[4],
                    "seconds": float(cells[5]),
                    "other": None if cells[6] == "-" else cells[6],
                }
            )
    return rows


def ending_of(store, record):
    """(how the run ended, its sentence): a status, `refused` with one sentence, or `failed`."""
    if record["exit"] == 2:
        return "refused", record["sentence"]
    if record["exit"] not in (0, 1):
        return "failed", f"exit code {record['exit']} {record['sentence']}"
    result = result_of(store, record["identity"])
    checked = {key: result[key] for key in ("ends", "balance", "energy", "metrics")}
    if result["status"] not in wall_extremes.STATUSES or not wall_extremes.finite(checked):
        return "failed", "a number that is not finite"
    return result["status"], "; ".join(result["certificate"]["notes"])


def make_tables(store, baselines):
    record = store.record(rod_run().identity)
    if record is not None:
        rows = rod_rows((store.folder(record["identity"]) / "output.txt").read_text())
        write_table(
            baselines / "extremes_rod.csv",
            rows,
            ["The rod solver pushed, a line per group of cases", *provenance([record])],
        )
    rows, records = [], []
    found = [
        (case, fidelity, store.record(wall_run(case, fidelity).identity))
        for case, fidelity in wall_cases()
    ]
    unfinished = {(case.family, fidelity) for case, fidelity, record in found if record is None}
    for case, fidelity, record in found:
        if (case.family, fidelity) in unfinished:  # a share of some runs says nothing of the range
            continue
        records.append(record)
        ending, sentence = ending_of(store, record)
        rows.append(
            {
                "fidelity": fidelity,
                "family": case.family,
                "case": case.name,
                "ending": ending,
                "seconds": record["processor_seconds"],
                "peak_bytes": record["peak_bytes"],
                "sentence": sentence or None,
            }
        )
    if rows:
        write_table(
            baselines / "extremes_wall.csv",
            rows,
            [
                f"The walls pushed, a line per scene, {TIME_LIMIT} s each at most",
                *provenance(records),
            ],
        )


def share(part, whole):
    return f"{part} of {whole} ({100 * part / whole:.1f} %)"


def rod_section(rows, notes):
    lines = [
        [
            row["group"],
            row["range"],
            int(row["cases"]),
            int(row["certified"]),
            row["most_iterations"],
            f"{row['seconds']:.3f}",
            row["other"] or "-",
        ]
        for row in rows
    ]
    certified, cases = int(sum(row["certified"] for row in rows)), int(
        sum(row["cases"] for row in rows)
    )
    return [
        "## Rod\n",
        paragraph(
            f"Certified: {share(certified, cases)}. Certified means `converged`: the residual is",
            "small and the inertia of the true Hessian is that of a minimum.",
        ),
        markdown(
            (
                "group",
                "range tried",
                "cases",
                "certified",
                "most iterations (of)",
                "processor seconds",
                "ended otherwise",
            ),
            lines,
        ),
        provenance_text(notes),
    ]


def wall_section(rows, notes):
    lines, endings = [], []
    rows = [
        {**row, "case": f"{row['case']:.0f}" if isinstance(row["case"], float) else row["case"]}
        for row in rows
    ]  # numbers of vertices
    for fidelity, family in dict.fromkeys((row["fidelity"], row["family"]) for row in rows):
        mine = [row for row in rows if (row["fidelity"], row["family"]) == (fidelity, family)]
        good = [row for row in mine if row["ending"] == "converged"]
        bad = [row for row in mine if row["ending"] == "failed"]
        slowest = max(mine, key=lambda row: row["seconds"])
        lines.append(
            [
                fidelity,
                family,
                f"{mine[0]['case']} to {mine[-1]['case']}",
                len(mine),
                len(good),
                len(mine) - len(good) - len(bad),
                len(bad),
                f"{slowest['seconds']:.1f} s ({slowest['case']})",
                f"{max(row['peak_bytes'] for row in mine) / 2**20:.0f}",
            ]
        )
        endings += [
            [
                fidelity,
                f"{family}: {row['case']}",
                row["ending"],
                f"{row['seconds']:.1f}",
                row["sentence"] or "-",
            ]
            for row in mine
            if row["ending"] != "converged"
        ]
    good = sum(row["ending"] == "converged" for row in rows)
    left = dict.fromkeys(
        f"{fidelity}, {case.family}"
        for case, fidelity in wall_cases()
        if (fidelity, case.family) not in {(row["fidelity"], row["family"]) for row in rows}
    )
    missing = (
        [paragraph(f"Not run in full since the last change, so left out: {'; '.join(left)}.")]
        if left
        else []
    )
    return [
        "## Walls\n",
        paragraph(
            f"Whole programs on a tube with L / R = 10; `converged`: {share(good, len(rows))}.",
            "Past Brazier's curvature or the wrinkling twist, `buckled` and `unstable` are the",
            "right answers. Named otherwise: another status, or a refusal with one sentence.",
            "Failed: a crash, or a number that is not finite.",
        ),
        markdown(
            (
                "fidelity",
                "family",
                "range tried",
                "runs",
                "converged",
                "named otherwise",
                "failed",
                "slowest, processor time",
                "most MiB",
            ),
            lines,
        ),
        *missing,
        "### Every run that did not converge\n",
        markdown(("fidelity", "case", "ending", "s", "sentence"), endings),
        provenance_text(notes),
    ]


def reference_section(sensitivity, accuracy):
    """The shell over the sweep of the moduli, and every reference run of a case outside the range
    of the model that converged."""
    shell = [row for row in sensitivity if row["fidelity"] == "shell"]
    if not shell:
        return []
    lines = []
    for load, modulus in dict.fromkeys((row["load"], row["modulus"]) for row in shell):
        mine = [row for row in shell if (row["load"], row["modulus"]) == (load, modulus)]
        failed = [row for row in mine if row["force"] is None]
        worst = max(
            (row for row in mine if row["u_reaction"] is not None),
            key=lambda row: row["u_reaction"],
            default=None,
        )
        lines.append(
            [
                load,
                modulus,
                value_or_range([row["factor"] for row in mine], "{:g}".format),
                len(mine),
                len(mine) - len(failed),
                "; ".join(
                    f"x {row['factor']:g}: {row['failure'] or 'not converged'}" for row in failed
                )
                or "-",
                f"{worst['u_reaction']:.1g} at x {worst['factor']:g}" if worst else "-",
            ]
        )
    beyond = sorted(
        {
            (row["case"], row["reference"])
            for row in accuracy
            if not row["counted"] and row["reference"]
        }
    )
    text = [
        "## Reference\n",
        paragraph(
            "The 7-parameter shell with its moduli varied: how many runs converged on both meshes,",
            "and the largest error of the reaction that a run states.",
        ),
        markdown(
            (
                "load",
                "modulus",
                "factors",
                "runs",
                "converged",
                "ended otherwise",
                "largest stated error of the reaction",
            ),
            lines,
        ),
    ]
    if beyond:
        text.append(
            paragraph(
                "Outside the range of the hybrid model the reference converged on:",
                ", ".join(f"{case} ({run})" for case, run in beyond) + ".",
            )
        )
    return text


def write_page(baselines, docs, more=()):
    """`more`: further sections of the page."""
    text = [
        "# How far each solver was pushed\n",
        paragraph(
            "Written by `./run report` from `benchmarks/baselines`; no number here is typed by",
            "hand. The statuses are explained in [guide.md](guide.md).",
        ),
    ]
    for name, section in (("extremes_rod.csv", rod_section), ("extremes_wall.csv", wall_section)):
        if (baselines / name).exists():
            text += section(*read_table(baselines / name))
    text += reference_section(
        read_table(baselines / "sensitivity.csv")[0], read_table(baselines / "accuracy.csv")[0]
    )
    text += more
    (docs / "extremes.md").write_text("\n".join(text).rstrip() + "\n")
