"""Every scene of the project is valid, says where its schema is, and the pages written from the
schemas are up to date. Usage: scenes.py SOURCE_FOLDER VASOROD."""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

from tree import Schema, read_scene, run

source, program = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
file = source / "schema" / "scene.schema.json"
schema = Schema(file)

scenes = [
    path
    for folder in ("benchmarks", "docs", "examples", "tests")
    for path in sorted((source / folder).glob("**/*.yaml"))
    if source / "tests" / "fuzz" not in path.parents  # damaged scenes of tests/fuzz
    and path.name != "config.yaml"  # of a Snakemake profile
]
assert len(scenes) > 90, len(scenes)
for path in scenes:
    fault = schema.fault(read_scene(path))
    assert not fault, f"{path}: {fault}"
    expected = f"# yaml-language-server: $schema={os.path.relpath(file, path.parent)}"
    first = path.read_text().splitlines()[0]
    assert first == expected, f"{path}: its first line is {first!r}, expected {expected!r}"
print(f"{len(scenes)} scenes are valid")

# Every number has a unit, every key one description.
units = set()
for page in (schema, Schema(source / "schema" / "result.schema.json")):
    for one in page.objects():
        assert one["additionalProperties"] is False, one["title"]
        for key, node in one["properties"].items():
            node = page.resolved(node)
            assert node["description"].endswith("."), (one["title"], key)
            numbers = [node, page.resolved(node.get("items", {})), *node.get("oneOf", [])]
            kinds = [kind for n in numbers for kind in [n.get("type")] if isinstance(n, dict)]
            if any(k in ("number", "integer") or k == ["number", "null"] for k in kinds):
                assert "x-unit" in node, (one["title"], key)
                units.add(node["x-unit"])
print("units:", ", ".join(sorted(units)))

make = [sys.executable, str(source / "docs" / "make_reference.py"), "--check"]
assert subprocess.run(make, check=False).returncode == 0, "docs/make_reference.py --check"

with tempfile.TemporaryDirectory() as scratch:
    done = run(program, "solve", source / "examples" / "scene.yaml", "-o", f"{scratch}/out")
    assert done.code == 0, f"examples/scene.yaml: {done.error}"
    proposed = Path(scratch) / "proposed.yaml"
    surfaces = sorted((source / "meshes" / "infant").glob("*.vtp"))
    done = run(program, "init", *surfaces, "-o", proposed)
    assert done.code == 0, f"init: {done.error}"
    fault = schema.fault(read_scene(proposed))
    assert not fault, f"the scene that init writes: {fault}"
print("the pages are up to date, their example converges, and what init writes is valid")
