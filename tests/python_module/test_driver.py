"""limber.driver.serve: the protocol's answers, and that valves never stay open."""

import io
import json
import os
import signal
import subprocess
import sys
import time
import unittest

import limber.driver
from chain import ROOT, InFolder

DRIVER = ROOT / "tests" / "python_module" / "logging_driver.py"
LIMIT_S = 10.0  # a loaded machine


class Served(InFolder):
    def setUp(self):
        super().setUp()
        self.log = self.folder / "log.txt"
        self.process = subprocess.Popen(
            [sys.executable, str(DRIVER), str(self.log)], stdin=subprocess.PIPE,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8")
        self.addCleanup(self.end)

    def end(self):
        if self.process.poll() is None:
            self.process.kill()
        for pipe in (self.process.stdin, self.process.stdout, self.process.stderr):
            pipe.close()
        self.process.wait()

    def ask(self, **message):
        self.process.stdin.write(json.dumps(message) + "\n")
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())

    def set(self, *pressure_kpa, seq=1):
        return self.ask(type="set", seq=seq, t=0.0, pressure_kpa=pressure_kpa)

    def logged(self):
        return self.log.read_text(encoding="utf-8").splitlines() if self.log.exists() else []

    def wait_for_vent(self, since):
        end = time.monotonic() + LIMIT_S
        while time.monotonic() < end:
            if any(line.startswith("vent") for line in self.logged()[since:]):
                return
            time.sleep(0.01)
        self.fail("not vented: " + " ".join(self.logged()))

    def test_hello_says_what_it_is(self):
        self.assertEqual(self.ask(type="hello", protocol=1), {
            "type": "hello", "protocol": 1, "driver": "logging_driver 1", "device": "a file",
            "rate_hz": 20.0, "segments": 2, "tracked": True, "real_time": False,
            "limit_kpa": [100.0, 80.0]})

    def test_states_are_those_of_the_arm(self):
        arm = limber.VirtualArm(limber.load_arm(ROOT / "arms" / "two_segment.yaml"))
        for seq in range(1, 6):
            state = self.set(10.0, -20.0, seq=seq)
            expected = arm.command([10.0, -20.0])
            self.assertEqual((state["type"], state["seq"]), ("state", seq))
            self.assertAlmostEqual(state["t"], expected.time_s)
            self.assertEqual(state["pressure_kpa"], expected.pressure_kpa.tolist())
            self.assertEqual(state["backbone"], expected.backbone.tolist())
            self.assertEqual(state["setpoint_kpa"], [10.0, -20.0])
            self.assertAlmostEqual(state["tracker_t"], expected.time_s + 100.0)

    def test_set_points_in_force_and_the_trackers_clock_are_told(self):
        class Late(limber.driver.Driver):
            segment_count = 2
            in_force = [0.0, 0.0]

            def command(self, setpoint_kpa):
                state = limber.ArmState(0.5, [0.0, 0.0], setpoint_kpa=self.in_force, tracker_t=7.25)
                self.in_force = setpoint_kpa
                return state

            def vent(self):
                return limber.ArmState(0.5, [0.0, 0.0])
        said = io.BytesIO()
        request = {"type": "set", "seq": 1, "t": 0.0, "pressure_kpa": [2.0, 3.0]}
        read_end, write_end = os.pipe()
        with open(write_end, "wb") as requests:
            requests.write(2 * (json.dumps(request).encode() + b"\n"))
        with open(read_end, "rb") as requests:
            limber.driver.serve(Late(), requests, said)
        first, second = [json.loads(line) for line in said.getvalue().splitlines()]
        self.assertEqual((first["setpoint_kpa"], second["setpoint_kpa"]), ([0, 0], [2, 3]))
        self.assertEqual(second["tracker_t"], 7.25)

    def test_bodies_stand_in_place_of_the_backbone(self):
        class Tracked(limber.driver.Driver):
            segment_count = 1

            def command(self, setpoint_kpa):
                return limber.ArmState(0.5, setpoint_kpa)

            def vent(self):
                return limber.ArmState(0.5, [0.0])

            def bodies(self):
                return [[1, 2, 3, 0, 0, 0, 1]]
        said = io.BytesIO()
        request = {"type": "set", "seq": 1, "t": 0.0, "pressure_kpa": [2.0]}
        read_end, write_end = os.pipe()
        with open(write_end, "wb") as requests:
            requests.write(json.dumps(request).encode() + b"\n")
        with open(read_end, "rb") as requests:
            limber.driver.serve(Tracked(), requests, said)
        state = json.loads(said.getvalue())
        self.assertEqual(state["bodies"], [[1, 2, 3, 0, 0, 0, 1]])
        self.assertNotIn("backbone", state)

    def test_the_end_of_the_input_vents(self):
        self.set(10.0, 10.0)
        before = len(self.logged())
        self.process.stdin.close()
        self.assertEqual(self.process.wait(LIMIT_S), 0)
        self.assertIn("vent", self.logged()[before])

    def test_other_requests_do_not_keep_valves_open(self):
        self.set(10.0, 10.0)
        before = len(self.logged())
        self.ask(type="hello", protocol=1)
        self.process.stdin.write('{"type": "unknown"}\n')
        self.process.stdin.flush()
        self.wait_for_vent(before)

    def test_silence_after_a_set_vents_once(self):
        self.set(10.0, 10.0)
        before = len(self.logged())
        self.wait_for_vent(before)
        time.sleep(0.5)
        self.assertEqual(len(self.logged()), before + 1)
        self.assertEqual(self.set(5.0, 5.0, seq=2)["seq"], 2)

    def test_a_killed_caller_vents(self):
        caller = ("import subprocess, sys, time\n"
                  "p = subprocess.Popen(sys.argv[1:], stdin=subprocess.PIPE, "
                  "stdout=subprocess.PIPE)\n"
                  "p.stdin.write(b'{\"type\": \"set\", \"seq\": 1, \"pressure_kpa\": [9, 9]}\\n')\n"
                  "p.stdin.flush()\n"
                  "p.stdout.readline()\n"
                  "print('open', flush=True)\n"
                  "time.sleep(60)\n")
        log = self.folder / "other.txt"
        with subprocess.Popen([sys.executable, "-c", caller, sys.executable, str(DRIVER), str(log)],
                              stdout=subprocess.PIPE) as notebook:
            notebook.stdout.readline()
            self.log = log
            before = len(self.logged())
            os.kill(notebook.pid, signal.SIGKILL)  # a dead kernel
            self.wait_for_vent(before)

    def test_sigterm_vents(self):
        self.ask(type="hello", protocol=1)
        self.process.send_signal(signal.SIGTERM)
        self.process.wait(LIMIT_S)
        self.assertIn("vent", self.logged()[-1])

    def test_a_failed_device_is_a_fault_and_vents(self):
        self.assertEqual(self.set(13.0, 0.0), {"type": "fault",
                                               "message": "OSError: valve 0 is hot"})
        self.assertIn("vent", self.logged()[-1])

    def test_own_limits_hold(self):
        self.assertIn("beyond the driver's limits", self.set(10.0, 90.0)["message"])
        self.assertIn("the arm has 2 segments", self.set(10.0)["message"])
        self.assertFalse(any(line.startswith("set") for line in self.logged()))


