"""Results and records as the programs leave them, for tests of tables."""

import json


def comparing(folder, vessels):
    """A program whose `compare` answers with these vessels, in the folder."""
    program = folder / "compare"
    program.write_text(f"#!/bin/sh\necho '{json.dumps({'vessels': vessels})}'\n")
    program.chmod(0o755)
    return program


def leave(store, finished, **measured):
    """finished: (run, what is in its result.json, exit code); measured: more of their records."""
    for run, content, code in finished:
        (store.folder(run.identity) / "result").mkdir(parents=True)
        (store.folder(run.identity) / "result" / "result.json").write_text(json.dumps(content))
        record = {"identity": run.identity, "program": run.program, "program_sha256": "0" * 64}
        record |= {"commit": "c", "exit": code, "processor_seconds": 2.0, "sentence": ""}
        record |= measured
        (store.folder(run.identity) / "record.json").write_text(json.dumps(record))
