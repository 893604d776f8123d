"""What can't be written is found before the work, and messages that can't be printed decide nothing."""

import os
import pathlib
import signal
import subprocess
import tempfile
import time
import unittest

import h5py

from program import PROGRAM, ROOT, InFolder, limber, temporary_files

ARM = ("--arm", "two_segment")
HANG_S = 120.0  # the works below would take hours: a verb that is still running began its own


def tree(folder):
    return sorted(p.relative_to(folder) for p in pathlib.Path(folder).rglob("*"))


class Outputs(InFolder):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix="limber_test_")
        cls.addClassCleanup(temporary.cleanup)
        cls.inputs = pathlib.Path(temporary.name)
        (cls.inputs / "arm.yaml").write_bytes((ROOT / "arms" / "two_segment.yaml").read_bytes())
        for command in (
            ("collect", *ARM, "--schedule", "random", "--count", 8, "--episodes", 3, "--hold-s", 0.5, "--out", "r.h5"),
            ("export", "r.h5", "--csv", "csv"),
            ("train", *ARM, "--data", "r.h5", "--epochs", 3, "--hidden", 8, "--out", "m.safetensors"),
            ("environment", *ARM, "--random", "--count", 1, "--out", "envs"),
        ):
            result = limber(*command, folder=cls.inputs)
            assert result.returncode == 0, result.stderr
        cls.environment = next((cls.inputs / "envs").iterdir())
        result = limber("plan", *ARM, "--no-load", "--environment", cls.environment, "--max-queries", 20000,
                        "--out", "p.json", folder=cls.inputs)
        assert result.returncode == 0, result.stderr

    def works(self):
        """Verbs whose work takes long, the flag of each output, and whether it names a folder."""
        i = self.inputs
        plan = ["plan", *ARM, "--no-load", "--environment", self.environment, "--time-limit-s", 7200]
        execute = ["execute", *ARM, "--plan", i / "p.json", "--environment", self.environment, "--hold-s", 1e6]
        logs = [i / "csv" / "episode_000.csv"] * 2000
        return [
            (["bench", *ARM, "--queries", 1000000000], "--plot", False),
            (["characterize", *ARM, "--steps", 1000], "--out", False),
            (["characterize", *ARM, "--steps", 1000], "--plot", False),
            (["collect", *ARM, "--schedule", "random", "--count", 1000000], "--out", False),
            (["demo", *ARM], "--out", True),
            (["environment", *ARM, "--random", "--count", 100000], "--out", True),
            (["evaluate", *ARM, "--data", i / "r.h5"], "--plots", True),
            (execute, "--out", False),
            (execute, "--svg", False),
            (execute, "--animation", False),
            (["experiment", *ARM, "--model", i / "m.safetensors", "--trials", 1000, "--time-limit-s", 3600],
             "--out", True),
            (["export", i / "r.h5"], "--csv", True),
            (["export", i / "r.h5"], "--motive", True),
            (["export", i / "m.safetensors"], "--onnx", False),
            (["export", i / "arm.yaml"], "--mjcf", False),
            (["import", "csv", *logs, "--mapping", i / "csv" / "mapping.yaml", *ARM], "--out", False),
            (plan, "--out", False),
            (plan, "--csv", False),
            (plan, "--svg", False),
            (plan, "--animation", False),
            ([*plan, "--forest-nodes", 16000000], "--forest", False),
            (["train", *ARM, "--data", i / "r.h5", "--epochs", 10000000], "--out", False),
        ]

    def refused(self, command, *parts):
        result = subprocess.run([PROGRAM, *map(str, command)], cwd=self.folder, stdin=subprocess.DEVNULL,
                                capture_output=True, encoding="utf-8", check=False, timeout=HANG_S)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(result.stderr.count("error: "), 1, result.stderr)
        for part in parts:
            self.assertIn(part, result.stderr)

    def test_an_output_that_cannot_be_written_is_found_before_the_work(self):
        self.write("a_file", "mine\n")
        before = tree(self.folder)
        for command, flag, is_folder in self.works():
            paths = [("", "names no file"), ("-", "names no file"), ("a_file/x/y", "a_file is no folder"),
                     ("/proc/nowhere/x", "no file can be made in /proc"), ("n" * 300, "")]
            paths.append(("a_file", "folder") if is_folder else ("foo/", "names no file"))
            if command[0] in ("demo", "experiment") or flag in ("--plots",):
                paths = [p for p in paths if p[0] != "a_file"]  # tested with those verbs
            for path, reason in paths:
                with self.subTest(verb=command[0], flag=flag, path=path[:20]):
                    self.refused([*command, flag, path], reason)
                    self.assertEqual(tree(self.folder), before)

    def test_inputs_with_impossible_names_are_bad_input(self):
        for arguments in (["--arm", "n" * 5000], ["--arm", "a_file/x.yaml"], ["--environment", "n" * 5000]):
            command = {"--arm": "characterize", "--environment": "plan"}[arguments[0]]
            with self.subTest(command=command, arguments=arguments[0]):
                more = ["--no-load"] if command == "plan" else []
                self.refused([command, *more, *arguments], arguments[0])

    def test_pipes_and_devices_are_no_files_to_read(self):
        pipe = self.folder / "pipe"
        os.mkfifo(pipe)
        for path in (pipe, "/dev/zero"):
            self.refused(["inspect", path], "is a pipe or a device")
            self.refused(["export", path, "--csv", "csv"], "is a pipe or a device")
        self.refused(["train", "--data", pipe], "is a pipe or a device")
        for command in (["evaluate", "--data", "r.h5", "--arm"], ["plan", "--no-load", "--environment"]):
            self.refused([*command, pipe], "is a pipe or a device")
            self.refused([*command, self.folder], "is a folder")


