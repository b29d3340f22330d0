"""vasorod-plan against those who should not talk to it, and against requests that are none."""

import concurrent.futures
import json
import os
import random
import shutil
import signal
import socket
import subprocess
import time
import unittest

from planner_program import PROGRAM, Planner, WithPlanner


class Strangers(WithPlanner):
    """Only who knows the address is answered, and only under the program's own name."""

    def is_refused(self, status, body, wanted=403):
        """One sentence, and nothing of the scene."""
        self.assertEqual(status, wanted, body)
        self.assertEqual(list(json.loads(body)), ["error"])

    def test_it_listens_on_the_loopback_alone(self):
        found = set()
        for table in ("tcp", "tcp6"):
            with open(f"/proc/{self.planner.process.pid}/net/{table}", encoding="ascii") as lines:
                for line in list(lines)[1:]:
                    address, port = line.split()[1].rsplit(":", 1)
                    if line.split()[3] == "0A" and int(port, 16) == self.planner.port:
                        found.add(address)
        self.assertEqual(found, {"0100007F"})

    def test_another_token(self):
        token = self.planner.token
        other = ("0" if token[0] != "0" else "1") + token[1:]
        for prefix in (
            "/",
            f"/{other}/",
            f"/{token[:-1]}/",
            f"/{token}0/",
            f"/{token}",
            "//",
            f"/{token.upper()}x/",
            f"/x/../{token}/",
            f"/%2e%2e/{token}/",
        ):
            for path in ("", "api/session", "api/scene"):
                status, headers, body = self.planner.ask("GET", path, prefix=prefix)
                self.is_refused(status, body)
                self.assertEqual(headers["Cache-Control"], "no-store")
        status, _, body = self.planner.ask("POST", "api/solve", "{}", prefix=f"/{other}/")
        self.is_refused(status, body)

    def test_a_token_is_new_each_time(self):
        with Planner() as other:
            self.assertRegex(other.token, "^[0-9a-f]{32}$")
            self.assertNotEqual(other.token, self.planner.token)

    def test_another_host(self):
        port = self.planner.port
        for host in (
            "evil.example",
            f"evil.example:{port}",
            f"127.0.0.1:{port + 1}",
            "127.0.0.1",
            f"127.0.0.1.evil.example:{port}",
            f"[::1]:{port}",
            f"0.0.0.0:{port}",
            "",
            f"localhost:{port}@evil.example",
            f"localhost:{port} ",
        ):
            status, _, body = self.planner.ask(
                "GET", "api/session", headers={"Host": host.strip() or " "}
            )
            if host == f"localhost:{port} ":
                self.assertEqual(status, 200)
            else:
                self.is_refused(status, body)
        status, _, _ = self.planner.ask("GET", "api/session", headers={"Host": f"localhost:{port}"})
        self.assertEqual(status, 200)
        twice = self.planner.head("GET", "api/session") + (
            "Host: evil.example\r\nConnection: close\r\n\r\n"
        )
        self.assertIn(b" 403 ", self.planner.raw(twice.encode()))
        none = f"GET /{self.planner.token}/api/session HTTP/1.1\r\nConnection: close\r\n\r\n"
        self.assertIn(b" 403 ", self.planner.raw(none.encode()))

    def test_another_origin(self):
        port = self.planner.port
        for origin in (
            "http://evil.example",
            "null",
            "https://127.0.0.1:%d" % port,
            f"http://127.0.0.1:{port + 1}",
            f"http://127.0.0.1:{port}.evil.example",
            "file://",
        ):
            for method, body in (("GET", None), ("POST", "{}")):
                status, _, answer = self.planner.ask(
                    method, "api/session", body, {"Origin": origin}
                )
                self.is_refused(status, answer)
        for origin in (f"http://127.0.0.1:{port}", f"http://localhost:{port}"):
            status, _, _ = self.planner.ask("GET", "api/session", headers={"Origin": origin})
            self.assertEqual(status, 200)

    def test_answers_say_how_they_may_be_used(self):
        for path in ("", "api/session", "nothing"):
            _, headers, _ = self.planner.ask("GET", path)
            self.assertEqual(headers["Cache-Control"], "no-store")
            self.assertEqual(headers["X-Content-Type-Options"], "nosniff")
            self.assertIn("default-src 'self'", headers["Content-Security-Policy"])
            self.assertNotIn("Access-Control-Allow-Origin", headers)

    def test_no_path_leads_to_a_file(self):
        for path in (
            "../small.yaml",
            "..%2fsmall.yaml",
            "%2e%2e/%2e%2e/etc/passwd",
            "small.yaml",
            "/etc/passwd",
            "api/../../etc/passwd",
            "app.js/../../etc/passwd",
            "app.js%00",
            "api/mesh/../../etc/passwd",
            "api/mesh/%2e%2e%2fsvc",
            "api/result/../mesh/svc",
            "api/mesh/",
            "api/result//mesh/svc",
            "api/job/",
            "api",
            "api/",
        ):
            status, _, body = self.planner.ask("GET", path)
            self.is_refused(status, body, 404)


