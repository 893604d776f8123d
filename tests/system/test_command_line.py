"""What every verb has in common: help, flags, exit codes."""

import json
import pathlib
import signal
import subprocess
import unittest

from program import PROGRAM, InFolder, limber, verbs

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

    def test_long_work_stops_on_ctrl_c_and_on_sigterm(self):
        arm = ("--arm", "two_segment")
        self.run_limber("collect", *arm, "--schedule", "random", "--count", 10, "--out", "r.h5")
        for arguments in (
            ("bench", *arm),
            ("bench", *arm, "--training", "r.h5", "--epochs", "1000"),
            ("characterize", *arm, "--steps", "1000"),
        ):
            for sent in (signal.SIGINT, signal.SIGTERM):
                with self.subTest(arguments=arguments, signal=sent):
                    result = self.stopped(sent, *arguments)
                    self.assertEqual(result, (1, "error: stopped on request"))

    def stopped(self, sent, *arguments):
        """The exit code and last line of a command that gets a signal while it works."""
        command = [PROGRAM, *arguments]
        with subprocess.Popen(
            command, cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE
        ) as process:
            while not catches(process.pid, sent):
                self.assertIsNone(process.poll(), "the command ended before it was stopped")
            process.send_signal(sent)
            errors = process.communicate()[1].decode()
            return process.returncode, errors.strip().split("\n")[-1]


def catches(pid, number):
    """Whether a process has a handler for a signal."""
    status = pathlib.Path(f"/proc/{pid}/status").read_text(encoding="ascii")
    caught = next(line for line in status.splitlines() if line.startswith("SigCgt"))
    return bool(int(caught.split()[1], 16) >> (number - 1) & 1)


if __name__ == "__main__":
    unittest.main()