SLOW_VENT = """
import signal, sys, time
import limber.driver

class Slow(limber.driver.Driver):
    segment_count = 1

    def command(self, setpoint_kpa):
        raise NotImplementedError

    def vent(self):
        print("venting", file=sys.stderr, flush=True)
        time.sleep(0.5)
        print("vented", file=sys.stderr, flush=True)

signal.signal(signal.SIGINT, signal.default_int_handler)  # whoever started the tests
limber.driver.serve(Slow())
"""


class LastVent(unittest.TestCase):
    def test_no_second_signal_cuts_it_short(self):
        ends = {"SIGTERM": lambda process: process.send_signal(signal.SIGTERM),
                "SIGINT": lambda process: process.send_signal(signal.SIGINT),
                "the end of the input": lambda process: process.stdin.close()}
        for end, begin in ends.items():
            for second in (signal.SIGTERM, signal.SIGINT):
                with self.subTest(end=end, second=second), subprocess.Popen(
                        [sys.executable, "-c", SLOW_VENT], stdin=subprocess.PIPE,
                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8") as process:
                    process.stdin.write('{"type": "hello", "protocol": 1}\n')
                    process.stdin.flush()
                    process.stdout.readline()  # it serves
                    begin(process)
                    self.assertEqual(process.stderr.readline(), "venting\n")
                    process.send_signal(second)
                    self.assertEqual(process.stderr.readline(), "vented\n")


class Refused(unittest.TestCase):
    def test_a_driver_without_segments_is_refused(self):
        class Nothing(limber.driver.Driver):
            def command(self, setpoint_kpa):
                raise NotImplementedError

            def vent(self):
                raise NotImplementedError
        with self.assertRaisesRegex(ValueError, "segment_count = 0"):
            limber.driver.serve(Nothing())


if __name__ == "__main__":
    unittest.main()
