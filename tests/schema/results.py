"""result.json of every kind of run is valid, and the schema promises no key that is never written.
Usage: results.py SOURCE_FOLDER VASOROD."""

import json
import sys
import tempfile
from pathlib import Path

from tree import HERE, Schema, run, walk, write_tube

source, program = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
schema = Schema(source / "schema" / "result.schema.json")
infant = source / "benchmarks" / "cases" / "glenn" / "infant.yaml"
here = Path(HERE)

with tempfile.TemporaryDirectory() as scratch:
    tube = Path(scratch) / "tube.obj"
    write_tube(tube)
    runs = {
        "a bare rod": ["solve", here / "rods.yaml"],
        "tubes at rod": ["solve", here / "pressed.yaml", "--fidelity", "rod"],
        "tubes at skin": ["solve", here / "pressed.yaml", "--fidelity", "skin"],
        "tubes at paper": ["solve", here / "pressed.yaml", "--fidelity", "paper"],
        "tubes at coupled": ["solve", here / "pressed.yaml", "--certify"],
        "a tube under pressure": ["solve", here / "inflated.yaml"],
        "stopped": ["solve", here / "pressed.yaml", "--time-limit", "1e-6"],
        "the infant Glenn at rod": ["solve", infant, "--fidelity", "rod"],
        "the infant Glenn at skin": ["solve", infant, "--fidelity", "skin"],
        "an end-to-end join": ["solve", here / "sewn.yaml"],
        "fit": ["fit", tube],
    }
    seen, statuses = set(), set()
    for name, arguments in runs.items():
        out = Path(scratch) / "out"
        done = run(program, *arguments, "-o", out)
        assert done.code in (0, 1), f"{name}: {done.error}"
        result = json.loads((out / "result.json").read_text())
        fault = schema.fault(result)
        assert not fault, f"{name}: {fault}"
        assert (done.code == 0) == (result["status"] == "converged"), name
        statuses.add(result["status"])
        seen |= {(place.title, place.key) for place in walk(schema, result) if place.key}
        for vessel in result["vessels"]:  # the files it lists are the files there are
            for kind in ("surface", "centerline", "stump"):
                assert kind not in vessel or (out / vessel[kind]).exists(), (name, vessel)

known = {(one["title"], key): one for one in schema.objects() for key in one["properties"]}
missing = [
    f"{title}.{key}"
    for (title, key), one in known.items()
    if (title, key) not in seen
    and "vasorod-fem" not in (one.get("x-only"), one["properties"][key].get("x-only"))
]
assert not missing, f"keys that no run writes: {missing}"
print(f"{len(runs)} results are valid, {len(seen)} keys were written, statuses {sorted(statuses)}")