class Messages(InFolder):
    """Standard error that takes nothing."""

    def shell(self, redirections, *arguments):
        return subprocess.run(["sh", "-c", f'"$0" "$@" {redirections}', PROGRAM, *map(str, arguments)],
                              cwd=self.folder, capture_output=True, encoding="utf-8", check=False)

    def test_exit_codes_do_not_depend_on_standard_error(self):
        for redirections in ("2>&-", "2>/dev/full", ">&- 2>&- <&-", "2>/dev/full >/dev/null"):
            with self.subTest(redirections=redirections):
                self.assertEqual(self.shell(redirections, "inspect", "nope").returncode, 2)
                code = self.shell(redirections, "collect", *ARM, "--schedule", "random", "--count", 8, "--hold-s", 0.5,
                                  "--force", "--out", "c.h5").returncode
                self.assertEqual(code, 0)
                self.run_limber("inspect", "c.h5")
                code = self.shell(redirections, "train", *ARM, "--data", "c.h5", "--epochs", 3, "--hidden", 8,
                                  "--force").returncode
                self.assertEqual(code, 0)
                self.run_limber("inspect", "model.safetensors")

    def test_nobody_who_reads_messages_is_no_reason_to_stop(self):
        self.run_limber("collect", *ARM, "--schedule", "random", "--count", 8, "--hold-s", 0.5, "--out", "c.h5")
        reader, writer = os.pipe()
        os.close(reader)
        train = subprocess.run([PROGRAM, "train", *ARM, "--data", "c.h5", "--epochs", "3", "--hidden", "8"],
                               cwd=self.folder, stdout=subprocess.PIPE, stderr=writer, check=False,
                               restore_signals=True)
        os.close(writer)
        self.assertEqual(train.returncode, 0)

    def test_a_result_that_cannot_be_printed_is_a_fault(self):
        for command in (("doctor",), ("execute", "--help"), ("--version",)):
            self.assertEqual(self.shell(">/dev/full", *command).returncode, 3, command)


def catches(process, number):
    """Whether a process has a handler of its own for a signal."""
    status = pathlib.Path(f"/proc/{process}/status").read_text(encoding="utf-8")
    return bool(int(status.split("SigCgt:")[1].split()[0], 16) >> (number - 1) & 1)


class Stopped(InFolder):
    def stop(self, *arguments):
        """Interrupted as soon as it has said or written anything."""
        with open(self.folder / "messages", "w+", encoding="utf-8") as messages:
            process = subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=self.folder, stdin=subprocess.DEVNULL,
                                       stdout=subprocess.DEVNULL, stderr=messages)
            while len(tree(self.folder)) < 2 and (self.folder / "messages").stat().st_size == 0:
                time.sleep(0.01)
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(timeout=HANG_S), 1)
            messages.seek(0)
            return messages.read()

    def test_the_demo_does_not_promise_to_go_on(self):
        said = self.stop("demo", *ARM, "--out", "out")
        self.assertIn("error: stopped on request; the next limber demo starts from the beginning", said)
        self.assertNotIn("--resume", said)
        self.assertEqual(temporary_files(self.folder), [])

    def test_a_fit_of_recordings_writes_nothing(self):
        self.run_limber("collect", *ARM, "--schedule", "random", "--count", 3, "--hold-s", 0.5, "--out", "r.h5")
        with h5py.File(self.folder / "r.h5", "r+") as file:
            for k in range(1, 1000):  # seconds of work
                file.copy("episodes/000000", f"episodes/{k:06d}")
        process = subprocess.Popen([PROGRAM, "characterize", *ARM, "--recording", "r.h5", "--out", "c.yaml"],
                                   cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        while not catches(process.pid, signal.SIGINT):
            self.assertIsNone(process.poll())
        process.send_signal(signal.SIGINT)
        _, messages = process.communicate(timeout=HANG_S)
        self.assertEqual(process.returncode, 1, messages)
        self.assertIn(b"error: stopped on request", messages)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["r.h5"])


if __name__ == "__main__":
    unittest.main()
