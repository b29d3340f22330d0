"""The examples in the docstrings and in the pages do what they say."""

import doctest
import inspect
import os
import re
import tempfile
import unittest

import vasorod
from cases import SOURCE

OPTIONS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE


def documented():
    """(name, docstring) of the package and of everything public in it."""
    yield "vasorod", vasorod.__doc__
    for name in vasorod.__all__:
        thing = getattr(vasorod, name)
        yield name, thing.__doc__
        if inspect.isclass(thing):
            for member, value in vars(thing).items():
                if not member.startswith("_"):
                    yield f"{name}.{member}", value.__doc__


class Examples(unittest.TestCase):
    def setUp(self):
        # Pages name files from the root of the sources and write into results/.
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        os.symlink(SOURCE / "benchmarks", os.path.join(scratch.name, "benchmarks"))
        os.symlink(SOURCE / "meshes", os.path.join(scratch.name, "meshes"))
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(scratch.name)

    def run_examples(self, text, name, names):
        test = doctest.DocTestParser().get_doctest(text, names, name, name, 0)
        said = []
        runner = doctest.DocTestRunner(optionflags=OPTIONS)
        runner.run(test, out=said.append, clear_globs=False)
        self.assertEqual(runner.failures, 0, "".join(said))
        return len(test.examples), test.globs

    def test_in_docstrings(self):
        names, count = {"os": os, "tempfile": tempfile}, 0
        for name, text in documented():
            tried, found = self.run_examples(text, name, dict(names))
            count += tried
            if name == "vasorod":  # the others go on with its scene and result
                names.update(found)
        self.assertGreater(count, 30)

    def test_in_pages(self):
        for page in ("docs/python.md", "README.md"):
            text = (SOURCE / page).read_text()
            blocks = re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
            examples = [block for block in blocks if ">>>" in block]
            self.assertTrue(examples, page)
            names = {}
            for k, block in enumerate(examples):
                _, names = self.run_examples(block, f"{page}, block {k + 1}", names)


if __name__ == "__main__":
    unittest.main()
