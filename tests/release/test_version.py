"""The version stands in project() of CMakeLists.txt; everything else that states it agrees."""

import re
import unittest

from programs import PROGRAMS, SOURCE, output


def found(name, pattern):
    """What the pattern's group is in a file of the project."""
    match = re.search(pattern, (SOURCE / name).read_text(), re.MULTILINE)
    if not match:
        raise AssertionError(f"{name}: found nothing like {pattern}")
    return match[1]


VERSION = found("CMakeLists.txt", r"^project\(vasorod VERSION (\d+\.\d+\.\d+)")


class Version(unittest.TestCase):
    def test_the_programs_say_it(self):
        for program in PROGRAMS:
            self.assertEqual(output(program, "--version"), f"{program.name} {VERSION}\n")

    def test_the_files_of_a_release_say_it(self):
        for name, pattern in [
            ("CITATION.cff", r"^version: (\S+)$"),
            ("debian/changelog", r"\Avasorod \((\S+)\) "),
            ("CHANGELOG.md", r"^## \[(\d\S*)\]"),  # the newest that is not Unreleased
            ("hybrid/include/vasorod/version.h", r'for example "(\S+)"'),
        ]:
            with self.subTest(name):
                self.assertEqual(found(name, pattern), VERSION)

    def test_the_script_prints_it(self):
        self.assertEqual(output(SOURCE / "packaging" / "version.sh"), f"{VERSION}\n")


if __name__ == "__main__":
    unittest.main()
