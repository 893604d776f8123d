"""What every verb has in common: help, flags, exit codes."""

import json
import pathlib
import signal
import subprocess
import unittest

from program import PROGRAM, ROOT, InFolder, limber, numeric_flags, verbs

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
        for wrong in ("plann", "--jsn"):
            self.assertIn(f"error: '{wrong}': no verb", self.run_limber(wrong, code=2).stderr)

    def test_no_help_shows_a_number_for_a_word_or_a_flag_without_name(self):
        for verb in verbs():
            self.assertNotRegex(self.run_limber(verb, "--help").stdout, r"(?m)ENUM:|Excludes: *$|\(\d+x\)")

    def test_a_number_out_of_range_is_told_in_words(self):
        for flag, value in (("--time-limit-s", 0), ("--max-queries", 0), ("--cost-threshold", -5)):
            said = self.run_limber("plan", "--no-load", "--environment", "01_pillar", flag, value, code=2).stderr
            self.assertIn(f"{flag}: '{value}' found; expected more than 0", said)
        for flag, value, wanted in (("--margin-m", "1cm", "finite number from 0 to 1000"),
                                    ("--jobs", "1.5", "whole number from 0 to 1024"),
                                    ("--max-queries", "1e3", "whole number more than 0"),
                                    ("--seed", "x", "whole number of at least 0")):
            said = self.run_limber("plan", flag, value, code=2).stderr
            self.assertIn(f"error: {flag}: '{value}' found; expected a {wanted}\n", said)

    def test_every_numeric_flag_refuses_what_is_no_plain_finite_number(self):
        flags = [(verb, *flag) for verb in verbs() for flag in numeric_flags(verb)]
        self.assertGreater(len(flags), 60, "the list is taken from --help")
        self.assertIn(("plan", "--margin-m", "FLOAT"), flags)
        for verb, flag, kind in flags:
            wrong = ["nan", "inf", "-inf", "1e400", "18446744073709551616"]
            if flag == "--seed" or (verb, flag) == ("plan", "--margin-m"):  # one of each kind
                wrong += ["", "1 ", "0x10", "1,5"] + ([] if kind == "FLOAT" else ["1.5", "1e3", "-1"])
            for value in wrong:
                with self.subTest(verb=verb, flag=flag, value=value):
                    result = self.run_limber(verb, f"{flag}={value}", code=2)
                    self.assertIn(flag, result.stderr)
                    self.assertRegex(result.stderr, "found; expected a (finite|whole) number|required")
                    self.assertEqual(result.stdout, "")

    def test_a_number_means_what_it_says(self):
        """Zeros before it don't make it octal, and the largest seed is the largest."""
        for given, meant in (("010", 10), ("+7", 7), ("18446744073709551615", 2**64 - 1)):
            result = self.run_json(
                "plan", "--no-load", "--environment", "01_pillar", "--max-iterations", 1,
                "--seed", given, code=1,
            )
            self.assertEqual(result["seed"], meant)

    def test_flags_that_would_be_passed_over_are_refused(self):
        planned = ("--no-load", "--environment", "01_pillar")
        run = ("execute", "--plan", "p.json", "--environment", "01_pillar", "--replan")
        for arguments, said in (
            (("plan", "--no-load", "--build-forest", "--forest", "f", "--planner", "paper"), "--planner: a forest alone"),
            (("plan", *planned, "--simulated"), "--start-from-driver"),
            (("plan", *planned, "--forest", "f", "--rate-limit", 50), "--rate-limit: forests are grown"),
            (("plan", *planned, "--forest", "f", "--stay-recorded"), "--stay-recorded: needs a network"),
            (("studio", "--calibration", "c.yaml"), "--driver"),
            (("characterize", "--limit-scale", 0.3), "--limit-scale: nothing but a driver's"),
            (("environment", "check", "01_pillar", "--count", 3), "--count: check has no use for it"),
            (("environment", "--random", "--out", "e", "--svg", "e.svg"), "--svg: --random has no use for it"),
            (run, "--replan: needs a network"),
            ((*run, "--model", "m.safetensors", "--dry-run"), "--dry-run: what --replan commands"),
            (("campaign", "c.yaml", "--status", "--shard", "0/2"), "--shard"),
            (("bench", "--training", "r.h5", "--quick"), "--quick"),
            (("campaign", "c.yaml", "--seed", 3), "--seed: is a key of the campaign's file"),
            (("execute", "--plan", "p.json", "--environment", "01_pillar", "--dry-run", "--svg", "x.svg"),
             "--svg: --dry-run moves nothing"),
            (("collect", "--dry-run", "--noise-m", 0.1, "--out", "x.h5"), "--noise-m: --dry-run moves nothing"),
            (("collect", "--schedule", "identify", "--hold-s", 3, "--out", "x.h5"), "has its own holds"),
            (("inspect", "three_segment", "--arm", "two_segment"), "not the arm of --arm, 'two_segment'"),
            (("export", "r.h5", "--motive", "d", "--occlusion-s", 2), "--occlusions"),
            (("export", "r.h5", "--motive", "d", "--rate-hz", 0), "expected more than 0"),
            (("export", "01_pillar", "--csv", "d"), "nothing else can be exported"),
            (("import", "csv", "one.csv", "--time-offset-s", 3, "--dry-run"), "--pressures"),
            (("plan", *planned, "--goal-margin-rad", 0.1), "--goal-margin-rad 0.1: the goal of"),
            (("plan", *planned, "--limit", "0:-50,50", "--limit", "0:-20,20"), "the segment has a range already"),
            (("studio", "--arm", "two_segment", "--model", ROOT / "families/three_segment.safetensors"),
             "three_segment.safetensors: trained for arm"),
            # What is refused leaves nothing that blocks the corrected command.
            (("family", "--arm", "motor_driven", "--out", "f.safetensors"), "driven by pressures"),
            (("family", "--noise-m", -1, "--out", "f.safetensors"), "noise_m = -1"),
            (("family", "--tube-runs", 10, "--out", "f.safetensors"), "--tube-runs 10: so few can't show"),
        ):
            with self.subTest(arguments=arguments):
                self.assertIn(said, self.run_limber(*arguments, code=2).stderr)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_planner_settings_that_are_no_numbers_are_refused(self):
        for verb in ("plan", "experiment"):
            for value in ("ompl:SST,pruning_radius=nan", "default,goal_steering_share=inf"):
                result = self.run_limber(verb, "--planner", value, code=2)
                self.assertIn("expected a finite number", result.stderr)

    def test_lists_of_numbers_with_commas_are_told_to_use_blanks(self):
        result = self.run_limber("train", "--data", "x.h5", "--windows", "8,32", code=2)
        self.assertIn("--windows: '8,32' found; expected numbers with blanks", result.stderr)

    def test_names_from_files_cannot_command_the_terminal(self):
        self.write("arm.yaml", 'schema: limber/arm/1\nname: "\\e[2Jgone"\nsegments: 3\n')
        for flags in ((), ("--json",)):
            result = limber("inspect", "arm.yaml", *flags, folder=self.folder)
            self.assertNotIn("\x1b", result.stdout + result.stderr)
        environment = {
            "schema": "limber/environment/1", "name": "\x1b[2J\u009b1m\u202e", "obstacles": [],
            "start": "rest", "goal": {"x_m": 0.4, "y_m": 0.2, "position_tolerance_m": 0.03},
        }
        self.write("e.yaml", json.dumps(environment))
        text = self.run_limber("inspect", "e.yaml").stdout
        self.assertIn("'\\x1b[2J\\x9b1m\\u202e'", text)
        plain = self.run_limber("inspect", "e.yaml", "--json").stdout
        self.assertFalse({"\x1b", "\u009b", "\u202e"} & set(plain))
        self.assertEqual(json.loads(plain)["name"], environment["name"])
        refused = self.run_limber("inspect", "\x1b[2J.yaml", code=2)
        self.assertNotIn("\x1b", refused.stderr)
        refused = self.run_limber("plan", "--no-such-flag\x1b[2J", code=2)
        self.assertNotIn("\x1b", refused.stderr)

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
