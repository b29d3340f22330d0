#!/usr/bin/env python3
"""How long vasorod-plan takes from a changed plan to its prediction, on the bundled infant.

  planner_speed.py PROGRAM [--fidelity skin] [--count 30]      PROGRAM is a built `vasorod-plan`

Each plan has another place of the cut. Measured are the request, the wait for the job, and the
answer with all curves. The first plan only warms the program. Run it on an idle machine."""

import argparse
import json
import os
import pathlib
import statistics
import subprocess
import tempfile
import time
import urllib.request

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
SCENE = REPOSITORY / "benchmarks" / "cases" / "glenn" / "infant.yaml"


class Planner:
    """The program, and what its page asks it."""

    def __init__(self, program, folder):
        self.process = subprocess.Popen(
            [pathlib.Path(program).resolve(), SCENE],
            cwd=folder,
            stdout=subprocess.PIPE,
            text=True,
        )
        self.url = self.process.stdout.readline().strip()

    def ask(self, path, body=None):
        request = urllib.request.Request(
            self.url + path,
            data=None if body is None else json.dumps(body).encode(),
            headers={"Content-Type": "application/json"},
        )
        with urllib.request.urlopen(request) as answer:
            return json.loads(answer.read())

    def predict(self, plan, fidelity):
        job = self.ask("api/solve", {"plan": plan, "fidelity": fidelity})["job"]
        state = {"state": "running"}
        while state["state"] == "running":
            state = self.ask(f"api/job/{job}?wait=10000")
        if state["state"] != "done":
            raise SystemExit(f"planner_speed: {state['state']}: {state['error']}")
        return self.ask(f"api/result/{state['result']}")

    def processor_seconds(self):
        fields = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(") ", 1)[1]
        return sum(map(int, fields.split()[11:13])) / os.sysconf("SC_CLK_TCK")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--fidelity", default="skin")
    parser.add_argument("--count", type=int, default=30)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        planner = Planner(options.program, folder)
        try:
            began = time.monotonic()
            plan = planner.ask("api/scene")["plan"]
            print(f"opened in {time.monotonic() - began:.2f} s")
            walls, processors = [], []
            for k in range(options.count + 1):
                plan["cut"]["along"] = 0.74 + 0.06 * k / options.count
                began, used = time.monotonic(), planner.processor_seconds()
                planner.predict(plan, options.fidelity)
                walls.append(time.monotonic() - began)
                processors.append(planner.processor_seconds() - used)
        finally:
            planner.process.terminate()
            planner.process.wait()
    for name, values in (("processor time", processors[1:]), ("wall clock", walls[1:])):
        print(
            f"{name}: median {statistics.median(values):.2f} s, "
            f"{min(values):.2f} to {max(values):.2f} s over {options.count} plans"
        )
    print(f"load of the machine: {os.getloadavg()[0]:.1f}")


if __name__ == "__main__":
    main()
