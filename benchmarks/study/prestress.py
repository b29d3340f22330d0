"""Vessels that carry a stress as they were seen: tubes and T-joins from the pressure of a scan and
an axial prestretch, against the reference's 7-parameter shell of the same law."""

import yaml

import inflated
import join
from cases import text_of
from pressure import solved
from runs import Run, hybrid_arguments, reference_arguments
from tables import write_extended

LAW = "neo-hookean"
HELD = {"vessel": "tube", "end": "start", "hold": True}
# What the tube was seen with, and what happens to its other end. Of the released one, half of the
# prestretch's force goes on pulling at its end.
TUBES = {
    "inflate": ({"pressure": {"scan": 5, "after": 12}}, {"hold": True}),
    "bend": ({"pressure": {"scan": 10, "after": 10}}, inflated.LOADS["bend"]),
    "shorten": ({"axial_prestretch": 1.05}, {"move": [0, 0, -0.75]}),
    "release": (
        {"axial_prestretch": 1.05},
        {"fix": ["x", "y", "rx", "ry", "rz"], "force": [0, 0, 0.0855]},
    ),
    "both": (
        {"pressure": {"scan": 5, "after": 12}, "axial_prestretch": 1.05},
        {"rotate_deg": [10, 0, 0], "move": [0, -2.6, -1]},
    ),
    "deflate": ({"pressure": {"scan": 75, "after": 5}}, {"hold": True}),
    "far": (
        {"pressure": {"scan": 40, "after": 12}, "axial_prestretch": 1.2},
        {"rotate_deg": [10, 0, 0], "move": [0, -2.6, -4]},
    ),
}
FAR = {"deflate", "far"}  # seen far from the shape without stress
CURVED = {"inflate", "shorten", "deflate"}  # also of a bent and tapered tube
SHAPES = {"straight": {}, "curved": {"bend_deg": 40, "end_radius": 2.8}}
LAWS = {"inflate": ("biot", "svk", LAW), "deflate": ("biot", "svk", LAW)}  # the others: LAW alone
PRESSURES = {"vein": {"scan": 5, "after": 12}, "artery": {"scan": 15, "after": 12}}
JOINS = (("slit", 1.0), ("slit", 1.25), ("ellipse", 1.0))
PRESTRETCHES = (1.0, 1.05, 1.2)  # of the joins' vein and artery; the last as in FAR
AROUND = 60
CELLS = 16  # of the join's shell around the seam, and those refined by 3/2
FILES = ("prestress.csv", "prestress_joins.csv")


def tube_scene(case, shape, law):
    seen, moved = TUBES[case]
    tube = {**inflated.TUBE, **SHAPES[shape]}
    vessel = {"name": "tube", "tube": tube, "wall": inflated.WALL, "law": law, **seen}
    return {
        "scene": f"prestress_{case}_{shape}_{law}",
        "units": {"length": "mm", "stress": "MPa", "pressure": "mmHg"},
        "vessels": [vessel],
        "ends": [HELD, {"vessel": "tube", "end": "end", **moved}],
        "fidelity": "coupled",
    }


def join_scene(opening, length, stretch):
    made = yaml.safe_load(join.scene(opening, 1.0, LAW, AROUND, length))
    made["units"]["pressure"] = "mmHg"
    for vessel in made["vessels"]:
        vessel["pressure"] = PRESSURES[vessel["name"]]
        if stretch != 1:
            vessel["axial_prestretch"] = stretch
    return made


def pair(name, scene, around, cells):
    """The hybrid's run and the shell's, which is kept when the program is rebuilt."""
    files = {"scene.yaml": text_of(scene)}
    return (
        Run(f"{name}/coupled-{around}", "vasorod", hybrid_arguments("coupled"), files),
        Run(
            f"{name}/shell-{cells[0]}x{cells[1]}",
            "vasorod-fem",
            reference_arguments("shell", cells, 1),
            files,
            keep=True,
        ),
    )


def tube_pairs():
    """(case, shape, law, run, the shell it is measured against)"""
    for case in TUBES:
        for shape in SHAPES if case in CURVED else ("straight",):
            for law in LAWS.get(case, (LAW,)) if shape == "straight" else (LAW,):
                name = f"prestress-{case}-{shape}-{law}"
                scene = tube_scene(case, shape, law)
                yield case, shape, law, *pair(name, scene, AROUND, inflated.CELLS)


def join_pairs():
    """(opening, length, stretch, run, the shell it is measured against)"""
    for opening, length in JOINS:
        for stretch in PRESTRETCHES if length == 1 else (1.0,):
            name = f"prestress-{opening}-l{length:g}-s{stretch:g}"
            scene = join_scene(opening, length, stretch)
            yield opening, length, stretch, *pair(name, scene, AROUND, (CELLS, 0))


def all_runs():
    return [run for pairs in (tube_pairs(), join_pairs()) for one in pairs for run in one[-2:]]


COLUMNS = ("rms", "largest", "force", "moment", "energy", "own_error")


def tube_rows(store):
    named = (
        ({"case": case, "shape": shape, "law": law}, *both)
        for case, shape, law, *both in tube_pairs()
    )
    rows, records = inflated.tube_rows(store, named, COLUMNS)
    for row in rows:
        if row["case"] == "release":  # its load alone says what the held end carries
            row |= {"force": None, "moment": None}
    return rows, records


def make_tables(store, folder):
    note = "Tubes with a stress as they were seen, against the reference's shell: RMS over R,"
    note += " force and moment over the larger reaction, energy over the shell's less 1"
    keys, plan = ("case", "shape", "law"), [pair[:3] for pair in tube_pairs()]
    write_extended(folder / FILES[0], keys, plan, *tube_rows(store), note)
    keys, plan = ("opening", "length", "stretch"), list(join_pairs())
    named = ((dict(zip(keys, one)), *one[-2:]) for one in plan)
    note = "The T-join with a vein seen at 5 and an artery at 15 mmHg, both at 12 afterwards,"
    note += " neo-hookean, against the reference's shell; columns as in join.csv"
    found = join.measured(store, named, solved)
    write_extended(folder / FILES[1], keys, [one[:3] for one in plan], *found, note)
