"""The built programs and what their --help says, read here on its own: not by the scripts that the
tests check."""

import os
import re
import subprocess
from pathlib import Path

SOURCE = Path(os.environ["VASOROD_SOURCE"])
BUILD = Path(os.environ["VASOROD_BUILD"])
PROGRAMS = [Path(path) for path in os.environ["VASOROD_PROGRAMS"].split(":")]


def output(*command, **options):
    """What a command prints; it must end well."""
    run = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    if run.returncode != 0:
        raise AssertionError(f"{command} ended with {run.returncode}: {run.stdout}{run.stderr}")
    return run.stdout


def commands(program):
    """The names of a program's commands; vasorod-plan has none."""
    parts = output(program, "--help").split("Subcommands:\n", 1)
    return re.findall(r"^  (\w+)", parts[1], re.MULTILINE) if len(parts) > 1 else []


def options(program, *command):
    """All spellings of the options of a command: -o, --output, ..."""
    text = output(program, *command, "--help").split("Options:\n", 1)[1]
    found = []
    for names in re.findall(r"^  (-\S+)", text.split("\n\n", 1)[0], re.MULTILINE):
        found += names.split(",")
    return found
