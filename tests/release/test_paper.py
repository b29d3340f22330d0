"""The paper cites what paper.bib has, and nothing else; the Dockerfile runs what there is."""

import re
import unittest

from programs import SOURCE


class Paper(unittest.TestCase):
    def test_references_are_those_of_the_bibliography(self):
        text = (SOURCE / "paper" / "paper.md").read_text()
        known = re.findall(r"^@\w+\{(\w+),", (SOURCE / "paper" / "paper.bib").read_text(), re.M)
        self.assertEqual(set(re.findall(r"@(\w+)\]", text)), set(known))
        for section in ("Summary", "Statement of need", "State of the field", "References"):
            self.assertIn(f"\n# {section}\n", text)

    def test_numbers_are_those_of_the_readme(self):
        text = (SOURCE / "paper" / "paper.md").read_text()
        readme = (SOURCE / "README.md").read_text()
        for number in ("0.116", "0.24", "39 tubes"):
            self.assertIn(number, text)
            self.assertIn(number, readme)


class Dockerfile(unittest.TestCase):
    def test_steps_name_what_there_is(self):
        text = (SOURCE / "Dockerfile").read_text()
        stages = re.findall(r"^FROM debian:bookworm", text, re.M)
        self.assertEqual(len(stages), 2)
        profiles = re.search(r"run package -P(\S+)", text)[1].split(",")
        rules = (SOURCE / "debian" / "rules").read_text()
        for profile in profiles:
            self.assertIn(f"filter {profile},$(DEB_BUILD_PROFILES)", rules)


if __name__ == "__main__":
    unittest.main()
