"""Man pages and completions, made from --help: every verb and flag is there, and their readers
accept them."""

import re
import shutil
import subprocess
import sys
import unittest

from program import PROGRAM, ROOT, InFolder, limber, verbs


class CommandPages(InFolder):
    def setUp(self):
        super().setUp()
        subprocess.run([sys.executable, ROOT / "tools" / "command_pages.py", PROGRAM, self.folder],
                       check=True)

    def flags(self, verb):
        text = limber(verb, "--help").stdout
        names = re.findall(r"^  ((?:-\w,)?--[\w,-]+)", text, flags=re.M)
        return {name for one in names for name in one.split(",") if name.startswith("--")}

    def test_every_verb_has_a_page_with_all_its_flags(self):
        for verb in verbs():
            page = (self.folder / "man1" / f"limber-{verb}.1").read_text(encoding="utf-8")
            written = page.replace("\\-", "-")
            for flag in self.flags(verb):
                self.assertIn(f"\\fB{flag}\\fR", written)
            self.assertIn(f"limber-{verb}", (self.folder / "man1" / "limber.1")
                          .read_text(encoding="utf-8").replace("\\-", "-"))

    def test_pages_are_read_without_warnings(self):
        groff = shutil.which("groff")
        if not groff:
            self.skipTest("groff is not installed: no page was read")
        for page in sorted((self.folder / "man1").iterdir()):
            result = subprocess.run([groff, "-man", "-Tutf8", "-ww", "-Kutf8", page],
                                    capture_output=True, encoding="utf-8", check=False)
            if "can't find" in result.stderr or "cannot find" in result.stderr:
                self.skipTest("groff-base lacks preconv: no page was read")
            warnings = [line for line in result.stderr.splitlines() if "break" not in line
                        and "adjust" not in line]  # of long words
            self.assertEqual(warnings, [], page.name)

    def completed(self, *words):
        script = (f"source {self.folder}/bash/limber; COMP_WORDS=(\"$@\"); "
                  "COMP_CWORD=$(($# - 1)); _limber; printf '%s\\n' \"${COMPREPLY[@]}\"")
        result = subprocess.run(["bash", "-c", script, "bash", *words], cwd=self.folder,
                                capture_output=True, encoding="utf-8", check=True)
        return result.stdout.split()

    def test_bash_completes_verbs_flags_names_and_files(self):
        self.assertEqual(set(self.completed("limber", "")) - {"--help", "--version"}, set(verbs()))
        self.assertEqual(self.completed("limber", "plan", "--time"), ["--time-limit-s"])
        self.assertIn("three_segment", self.completed("limber", "plan", "--arm", "th"))
        self.assertIn("01_pillar", self.completed("limber", "plan", "--environment", "01"))
        self.write("plan.json", "{}")
        self.assertEqual(self.completed("limber", "verify", "--plan", "pl"), ["plan.json"])
        for verb in verbs():
            self.assertGreaterEqual(set(self.completed("limber", verb, "--")), self.flags(verb))

    def test_zsh_accepts_its_completion(self):
        zsh = shutil.which("zsh")
        if not zsh:
            self.skipTest("zsh is not installed: its completion was not read")
        subprocess.run([zsh, "-n", self.folder / "zsh" / "_limber"], check=True)
        # Found among zsh's completions, and loaded without a word.
        script = ("fpath=($1 $fpath); autoload -Uz compinit && compinit -u -D; "
                  "print ${_comps[limber]}; autoload +X _limber")
        result = subprocess.run([zsh, "-f", "-c", script, "zsh", self.folder / "zsh"],
                                capture_output=True, encoding="utf-8", check=True)
        self.assertEqual((result.stdout, result.stderr), ("_limber\n", ""))


if __name__ == "__main__":
    unittest.main()
