"""Surfaces read from a file, taken as the wall's middle, give what the generated tube gives.
Usage: irregular.py SOURCE_FOLDER VASOROD."""

import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(sys.argv[1]) / "benchmarks" / "study"))
import irregular  # noqa: E402
from cases import all_cases, case_named  # noqa: E402
from measure import converged, moved_end, norm, result_of, shapes  # noqa: E402
from runs import hybrid  # noqa: E402
from store import Store  # noqa: E402

with tempfile.TemporaryDirectory() as scratch:
    store = Store(scratch, {"vasorod": sys.argv[2]})
    case = case_named("bend_t1_0.25")
    structured = hybrid(case, "coupled", 48)
    for run in (structured, *irregular.all_runs(case)[1:]):
        assert converged(store, store.ensure(run)), run.identity
    for run, kind in list(zip(irregular.all_runs(case), irregular.MESHES))[1:]:
        text, angle = irregular.mesh_of(case, kind)
        assert (store.folder(run.identity) / "tube.vtp").read_text() == text and 5 < angle < 35, (
            kind,
            angle,
        )
        there, here = (result_of(store, one.identity) for one in (structured, run))
        assert here["model"]["vertices"] > 3000, kind
        # 2 % of the displacement's scale: an outer surface taken for the middle would answer 20 %
        # stiffer
        assert abs(norm(moved_end(here)[1]) / norm(moved_end(there)[1]) - 1) < 0.02, kind
        assert shapes(store, run.identity, structured.identity, 10, 100)["rms"] < 2e-3, kind

assert (
    irregular.all_runs(case_named("tapered_t1_0.4")) == []
    and irregular.all_runs(case_named("twist_t2_90")) == []
)
covered = {case.name for case in all_cases() if irregular.all_runs(case)}
assert covered == {case.name for case in all_cases() if case.counted and case.family != "tapered"}
