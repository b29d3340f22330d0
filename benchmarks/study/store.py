"""Runs each program once and records the cost: a folder per run with its scene, its result and
record.json (command, commit, hashes, wall and processor time, peak memory, exit code, the sentence
of a failure). A finished run is not repeated while its command and scene are the same, and its
program too unless the run says `keep`."""

import hashlib
import json
import os
import shutil
import subprocess
import time
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parent.parent.parent
ENOUGH = 10.0


def sha256(data):
    return hashlib.sha256(data if isinstance(data, bytes) else data.encode()).hexdigest()


def commit():
    """The commit of this tree, with a + where tracked files differ from it."""

    def git(*words):
        return subprocess.run(
            ["git", "-C", str(REPOSITORY), *words], capture_output=True, text=True
        ).stdout.strip()

    return (git("rev-parse", "--short=12", "HEAD") or "unknown") + (
        "+" if git("status", "--porcelain", "--untracked-files=no") else ""
    )


def solve_seconds(folder, record):
    """Processor time of a run's solving, without reading, pictures and writing: in proportion to
    the wall times that the result states; None where there is no result."""
    try:
        seconds = json.loads((folder / "result" / "result.json").read_text())["seconds"]
    except FileNotFoundError:
        return None
    # vasorod's stages add up to its total; vasorod-fem's `solve` is all of its solving
    solving = (
        seconds["total"] - seconds["read"] - seconds["write"]
        if record["program"] == "vasorod"
        else seconds["solve"]
    )
    return record["processor_seconds"] * min(1.0, solving / record["wall_seconds"])


def same_kernels():
    """OpenBLAS chooses its kernels by the processor. Those for AVX-512 round otherwise than those
    for AVX2: counts of the worst conditioned rows then differ tenfold, and a wall that crumples
    ends elsewhere. The tables are of the latter, which nearly every x86-64 machine has."""
    try:
        processor = Path("/proc/cpuinfo").read_text()
    except OSError:
        return {}
    return {"OPENBLAS_CORETYPE": "Haswell"} if " avx2 " in processor else {}


class Store:
    def __init__(self, results, programs):
        """results: the folder of all runs; programs: {name: path of the executable}."""
        self.results, self.programs = Path(results).resolve(), {
            name: Path(path).resolve() for name, path in programs.items()
        }
        self._hashes = {}

    def folder(self, identity):
        return self.results / identity

    def program_hash(self, name):
        if name not in self._hashes:
            path = self.programs[name]
            if not path.exists():
                raise SystemExit(f"{path}: not there, expected the program {name}: build it first")
            self._hashes[name] = sha256(path.read_bytes())
        return self._hashes[name]

    def record(self, identity):
        try:
            return json.loads((self.folder(identity) / "record.json").read_text())
        except FileNotFoundError:
            return None

    def fresh(self, run):
        """The run's record, if there is one that still holds."""
        record = self.record(run.identity)
        if record is None or record["key"] != run.key():
            return None
        if not run.keep and record["program_sha256"] != self.program_hash(run.program):
            return None
        return record

    def ensure(self, run, again=False, repeats=1):
        """The run's record. Where times are compared, a run is repeated and the one that took the
        least processor time counts; runs of ENOUGH seconds are not repeated, as disturbances are
        small in comparison."""
        record = None if again else self.fresh(run)
        if record is not None and (
            record.get("repeats", 1) >= repeats or record["processor_seconds"] > ENOUGH
        ):
            return record
        records = [self._execute(run)]
        while len(records) < repeats and records[0]["processor_seconds"] <= ENOUGH:
            records.append(self._execute(run))
        record = min(records, key=lambda one: one["processor_seconds"])
        record.update(
            repeats=len(records),
            solve_seconds=min(
                (one["solve_seconds"] for one in records if one["solve_seconds"] is not None),
                default=None,
            ),
        )
        (self.folder(run.identity) / "record.json").write_text(json.dumps(record, indent=1) + "\n")
        return record

    def _execute(self, run):
        folder = self.folder(run.identity)
        if folder.exists():
            shutil.rmtree(folder)
        folder.mkdir(parents=True)
        for name, text in run.contents().items():
            (folder / name).write_text(text)
        words = [str(self.programs[run.program]), *run.arguments]
        started = time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime())
        environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
        environment |= same_kernels()
        with open(folder / "output.txt", "wb") as output:
            begin = time.perf_counter()
            child = subprocess.Popen(
                words, cwd=folder, stdout=output, stderr=subprocess.STDOUT, env=environment
            )
            _, status, usage = os.wait4(child.pid, 0)
            wall = time.perf_counter() - begin
            child.returncode = os.waitstatus_to_exitcode(status)
        lines = (folder / "output.txt").read_text(errors="replace").strip().splitlines()
        record = {
            "identity": run.identity,
            "key": run.key(),
            "program": run.program,
            "command": [run.program, *run.arguments],
            "program_sha256": self.program_hash(run.program),
            "commit": commit(),
            "started": started,
            "exit": child.returncode,
            "sentence": lines[-1] if child.returncode != 0 and lines else "",
            "wall_seconds": wall,
            "processor_seconds": usage.ru_utime + usage.ru_stime,
            "user_seconds": usage.ru_utime,
            "peak_bytes": usage.ru_maxrss * 1024,
        }
        record["solve_seconds"] = solve_seconds(folder, record)
        return record
