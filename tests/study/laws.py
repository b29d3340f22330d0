"""The wall's law reaches the solver: a tube pulled with S = C:E or the neo-Hookean law answers as a
bar of that law does.
Usage: laws.py SOURCE_FOLDER VASOROD."""

import math
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(sys.argv[1]) / "benchmarks" / "study"))
import laws  # noqa: E402
from cases import case_named  # noqa: E402
from measure import converged, moved_end, norm, result_of  # noqa: E402
from store import Store  # noqa: E402

with tempfile.TemporaryDirectory() as scratch:
    store = Store(scratch, {"vasorod": sys.argv[2]})
    case = case_named("stretch_t1_1.05")
    force = {}
    for law in laws.LAWS:
        run = laws.coupled(case, law)
        assert converged(store, store.ensure(run)), law
        force[law] = norm(moved_end(result_of(store, run.identity))[0])
    stretch = 1.05  # E l (l^2 - 1) / 2 over E (l - 1); the glued ends are held in either law
    assert abs(force["svk"] / force["biot"] - stretch * (stretch + 1) / 2) < 3e-3, force
    # mu (l - 1/l) + lambda ln J / l over E (l - 1), with no lateral stress: nu 0.3, l 1.05
    mu, lame, across = 1 / 2.6, 0.6 / 2.6 / 0.4, 1.0
    for _ in range(50):
        lateral = mu * (across**2 - 1) + lame * math.log(stretch * across**2)
        across -= lateral / (2 * mu * across + 2 * lame / across)
    pull = mu * (stretch - 1 / stretch) + lame * math.log(stretch * across**2) / stretch
    assert abs(force["neo-hookean"] / force["biot"] - pull / (stretch - 1)) < 3e-3, force

for case in map(case_named, laws.CASES):
    runs = laws.all_runs(case)
    assert len({run.identity for run in runs}) == len(runs) == 2 * len(laws.LAWS), case.name
    assert [
        run.arguments[run.arguments.index("--law") + 1]
        for run in runs
        if run.program == "vasorod-fem"
    ] == list(laws.LAWS)
assert laws.all_runs(case_named("bend_t2_0.9")) == []
