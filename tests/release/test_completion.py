"""Completion in a real bash offers what the programs have, and nothing else."""

import subprocess
import unittest

from programs import PROGRAMS, SOURCE, commands, options

WITH_COMMANDS = [program for program in PROGRAMS if program.name != "vasorod-plan"]
WITHOUT_COMMANDS = [program for program in PROGRAMS if program.name == "vasorod-plan"]
SCRIPT = SOURCE / "packaging" / "completion" / "vasorod.bash"
# What bash does on Tab: the function that is registered for the program's name fills COMPREPLY.
COMPLETE = """
. "$1"; shift
name=$(basename "$1")
[[ $(complete -p "$name") == *"-F _vasorod $name" ]] || exit 4
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
_vasorod "$1" "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
printf '%s\\n' "${COMPREPLY[@]}"
"""


def offered(program, *words):
    """What Tab offers after the words; the last one is being typed."""
    run = subprocess.run(
        ["bash", "--norc", "-c", COMPLETE, "bash", str(SCRIPT), str(program), *words],
        capture_output=True,
        text=True,
        check=True,
    )
    assert not run.stderr, run.stderr
    return sorted(run.stdout.split())


class Completion(unittest.TestCase):
    def test_first_word_is_a_command_or_an_option(self):
        for program in WITH_COMMANDS:
            there = commands(program)
            self.assertIn("solve", there)
            self.assertEqual(offered(program, ""), sorted(there + options(program)))
            self.assertEqual(offered(program, "so"), ["solve"])

    def test_every_command_offers_its_own_options(self):
        for program in PROGRAMS:
            for command in commands(program):
                there = options(program, command)
                self.assertIn("--help", there)
                self.assertEqual(offered(program, command, "-"), sorted(there))
                long = sorted(name for name in there if name.startswith("--"))
                self.assertEqual(offered(program, command, "x", "--"), long)

    def test_without_commands_words_are_files_or_options(self):
        for program in WITHOUT_COMMANDS:
            there = options(program)
            self.assertIn("--port", there)
            for words in ([""], ["p"], ["x", ""], ["--port", ""], ["--open", "p"]):
                self.assertEqual(offered(program, *words), [], words)
            for words in (["-"], ["x", "-"], ["--open", "-"]):
                self.assertEqual(offered(program, *words), sorted(there), words)
            self.assertEqual(offered(program, "--p"), ["--port"])

    def test_values_that_an_option_takes(self):
        fidelities = ["coupled", "paper", "rod", "section", "skin"]
        self.assertEqual(offered(PROGRAMS[0], "solve", "--fidelity", ""), fidelities)
        self.assertEqual(offered(PROGRAMS[0], "solve", "--fidelity", "c"), ["coupled"])
        self.assertEqual(offered(PROGRAMS[0], "fit", "--length-unit", ""), ["cm", "m", "mm"])
        for program in WITH_COMMANDS[1:]:
            self.assertEqual(offered(program, "solve", "--model", ""), ["shell", "solid"])

    def test_other_words_are_files(self):
        self.assertEqual(offered(PROGRAMS[0], "solve", ""), [])
        self.assertEqual(offered(PROGRAMS[0], "solve", "-o", ""), [])
        self.assertEqual(offered(PROGRAMS[0], "nothing", "-"), sorted(options(PROGRAMS[0])))


if __name__ == "__main__":
    unittest.main()
