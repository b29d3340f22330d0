"""A solve leaves Python running, and ends at Ctrl-C, at its time limit, and when progress says so.
"""

import os
import signal
import subprocess
import sys
import threading
import time
import unittest
from pathlib import Path

import vasorod
from cases import long_solve, tube

# Solves for minutes and says when it has begun a stage whose name has a word in it; then what
# ended it, and after how many seconds.
CHILD = """
import sys, time
sys.path.insert(0, {folder!r})
import vasorod
from cases import long_solve

begun = []
def progress(stage):
    if {word!r} in stage and not begun:
        begun.append(stage)
        print("begun", flush=True)

try:
    vasorod.solve(long_solve(), progress=progress)
except KeyboardInterrupt:
    print("interrupted at", time.time(), flush=True)
print("goes on:", vasorod.solve({{**long_solve(), "fidelity": "rod"}}).status, flush=True)
"""


class CtrlC(unittest.TestCase):
    def interrupted(self, word):
        """Seconds from SIGINT to KeyboardInterrupt, sent in a stage with a word in its name."""
        code = CHILD.format(folder=str(Path(__file__).parent), word=word)
        child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
        with child:
            self.assertEqual(child.stdout.readline(), "begun\n")
            sent = time.time()
            child.send_signal(signal.SIGINT)
            said = child.stdout.readline().split()
            self.assertEqual(said[:2], ["interrupted", "at"])
            self.assertEqual(child.stdout.readline(), "goes on: converged\n")
            # What was left to itself ends before the interpreter does.
            self.assertEqual(child.wait(timeout=120), 0)
        return float(said[2]) - sent

    def test_ends_the_solve(self):
        # about a second on an idle machine; the solve would take minutes
        self.assertLess(self.interrupted("reading"), 10)

    def test_ends_the_wait_for_a_step_that_cannot_be_stopped_inside(self):
        self.assertLess(self.interrupted("factoris"), 10)


class OtherThreads(unittest.TestCase):
    def test_run_during_a_solve(self):
        count, done = 0, threading.Event()

        def work():
            nonlocal count
            while not done.wait(1e-3):
                count += 1

        other = threading.Thread(target=work)
        other.start()
        before = time.perf_counter()
        vasorod.solve(tube("coupled", around=48, along=80))
        seconds, counted = time.perf_counter() - before, count
        done.set()
        other.join()
        # One a millisecond on an idle machine. With the GIL held during the solve: none or one.
        self.assertGreater(seconds, 0.1, "too short to tell")
        self.assertGreater(counted, 20)

    def test_a_solve_in_another_thread_does_not_hold_the_main_one(self):
        result = []
        other = threading.Thread(target=lambda: result.append(vasorod.solve(tube("coupled"))))
        other.start()
        here = vasorod.solve(tube("rod"))
        other.join()
        self.assertEqual((here.status, result[0].status), ("converged", "converged"))


class TimeLimit(unittest.TestCase):
    def test_returns_the_best_state_so_far(self):
        for limit in (4, 8, 16, 32):  # a busy machine may have no state yet
            try:
                result = vasorod.solve(long_solve(), time_limit=limit)
                break
            except TimeoutError:
                pass
        self.assertEqual(result.status, "interrupted")
        why = result.json["certificate"]["notes"][-1]
        self.assertRegex(why, f"^stopped by the time limit of {limit} s at ")
        self.assertIsNone(result.json["validity"]["in_range"])
        self.assertEqual(result.vessels["tube"].points.shape, (400 * 251, 3))
        # Its ends are where the scene puts them, also in a state that is none of equilibrium.
        moved = result.vessels["tube"].point_arrays["Displacement"]
        self.assertLess(abs(moved[:400]).max(), 1e-12)


class Progress(unittest.TestCase):
    def test_names_the_stages_in_order(self):
        stages = []
        vasorod.solve(tube(), progress=stages.append)
        self.assertEqual(stages[:2], ["reading vessel tube", "fitting vessel tube"])
        self.assertIn("fidelity skin", stages)

    def test_what_it_raises_ends_the_solve(self):
        class Enough(Exception):
            pass

        def progress(stage):
            raise Enough(stage)

        with self.assertRaisesRegex(Enough, "^reading vessel tube$"):
            vasorod.solve(long_solve(), progress=progress)


if __name__ == "__main__":
    assert os.name == "posix"
    unittest.main()
