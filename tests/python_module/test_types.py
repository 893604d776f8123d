"""Stubs agree with the module, and mypy with the examples."""

import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import unittest

import limber
from chain import EXAMPLES, ROOT, InFolder

HAS_MYPY = importlib.util.find_spec("mypy") is not None


class Stubs(unittest.TestCase):
    def test_results_that_pybind11_does_not_know(self):
        stub = (pathlib.Path(limber.__file__).parent / "_limber.pyi").read_text(encoding="utf-8")
        for line in ("def compensation(self) -> CompensationModel | None:",
                     "def rest(self) -> npt.NDArray[np.float32] | None:",
                     "def with_setpoints_only(episodes: Iterable[Episode]) -> list[Episode]:"):
            self.assertIn(line, stub)
        self.assertRegex(stub, r"def export_csv\(.*\) -> list\[pathlib\.Path\]:")


@unittest.skipUnless(HAS_MYPY, "mypy is not installed: no type was checked")
class Types(InFolder):
    def checked(self, *arguments):
        package = pathlib.Path(limber.__file__).parents[1]
        result = subprocess.run(
            [sys.executable, "-m", *map(str, arguments)], cwd=self.folder, capture_output=True,
            encoding="utf-8", check=False,
            env={**os.environ, "MYPYPATH": str(package), "MYPY_CACHE_DIR": str(self.folder)})
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_stubs_are_the_modules(self):
        self.checked("mypy.stubtest", "limber", "--ignore-missing-stub",
                     "--allowlist", ROOT / "tests" / "python_module" / "stubtest_allowed.txt",
                     "--ignore-unused-allowlist")

    def test_examples_have_the_types_they_say(self):
        for example in sorted(EXAMPLES.glob("*.py")):
            # Of what torch has, not all says its types.
            untyped = ["--allow-untyped-calls"] if "pytorch" in example.name else []
            self.checked("mypy", "--strict", "--no-warn-unused-ignores", *untyped, example)

    def test_mypy_refuses_what_is_wrong(self):
        page = ROOT / "tests" / "python_module" / "refused_types.py"
        package = pathlib.Path(limber.__file__).parents[1]
        result = subprocess.run(
            [sys.executable, "-m", "mypy", "--strict", str(page)], cwd=self.folder,
            capture_output=True, encoding="utf-8", check=False,
            env={**os.environ, "MYPYPATH": str(package), "MYPY_CACHE_DIR": str(self.folder)})
        expected = {number: line.split("# ")[1].split(":")[0]
                    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1)
                    if "  # " in line}
        found = dict((int(number), code) for number, code in
                     re.findall(r"refused_types.py:(\d+): error: .*\[([\w-]+)\]$", result.stdout,
                                flags=re.M))
        self.assertEqual(found, expected, result.stdout)


if __name__ == "__main__":
    unittest.main()