class Bodies(WithPlanner):
    """Requests that are not what they should be are answered with one sentence."""

    def test_wrong_bodies(self):
        plan = self.plan
        far = {"origin": [0, 0, 50], "direction": [0, 0, -1]}
        wrong = [
            ("api/pick", "{", "JSON"),
            ("api/pick", "[]", "object"),
            ("api/pick", '"text"', "object"),
            ("api/pick", "\x00\x01", "JSON"),
            ("api/pick", b"\xff\xfe{}", "JSON"),
            ("api/pick", "[" * 100000, "nested"),
            ("api/pick", '{"a":' * 50000, "nested"),
            ("api/pick", {}, "origin"),
            ("api/pick", {**far, "direction": [0, 0, 0]}, "direction"),
            ("api/pick", {**far, "direction": [1, 2]}, "direction"),
            ("api/pick", {**far, "origin": [1e300, 0, 0]}, "origin"),
            ("api/pick", {**far, "origin": ["1", 0, 0]}, "origin"),
            ("api/pick", {**far, "origin": None}, "origin"),
            ("api/pick", {**far, "vessels": ["none"]}, "vessel"),
            ("api/pick", {**far, "vessels": 3}, "vessels"),
            ("api/pick", {**far, "result": "r999"}, "r999"),
            ("api/pick", {**far, "stray": 1}, "stray"),
            ("api/pick", '{"origin": [NaN, 0, 0], "direction": [0, 0, 1]}', "JSON"),
            ("api/pick", '{"origin": [1e999, 0, 0], "direction": [0, 0, 1]}', "1e999"),
            ("api/pick", '{"origin": [Infinity, 0, 0], "direction": [0, 0, 1]}', "JSON"),
            ("api/place", {"plan": None}, "plan"),
            ("api/place", {"plan": {**plan, "cut": {"along": 1.5}}}, "plan.cut.along"),
            ("api/place", {"plan": {**plan, "cut": {"along": -1e308}}}, "plan.cut.along"),
            ("api/place", {"plan": {**plan, "cut": {"along": 0.5, "route": [0, 7]}}}, "route"),
            ("api/place", {"plan": {**plan, "cut": {"along": 0.5, "route": [-1, 2]}}}, "route"),
            ("api/place", {"plan": {**plan, "cut_tilt_deg": 80}}, "plan.cut_tilt_deg"),
            ("api/place", {"plan": {**plan, "incision_length": 0}}, "plan.incision_length"),
            ("api/place", {"plan": {**plan, "shape": "star"}}, "plan.shape"),
            ("api/place", {"plan": {**plan, "shape": {"ellipse": 5}}}, "plan.shape.ellipse"),
            ("api/place", {"plan": {**plan, "rotation_deg": "auto"}}, "plan.rotation_deg"),
            ("api/solve", {"plan": plan, "fidelity": "magic"}, "fidelity"),
            ("api/solve", {"plan": plan}, "fidelity"),
            ("api/cancel", {"job": "j999999"}, "j999999"),
            ("api/cancel", {"job": "j99999999999999999999999"}, "job"),
            ("api/cancel", {"job": 3}, "job"),
            ("api/section", {"point": [0, 0, 0], "normal": [0, 0, 0]}, "normal"),
            ("api/section", {"point": [0, 0, 0], "normal": [1e-320, 0, 0], "x": 1}, "x"),
            ("api/open", {"id": "s999"}, "s999"),
            ("api/open", {"id": "a" * 100000}, "id"),
            ("api/keep", {"result": "r999", "name": "x"}, "r999"),
            ("api/hold", {"result": "r999", "hold": True}, "r999"),
            (
                "api/save",
                {"name": "x.yaml", "plan": plan, "fidelity": "skin", "overwrite": 1},
                "overwrite",
            ),
            ("api/nothing", {}, "api/nothing"),
            ("api/", {}, "api/"),
        ]
        for path, body, word in wrong:
            status, sentence = self.planner.refused(path, body)
            self.assertIn(status, (400, 404), (path, sentence))
            self.assertIn(word, sentence)
            self.assertNotIn("\n", sentence)
        for path in (
            "api/job/j999",
            "api/job/x",
            "api/result/r999",
            "api/result/r1/mesh",
            "api/result/r999/mesh/svc",
            "api/mesh/none",
            "api/job/j1?wait=x",
            "api/job/j1?wait=-1",
        ):
            status, _, body = self.planner.ask("GET", path)
            self.assertIn(status, (400, 404))
            self.assertIn("error", json.loads(body))

    def test_too_much(self):
        status, _, body = self.planner.ask("POST", "api/pick", b" " * ((1 << 20) + 1))
        self.assertEqual(status, 413, body)
        self.assertIn("1 MB", json.loads(body)["error"])
        status, _, body = self.planner.ask("POST", "api/pick", b" " * (1 << 20))
        self.assertEqual(status, 400, body)
        # It is the stated length that counts, before anything is read.
        head = self.planner.head("POST", "api/pick")
        answer = self.planner.raw(
            f"{head}Connection: close\r\nContent-Length: 99999999999999\r\n\r\n{{}}".encode(), 10
        )
        self.assertTrue(b" 413 " in answer or b" 400 " in answer or answer == b"", answer)

    def test_bodies_that_are_not_plain(self):
        for headers, wanted in (
            ({"Content-Encoding": "gzip"}, 415),
            ({"Content-Type": "multipart/form-data; boundary=x"}, 415),
            ({"Content-Type": "text/plain"}, 415),
            ({"Content-Type": "application/x-www-form-urlencoded"}, 415),
        ):
            status, _, body = self.planner.ask("POST", "api/pick", "{}", headers)
            self.assertEqual(status, wanted, body)
            self.assertIn("error", json.loads(body))
        head = self.planner.head("POST", "api/pick")
        chunked = head + "Transfer-Encoding: chunked\r\n\r\n2\r\n{}\r\n0\r\n\r\n"
        self.assertIn(b" 415 ", self.planner.raw(chunked.encode()))
        self.assertIn(b" 411 ", self.planner.raw((head + "\r\n").encode()))

    def test_parts_of_an_answer_are_not_given(self):
        many = "bytes=" + ",".join(["0-"] * 1000)
        for header in ("bytes=0-10", "bytes=-5", "bytes=5-1", many):
            status, _, body = self.planner.ask("GET", "api/mesh/svc", headers={"Range": header})
            self.assertEqual(status, 416, body[:100])

    def test_other_methods(self):
        for method in ("PUT", "DELETE", "PATCH", "OPTIONS"):
            status, _, _ = self.planner.ask(method, "api/session")
            self.assertGreaterEqual(status, 400, method)

    def test_bytes_that_are_no_http(self):
        generator = random.Random(1)
        head = self.planner.head("POST", "api/pick")
        good = f"{head}Content-Length: 2\r\nConnection: close\r\n\r\n{{}}".encode()
        for k in range(150):
            data = bytearray(good)
            for _ in range(generator.randint(1, 6)):
                what, at = generator.randint(0, 2), generator.randrange(len(data))
                if what == 0:
                    data[at] = generator.randrange(256)
                elif what == 1:
                    del data[at : at + generator.randint(1, 20)]
                else:
                    data[at:at] = bytes(generator.randrange(256) for _ in range(10))
            with socket.create_connection(("127.0.0.1", self.planner.port), 5) as connection:
                connection.sendall(bytes(data) + b"\r\n\r\n")
                connection.shutdown(socket.SHUT_WR)
                if k % 3 == 0:
                    connection.recv(65536)
        for data in (
            b"",
            b"\r\n" * 1000,
            b"GET " + b"/" * 200000 + b" HTTP/1.1\r\n\r\n",
            b"GET / HTTP/9.9\r\n\r\n",
            b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03",
            b"GET / HTTP/1.1\r\n" + b"A: " + b"b" * 100000 + b"\r\n\r\n",
            b"GET / HTTP/1.1\r\n" + b"A: b\r\n" * 20000 + b"\r\n",
        ):
            try:
                self.planner.raw(data, 1)
            except OSError:
                pass
        self.assertEqual(self.planner.get("api/scene")["name"], "small")

    def test_a_thousand_quick_requests(self):
        body = json.dumps({"origin": [20, 0, 25], "direction": [-1, 0, 0]})
        with concurrent.futures.ThreadPoolExecutor(16) as pool:
            answers = list(
                pool.map(lambda _: self.planner.ask("POST", "api/pick", body)[0], range(1000))
            )
        self.assertEqual(set(answers), {200})

    def test_a_hundred_solves_at_once(self):
        plans = [{**self.plan, "cut": {"along": 0.7 + 0.001 * k}} for k in range(100)]
        with concurrent.futures.ThreadPoolExecutor(8) as pool:
            jobs = list(
                pool.map(
                    lambda plan: self.planner.post("api/solve", {"plan": plan, "fidelity": "skin"}),
                    plans,
                )
            )
        last = max((one["job"] for one in jobs), key=lambda job: int(job[1:]))
        self.assertEqual(self.planner.ended(last)["state"], "done")
        # None is left waiting, also of those that began at once.
        for one in jobs[-30:]:
            self.assertNotEqual(self.planner.get("api/job/" + one["job"])["state"], "running")

    def test_connections_that_say_nothing(self):
        silent = [socket.create_connection(("127.0.0.1", self.planner.port)) for _ in range(40)]
        try:
            # They are given up after their time, and then others are answered again.
            self.assertEqual(self.planner.get("api/scene")["name"], "small")
        finally:
            for connection in silent:
                connection.close()


