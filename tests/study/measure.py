"""Errors between two results with known differences: `skin` of a tube against the same tube
computed by hand.
Usage: measure.py SOURCE_FOLDER VASOROD."""

import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(sys.argv[1]) / "benchmarks" / "study"))
from cases import case_named  # noqa: E402
from measure import moved_end, outcome, own_error, reactions, result_of, shapes  # noqa: E402
from runs import hybrid  # noqa: E402
from store import Store  # noqa: E402

# one reaction against another: |F| = 3, |M|/R = 2, so S = 3
result = {"ends": [None, {"force": [3.3, 0, 0], "moment": [0, 20, 0]}]}
reference = {"ends": [None, {"force": [3.0, 0, 0], "moment": [0, 20, 6]}]}
errors = reactions(result, reference, 10)
assert abs(errors["force"] - 0.1) < 1e-12 and abs(errors["moment"] - 0.2) < 1e-12, errors
# along (3, 2, 0.6): 3.3*3 + 2*2 over 9 + 4 + 0.36
assert abs(errors["reaction_signed"] - (13.9 / 13.36 - 1)) < 1e-12, errors
notes = {
    "certificate": {
        "notes": [
            "law: biot",
            "u_num of displacements over R (RMS): 1.91e-04 (GCI, r = 1.5)",
            "u_num of reactions, relative: 8.71e-04 (GCI",
        ]
    }
}
assert own_error(notes) == {"u_shape": 1.91e-4, "u_reaction": 8.71e-4}
assert own_error({"certificate": {"notes": []}}) == {"u_shape": None, "u_reaction": None}


class Endings:
    """A store of runs that ended one way or another."""

    def record(self, identity):
        return {
            "reference": {"exit": 0},
            "refused": {"exit": 2, "sentence": "found 3, expected 4"},
            "killed": {"exit": -9, "sentence": ""},
        }[identity]


class Named:
    def __init__(self, identity):
        self.identity = identity


for pair, sentence in (
    (("refused", "reference"), "found 3, expected 4"),
    (("reference", "killed"), "exit -9"),
):  # whichever of the two it was
    assert outcome(Endings(), None, *map(Named, pair), ("rms", "force")) == {
        "rms": None,
        "force": None,
        "failure": sentence,
    }, pair

with tempfile.TemporaryDirectory() as scratch:
    store = Store(scratch, {"vasorod": sys.argv[2]})
    case = case_named("stretch_t1_1.05")
    further = case.changed(study_end={"move": [0, 0, 10]})
    runs = [hybrid(case, "skin", 24), hybrid(further, "skin", 24, tag="-further")]
    for run in runs:
        record = store.ensure(run)
        assert record["exit"] == 0, record
    # the second is pulled twice as far: displacements differ by 5 z / L, by 5 at the end and
    # 5 / sqrt(3) RMS; R = 10, L = 100
    errors = shapes(store, runs[0].identity, runs[1].identity, 10, 100)
    assert (
        abs(errors["largest"] - 0.5) < 1e-9 and abs(errors["rms"] * 10 * 3**0.5 / 5 - 1) < 1e-3
    ), errors
    assert (
        abs(errors["centerline_largest"] - 0.05) < 1e-9
        and abs(errors["centerline_rms"] - 0.05 / 3**0.5) < 1e-4
    ), errors
    # the rod is linear in stretch: twice the force
    ratio = (
        moved_end(result_of(store, runs[1].identity))[0][2]
        / moved_end(result_of(store, runs[0].identity))[0][2]
    )
    assert abs(ratio - 2) < 1e-9, ratio
