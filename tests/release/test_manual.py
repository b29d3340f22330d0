"""Each program and each of its commands has a manual page with all its options."""

import tempfile
import unittest

from programs import PROGRAMS, SOURCE, commands, options, output


class Manual(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        for program in PROGRAMS:
            output(SOURCE / "packaging" / "man" / "make_manual.sh", program, self.folder)

    def page(self, name):
        """The page as a reader sees it, and what man complains about."""
        path = f"{self.folder}/{name}.1"
        text = output("groff", "-man", "-Tascii", "-ww", "-P-cbou", path)
        self.assertNotIn(str(PROGRAMS[0].parent), text, "the path of the build")
        self.assertTrue(text.startswith(f"{name.upper()}(1)"), text[:80])
        return text

    def test_every_command_has_its_page_with_every_option(self):
        for program in PROGRAMS:
            whole = self.page(program.name)
            self.assertRegex(whole, rf"NAME\n +{program.name} +- +\w")
            self.assertIn("EXIT STATUS", whole)
            for option in options(program):
                self.assertRegex(whole, rf"(?m)^ +.*{option}\b")
            for command in commands(program):
                self.assertIn(command, whole)
                page = self.page(f"{program.name}-{command}")
                self.assertRegex(page, rf"NAME\n +{program.name}-{command} +- +\w")
                self.assertIn(f"{program.name} {command}", page)
                for option in options(program, command):
                    self.assertRegex(page, rf"(?m)^ +.*{option}\b")


if __name__ == "__main__":
    unittest.main()