class Ending(unittest.TestCase):
    """The program ends when it is told to, and leaves nothing behind."""

    def keep_folder(self, planner):
        """Its folder outlives the program, to be looked into."""
        planner.made = False
        self.addCleanup(shutil.rmtree, planner.folder, ignore_errors=True)

    def test_signals(self):
        for sent in (signal.SIGINT, signal.SIGTERM):
            planner = Planner()
            planner.get("api/scene")
            self.assertEqual(planner.close(sent), (0, "closed\n", ""))

    def test_in_the_middle_of_a_solve(self):
        planner = Planner()
        plan = planner.get("api/scene")["plan"]
        planner.post("api/solve", {"plan": plan, "fidelity": "coupled"})
        before = time.monotonic()
        self.keep_folder(planner)
        self.assertEqual(planner.close()[0], 0)
        self.assertLess(time.monotonic() - before, 5)
        self.assertEqual([p.name for p in planner.folder.iterdir()], ["small.yaml"])

    def test_in_the_middle_of_keeping(self):
        planner = Planner()
        plan = planner.get("api/scene")["plan"]
        rid = planner.solved(plan)["result"]
        with socket.create_connection(("127.0.0.1", planner.port)) as connection:
            body = json.dumps({"result": rid, "name": "kept"})
            head = planner.head("POST", "api/keep")
            connection.sendall(f"{head}Content-Length: {len(body)}\r\n\r\n{body}".encode())
            time.sleep(0.3)
            self.keep_folder(planner)
            self.assertEqual(planner.close()[0], 0)
        left = {p.name for p in planner.folder.iterdir()}
        self.assertLessEqual(left, {"small.yaml", "kept"})
        if "kept" in left:
            self.assertTrue((planner.folder / "kept" / "report.html").is_file())

    def test_a_browser_that_goes_away_ends_nothing(self):
        planner = Planner()
        try:
            plan = planner.get("api/scene")["plan"]
            job = planner.post("api/solve", {"plan": plan, "fidelity": "skin"})["job"]
            for path in (f"api/job/{job}?wait=5000", "api/mesh/svc", "app.js"):
                with socket.create_connection(("127.0.0.1", planner.port)) as connection:
                    connection.sendall(f"{planner.head('GET', path)}\r\n".encode())
            self.assertEqual(planner.ended(job)["state"], "done")
        finally:
            self.assertEqual(planner.close()[0], 0)

    def run_program(self, *arguments):
        """Exit code, output and complaints."""
        run = subprocess.run(
            [PROGRAM, *arguments], capture_output=True, text=True, timeout=60, check=False
        )
        return run.returncode, run.stdout, run.stderr

    def test_a_port_that_is_taken(self):
        with Planner() as planner:
            code, said, complained = self.run_program("--port", str(planner.port))
            self.assertEqual((code, said), (3, ""))
            self.assertEqual(complained.count("\n"), 1)
            self.assertIn(str(planner.port), complained)

    def test_wrong_input(self):
        for arguments, word in (
            (["/no/such/scene.yaml"], "no such file"),
            (["/tmp/.."], "result.json"),
            (["--port", "0"], "port"),
            (["--port", "70000"], "port"),
            (["--nothing"], "nothing"),
        ):
            code, said, complained = self.run_program(*arguments)
            self.assertEqual((code, said), (2, ""), arguments)
            self.assertEqual(complained.count("\n"), 1)
            self.assertIn(word, complained)

    def test_a_scene_that_is_none_is_said_in_the_page(self):
        planner = Planner(scene="scene: x\nvessels: []\n")
        try:
            status, _, body = planner.ask("GET", "api/scene")
            self.assertEqual(status, 400)
            self.assertIn("small.yaml", json.loads(body)["error"])
        finally:
            self.assertEqual(planner.close()[0], 0)

    def test_open_asks_for_a_browser(self):
        planner = Planner()
        folder = planner.folder
        (folder / "bin").mkdir()
        script = folder / "bin" / "xdg-open"
        script.write_text(
            f'#!/bin/sh\necho "$1" > "{folder}/opened.part"\n'
            f'mv "{folder}/opened.part" "{folder}/opened"\n'
        )
        script.chmod(0o755)
        path = os.environ["PATH"]
        os.environ["PATH"] = f"{folder}/bin:{path}"
        try:
            other = Planner(str(folder / "small.yaml"), "--open", scene=None, folder=folder)
            for _ in range(100):
                if (folder / "opened").exists():
                    break
                time.sleep(0.05)
            self.assertEqual((folder / "opened").read_text().strip(), other.url)
            other.close()
        finally:
            os.environ["PATH"] = path
            planner.close()


if __name__ == "__main__":
    unittest.main()
