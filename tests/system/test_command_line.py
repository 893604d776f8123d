"""What every verb has in common: help, flags, exit codes."""

import json
import unittest

from program import InFolder, limber, verbs

COMMON_FLAGS = ["--json", "--quiet", "--force", "--jobs", "--seed"]


class CommandLine(InFolder):
    def test_there_are_verbs(self):
        self.assertIn("doctor", verbs())

    def test_version_is_one_line(self):
        self.assertRegex(self.run_limber("--version").stdout, r"^limber \d+\.\d+\.\d+\n$")

    def test_every_verb_has_help_with_an_example_and_the_common_flags(self):
        for verb in verbs():
            with self.subTest(verb=verb):
                text = self.run_limber(verb, "--help").stdout
                self.assertRegex(text, rf"Example:\n(  limber .*\n)*  limber {verb} ?")
                for flag in COMMON_FLAGS:
                    self.assertIn(flag, text)

    def test_every_verb_refuses_an_unknown_flag(self):
        for verb in verbs():
            with self.subTest(verb=verb):
                result = self.run_limber(verb, "--no-such-flag", code=2)
                self.assertEqual(result.stdout, "")
                self.assertNotEqual(result.stderr, "")

    def test_usage_errors_exit_with_2(self):
        for arguments in ([], ["no-such-verb"], ["doctor", "--jobs", "-1"], ["doctor", "--jobs", "x"]):
            with self.subTest(arguments=arguments):
                result = self.run_limber(*arguments, code=2)
                self.assertEqual(result.stdout, "")

    def test_doctor_prints_one_json_object(self):
        self.assertIsInstance(self.run_json("doctor"), dict)

    def test_output_does_not_depend_on_the_locale(self):
        plain = json.loads(limber("doctor", "--json", environment={"LC_ALL": "C"}).stdout)
        other = json.loads(limber("doctor", "--json", environment={"LC_ALL": "de_DE.UTF-8"}).stdout)
        self.assertEqual(plain, other)


if __name__ == "__main__":
    unittest.main()
