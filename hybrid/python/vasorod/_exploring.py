"""The process of an exploration: a script that _explore.py runs.

Each option is solved in a process forked from this one, which therefore has one thread: it loads
the compiled part alone, without NumPy and what that starts. One line of JSON on standard input
says what to do, lines of JSON on standard output what has been done. It stops at SIGINT, at its
time limit, and where standard input is closed, as by the end of the process that began it.
"""

import importlib.util
import json
import os
import select
import sys
import time


def main():
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)  # nothing else is written among the answers
    asked = json.loads(sys.stdin.readline())
    begun, limit = time.monotonic(), asked["time_limit"]

    def answer(**what):
        print(json.dumps(what), file=answers, flush=True)

    def stop():
        closed = bool(select.select([sys.stdin], [], [], 0)[0])
        return closed or (limit is not None and time.monotonic() - begun > limit)

    spec = importlib.util.spec_from_file_location("_core", asked["core"])
    core = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(core)
    try:
        text = asked["text"]
        scene = (
            core.read_scene_text(text, asked["scene_folder"])
            if text
            else core.read_scene(asked["file"])
        )
        done = core.explore(
            scene=scene,
            folder=asked["folder"],
            stages=asked["stages"],
            best=asked["best"],
            threads=asked["threads"],
            report=asked["report"],
            stop=stop,
            progress=lambda line: answer(progress=line),
        )
        answer(done=json.loads(done))
    except KeyboardInterrupt:
        pass
    except (ValueError, OSError, MemoryError) as error:
        answer(error=type(error).__name__, sentence=str(error))


if __name__ == "__main__":
    main()
