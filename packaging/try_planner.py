#!/usr/bin/env python3
"""Tries an installed vasorod-plan on a scene that can be planned, as its page uses it:

    try_planner.py PROGRAM... SCENE     e.g. chroot ROOT vasorod-plan SCENE

starts it, fetches page and scene, predicts once at fidelity `skin` and ends it. It needs what
Python brings, so that it runs where no test can be built."""

import json
import select
import signal
import subprocess
import sys
import urllib.error
import urllib.request

SECONDS = 60


def fetch(address, body=None):
    """The bytes of one answer; a body makes it a POST."""
    data = None if body is None else json.dumps(body).encode()
    request = urllib.request.Request(address, data, {"Content-Type": "application/json"})
    # No proxy: the program is on this machine.
    opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
    with opener.open(request, timeout=SECONDS) as answer:
        return answer.read()


def expect(holds, sentence):
    """Ends the trial where something is not as it should be."""
    if not holds:
        raise SystemExit(f"try_planner: {sentence}")


def talk(url):
    """What the page does first. Returns a sentence of what was there."""
    expect(b'src="app.js"' in fetch(url), "found no page at its address")
    expect(len(fetch(url + "app.js")) > 100_000, "the page has no program")
    try:
        fetch(url.rsplit("/", 2)[0] + "/")
        expect(False, "the page is served without the token")
    except urllib.error.HTTPError as refused:
        expect(refused.code == 403, f"without the token: found {refused.code}, expected 403")
    program = json.loads(fetch(url + "api/session"))["program"]
    scene = json.loads(fetch(url + "api/scene"))
    plan = scene["plan"]
    job = json.loads(fetch(url + "api/solve", {"plan": plan, "fidelity": "skin"}))["job"]
    status = {"state": "running"}
    while status["state"] == "running":
        status = json.loads(fetch(f"{url}api/job/{job}?wait=2000"))
    expect(status["state"] == "done", f"the prediction ended as {status}")
    names = ", ".join(vessel["name"] for vessel in scene["vessels"])
    return f"{program} served its page and predicted {names}"


def main():
    process = subprocess.Popen(sys.argv[1:], stdout=subprocess.PIPE, text=True)
    try:
        ready, _, _ = select.select([process.stdout], [], [], SECONDS)
        url = process.stdout.readline().strip() if ready else ""
        expect(url.startswith("http://127.0.0.1:"), f"found {url!r}, expected an address")
        said = talk(url + ("" if url.endswith("/") else "/"))
        process.send_signal(signal.SIGTERM)
        rest, _ = process.communicate(timeout=SECONDS)
        ended = (process.returncode, rest)
        expect(ended == (0, "closed\n"), f"it ended with {ended}, expected 0 and closed")
    finally:
        if process.poll() is None:
            process.kill()
            process.wait()
    print(f"run: {said}")


if __name__ == "__main__":
    main()
