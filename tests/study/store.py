"""The store runs once, again when something changed, measures what a child used, and keeps the
sentence of a failure.
Usage: store.py SOURCE_FOLDER VASOROD."""

import json
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(sys.argv[1]) / "benchmarks" / "study"))
from runs import Run  # noqa: E402
from store import Store, solve_seconds  # noqa: E402

PROGRAM = """#!/bin/sh
echo again >> ../../count
cat input >/dev/null
[ "$1" = fail ] && { echo 'first line'; echo 'program: found 3, expected 4' >&2; exit 2; }
exec {python} -c 'x = bytearray(50 << 20)
for k in range(3000000): pass'
"""

with tempfile.TemporaryDirectory() as scratch:
    scratch = Path(scratch)
    program = scratch / "program"
    program.write_text(PROGRAM.replace("{python}", sys.executable))
    program.chmod(0o755)

    def runs():
        return len((scratch / "count").read_text().splitlines())

    def run(word, text="a", keep=False):
        return Run("case/run", "program", (word,), {"input": text}, keep)

    def store():
        return Store(scratch / "results", {"program": program})

    (scratch / "results").mkdir()
    count = scratch / "results" / "count"
    program.write_text(program.read_text().replace("../../count", str(scratch / "count")))
    record = store().ensure(run("go"))
    assert record["exit"] == 0 and record["sentence"] == "" and runs() == 1
    assert record["peak_bytes"] > 50 << 20, record["peak_bytes"]
    assert 0.01 < record["user_seconds"] <= record["processor_seconds"], record
    assert (
        record["wall_seconds"] > 0.01
        and record["command"] == ["program", "go"]
        and len(record["program_sha256"]) == 64
    )
    assert store().ensure(run("go")) == record and runs() == 1, "a finished run was repeated"
    store().ensure(run("go"), again=True)
    assert runs() == 2
    store().ensure(run("go", "b"))
    assert runs() == 3, "another input, yet not run"
    failed = store().ensure(run("fail", "b"))
    assert (
        runs() == 4 and failed["exit"] == 2 and failed["sentence"] == "program: found 3, expected 4"
    ), failed
    assert (
        store().ensure(run("fail", "b")) == failed and runs() == 4
    ), "a recorded failure was repeated"
    program.write_text(program.read_text() + "# rebuilt\n")
    assert (
        store().ensure(run("fail", "b", keep=True)) == failed and runs() == 4
    ), "a kept run was repeated for a rebuilt program"
    store().ensure(run("fail", "b"))
    assert runs() == 5, "a rebuilt program, yet not run"
    thrice = store().ensure(run("go", "c"), repeats=3)
    assert (
        runs() == 8 and thrice["repeats"] == 3 and thrice["solve_seconds"] is None
    ), thrice  # this program writes no result
    assert (
        store().ensure(run("go", "c"), repeats=2) == thrice and runs() == 8
    ), "timed often enough, yet repeated"

    # what is no reading and no writing: half of one program's time, three quarters of the other's
    folder = scratch / "a run"
    (folder / "result").mkdir(parents=True)
    for name, seconds, share in (
        ("vasorod", {"read": 0.5, "fit": 1, "solve": 1, "write": 1.5, "total": 4}, 0.5),
        ("vasorod-fem", {"read": 0.5, "factor": 2, "solve": 3, "total": 4}, 0.75),
    ):
        (folder / "result" / "result.json").write_text(json.dumps({"seconds": seconds}))
        got = solve_seconds(
            folder, {"program": name, "processor_seconds": 2.0, "wall_seconds": 4.0}
        )
        assert abs(got - 2 * share) < 1e-12, (name, got)
