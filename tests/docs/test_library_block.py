"""The README's few lines of C++ and CMake are a project: built against the installed library and
run. Usage: test_library_block.py SOURCE BUILD CMAKE"""

import subprocess
import sys
import tempfile
from pathlib import Path

from blocks import blocks_of

PAGE = "README.md"
PROJECT = """cmake_minimum_required(VERSION 3.25)
project(block LANGUAGES C CXX)
add_executable(my_program main.cpp)
"""


def program(text):
    """The lines as a whole program: includes in front, the rest in main."""
    lines = text.splitlines()
    head = [line for line in lines if line.startswith("#include")]
    body = [line for line in lines if not line.startswith("#include")]
    end = "return result.status == vasorod::Status::converged ? 0 : 1;"
    return "\n".join([*head, "int main() {", *body, end, "}"]) + "\n"


def main():
    source, build, cmake = Path(sys.argv[1]), sys.argv[2], sys.argv[3]
    blocks = {block.tag: block.text for block in blocks_of((source / PAGE).read_text())}
    with tempfile.TemporaryDirectory() as scratch:
        project = Path(scratch)
        (project / "main.cpp").write_text(program(blocks["cpp"]))
        (project / "CMakeLists.txt").write_text(PROJECT + blocks["cmake"])
        prefix = project / "prefix"
        for command in (
            [cmake, "--install", build, "--prefix", prefix],
            [cmake, "-S", project, "-B", project / "b", f"-DCMAKE_PREFIX_PATH={prefix}"],
            [cmake, "--build", project / "b"],
            [project / "b" / "my_program"],
        ):
            run = subprocess.run(command, cwd=source, capture_output=True, text=True)
            if run.returncode != 0:
                print(f"{command} ended with {run.returncode}\n{run.stdout}{run.stderr}")
                return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
