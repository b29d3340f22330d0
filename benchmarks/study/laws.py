"""Separates the effect of the wall's law from that of the hybrid's kinematics: `coupled` against
the shell of the same law, and the shell of another law against the shell of Biot's. The two are
never added up."""

from cases import case_named
from measure import outcome
from runs import hybrid, reference
from tables import provenance, write_table

CASES = (
    "stretch_t1_1.05",
    "stretch_t1_1.2",
    "twist_t1_0.5",
    "bend_t1_0.25",
    "bend_t1_0.5",
    "combined_t1_0.5",
    "curved_t1_0.5",
)
LAWS = ("biot", "svk", "neo-hookean")
COLUMNS = ("rms", "largest", "force", "moment", "reaction_signed", "u_shape", "u_reaction")


def shell(case, law):
    return reference(case, "shell", 4, (8, 12), 1, law=law)


def coupled(case, law):
    if law == "biot":
        return hybrid(case, "coupled", 48)
    changed = case.changed()
    changed.scene["vessels"][0]["law"] = law
    return hybrid(changed, "coupled", 48, tag=f"-{law}")


def all_runs(case):
    return (
        [*(shell(case, law) for law in LAWS), *(coupled(case, law) for law in LAWS)]
        if case.name in CASES
        else []
    )


def make_table(store, path):
    rows, records = [], []
    for case in map(case_named, CASES):
        pairs = [("kinematics", law, coupled(case, law), shell(case, law)) for law in LAWS]
        pairs += [
            ("law", law, shell(case, law), shell(case, "biot")) for law in LAWS if law != "biot"
        ]
        for difference, law, one, other in pairs:
            both = [store.record(run.identity) for run in (one, other)]
            if None in both:
                continue
            records += both
            rows.append(
                {
                    "case": case.name,
                    "difference": difference,
                    "law": law,
                    **outcome(store, case, one, other, COLUMNS),
                }
            )
    if rows:
        write_table(
            path,
            rows,
            [
                (
                    "Kinematics: coupled against the shell of the same law. Law: the shell of that"
                    " law against the shell of Biot's"
                ),
                *provenance(records),
            ],
        )
