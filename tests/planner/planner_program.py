"""The built vasorod-plan beside a test, and what talks to it."""

import http.client
import json
import os
import select
import shutil
import signal
import socket
import struct
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

PROGRAM = os.environ["VASOROD_PLAN"]
SOLVER = os.environ["VASOROD_PROGRAM"]
SOURCE = Path(os.environ["VASOROD_SOURCE"])

SCENE = (SOURCE / "tests/planner/small.yaml").read_text()


class Planner:
    """A running program with a scene in a folder of its own."""

    def __init__(self, *arguments, scene=SCENE, folder=None):
        self.folder = Path(folder or tempfile.mkdtemp(prefix="vasorod-plan-"))
        self.made = folder is None
        if scene is not None:
            (self.folder / "small.yaml").write_text(scene)
            arguments = (str(self.folder / "small.yaml"), *arguments)
        self.process = subprocess.Popen(
            [PROGRAM, *arguments],
            cwd=self.folder,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        ready, _, _ = select.select([self.process.stdout], [], [], 60)
        self.url = self.process.stdout.readline().strip() if ready else ""
        if not self.url.startswith("http://127.0.0.1:"):
            raise AssertionError(f"no address: {self.url!r} {self.process.stderr.read()!r}")
        self.port = int(self.url.split(":")[2].split("/")[0])
        self.token = self.url.split("/")[3]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self, sent=signal.SIGTERM):
        """Ends the program; its exit code and what it said last."""
        if self.process.poll() is None:
            self.process.send_signal(sent)
        try:
            said, complained = self.process.communicate(timeout=30)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.communicate()
            raise
        if self.made:
            shutil.rmtree(self.folder, ignore_errors=True)
        return self.process.returncode, said, complained

    def ask(self, method, path, body=None, headers=None, prefix=None):
        """Status, headers and bytes of one request."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        try:
            sent = {"Content-Type": "application/json"} if body is not None else {}
            sent.update(headers or {})
            start = f"/{self.token}/" if prefix is None else prefix
            connection.request(method, start + path, body, sent)
            answer = connection.getresponse()
            return answer.status, dict(answer.getheaders()), answer.read()
        finally:
            connection.close()

    def answered(self, method, path, body=None):
        """The bytes of a request that is answered."""
        status, _, answer = self.ask(method, path, body)
        if status != 200:
            raise AssertionError(f"{method} {path}: {status} {answer[:300]!r}")
        return answer

    def get(self, path):
        """The JSON of a GET."""
        return json.loads(self.answered("GET", path))

    def post(self, path, body):
        """The JSON of a POST."""
        return json.loads(self.answered("POST", path, json.dumps(body)))

    def refused(self, path, body):
        """Status and sentence of a POST that is refused."""
        text = body if isinstance(body, (str, bytes)) else json.dumps(body)
        status, _, answer = self.ask("POST", path, text)
        return status, json.loads(answer)["error"]

    def solved(self, plan, fidelity="skin"):
        """The status of a job at its end."""
        job = self.post("api/solve", {"plan": plan, "fidelity": fidelity})["job"]
        return self.ended(job)

    def ended(self, job, seconds=120):
        """The same of a job that was begun."""
        until = time.monotonic() + seconds
        while time.monotonic() < until:
            status = self.get(f"api/job/{job}?wait=2000")
            if status["state"] != "running":
                return status
        raise AssertionError(f"{job} does not end: {status}")

    def mesh(self, path):
        """The arrays of a mesh: {name: list of rows}."""
        return read_mesh(self.answered("GET", path))

    def head(self, method, path):
        """First lines of a request for `raw`; other headers and the empty line may follow."""
        kind = "Content-Type: application/json\r\n" if method == "POST" else ""
        return f"{method} /{self.token}/{path} HTTP/1.1\r\nHost: 127.0.0.1:{self.port}\r\n{kind}"

    def raw(self, data, seconds=5):
        """What comes back for these bytes."""
        with socket.create_connection(("127.0.0.1", self.port), timeout=seconds) as connection:
            connection.sendall(data)
            got = b""
            try:
                while chunk := connection.recv(65536):
                    got += chunk
            except OSError:
                pass
            return got


def read_mesh(data):
    """The arrays of the page's binary format, read by struct alone."""
    (length,) = struct.unpack_from("<I", data)
    header = json.loads(data[4 : 4 + length])
    arrays = {}
    for array in header["arrays"]:
        letter = {"float32": "f", "uint32": "I"}[array["type"]]
        width, count = array["components"], array["count"]
        numbers = struct.unpack_from(
            f"<{width * count}{letter}", data, 4 + length + array["offset"]
        )
        arrays[array["name"]] = [numbers[i : i + width] for i in range(0, len(numbers), width)]
    return arrays


class WithPlanner(unittest.TestCase):
    """One program for all tests of a class."""

    @classmethod
    def setUpClass(cls):
        cls.planner = Planner()
        cls.plan = cls.planner.get("api/scene")["plan"]

    @classmethod
    def tearDownClass(cls):
        code, said, complained = cls.planner.close()
        assert (code, said, complained) == (0, "closed\n", ""), (code, said, complained)
