"""limber.ProcessDriver: an arm behind a process of its own, which vents whatever becomes of the
notebook. What the device was told stands in the driver's own log."""

import contextlib
import io
import os
import pathlib
import signal
import subprocess
import sys
import time
import unittest

import numpy as np

import limber
from chain import ROOT, TWO_SEGMENT, InFolder, chain, run_json

DRIVER = ROOT / "tests" / "python_module" / "logging_driver.py"
NOTEBOOK = ROOT / "tests" / "python_module" / "executing_notebook.py"
LIMIT_S = 30.0  # a loaded machine
OPEN_KPA = 5.0  # a set point beyond it holds valves open
FOREVER_S = 600.0


def exec_of(log, *words):
    return " ".join(["exec:" + sys.executable, str(DRIVER), str(log), *words])


SWAPPED = """schema: limber/driver_calibration/1
arm: two_segment
length_m: {length_m}
valves: [{{channel: 1, sign: 1}}, {{channel: 0, sign: -1}}]
sensors: [{{channel: 1, sign: 1}}, {{channel: 0, sign: -1}}]
zero_kpa: [0, 0]
noise_kpa: [0, 0]
"""


def told(log):
    """What the device was told: "vent", or the largest set point [kPa]."""
    lines = log.read_text(encoding="utf-8").splitlines() if log.exists() else []
    return ["vent" if line.startswith("vent") else
            max(abs(float(word)) for word in line[line.index("[") + 1:line.index("]")].split(","))
            for line in lines]


def planned():
    shared = chain()
    model = limber.MotionModel(limber.ForwardModel(shared.arm))
    problem = limber.PlanningProblem(shared.arm, model, shared.environment)
    plan = limber.make_planner().plan(problem, limber.PlannerLimits(iterations=300), 5).plan
    assert plan
    return plan


class OnAProcess(InFolder):
    def setUp(self):
        super().setUp()
        self.arm, self.environment = chain().arm, chain().environment
        self.plan = planned()
        self.log = self.folder / "log.txt"
        self.said = []

    def driver(self, *words, **settings):
        return limber.ProcessDriver(self.arm, exec_of(self.log, *words), **settings,
                                    simulated=True, on_message=self.said.append)

    def test_a_state_has_the_set_point_in_force(self):
        with self.driver() as driver:
            state = driver.command([4.0, -4.0])
            np.testing.assert_array_equal(state.setpoint_kpa, [4.0, -4.0])
            self.assertAlmostEqual(state.tracker_t, state.time_s + 100.0)
            driver.vent()
            self.assertIsNone(driver.state().setpoint_kpa)

    def test_a_calibration_lies_between_the_driver_and_the_arm(self):
        swapped = self.folder / "calibration.yaml"
        swapped.write_text(SWAPPED.format(length_m=self.arm.length_m))
        with self.driver(calibration=swapped) as driver:
            np.testing.assert_array_equal(driver.limits_kpa, [[-80, 80], [-100, 100]])
            state = driver.command([4.0, 2.0])
        self.assertEqual([kpa for kpa in told(self.log) if kpa != "vent"], [4.0])
        self.assertIn("[-2.0, 4.0]", self.log.read_text())
        np.testing.assert_allclose(state.setpoint_kpa, [4.0, 2.0])
        with self.assertRaisesRegex(limber.InputError, "with 2 segments"):
            limber.ProcessDriver(limber.load_arm(ROOT / "arms" / "three_segment.yaml"),
                                 exec_of(self.log), calibration=swapped)

    def test_a_driver_is_not_believed_to_be_a_simulation(self):
        with self.assertRaisesRegex(limber.InputError, "simulated=True in Python"):
            limber.ProcessDriver(self.arm, exec_of(self.log))
        self.assertEqual(set(told(self.log)), {"vent"})

    def test_a_plan_is_executed_as_on_the_virtual_arm(self):
        with self.driver(log=self.folder / "driver.jsonl") as driver:
            own = limber.execute(self.arm, self.environment, self.plan, driver)
            self.assertTrue(driver.vent_confirmed)
            self.assertFalse(driver.is_real_time)
            np.testing.assert_array_equal(driver.limits_kpa, [[-100, 100], [-80, 80]])
        virtual = limber.execute(self.arm, self.environment, self.plan, limber.VirtualArm(self.arm))
        self.assertEqual(own.status, limber.ExecutionStatus.done)
        np.testing.assert_array_equal(own.episode.setpoint_kpa, virtual.episode.setpoint_kpa)
        self.assertEqual(told(self.log)[-1], "vent")
        self.assertIn("vented", self.said[-1])
        self.assertIn('"type":"set"', (self.folder / "driver.jsonl").read_text().replace(" ", ""))

    def test_recordings_are_the_programs(self):
        schedule = limber.ScheduleSettings(kind=limber.ScheduleKind.random, count=3, episodes=2,
                                           hold_s=0.5, limit_scale=0.8)
        settings = limber.virtual_collection(self.arm, schedule, limber.VirtualArmOptions(seed=7))
        with self.driver(check_rate=False) as driver:
            own = limber.collect(self.arm, settings, driver, self.folder / "own.h5").recording
        run_json("collect", "--arm", TWO_SEGMENT, "--schedule", "random", "--count", 3,
                 "--episodes", 2, "--hold-s", 0.5, "--limit-scale", 0.8, "--seed", 7, "--driver",
                 exec_of(self.folder / "other.txt"), "--simulated", "--out", "program.h5", folder=self.folder)
        program = limber.read_recording(self.folder / "program.h5")
        self.assertEqual(len(own.episodes), 2)
        for one, other in zip(own.episodes, program.episodes):
            np.testing.assert_array_equal(one.setpoint_kpa, other.setpoint_kpa)
        self.assertEqual(own.source, program.source)
        self.assertEqual(told(self.log)[-1], "vent")

    def test_the_arm_by_hand(self):
        driver = self.driver()
        self.assertIsInstance(driver, limber.ArmDriver)
        self.assertIn("logging_driver 1", repr(driver))
        for kpa in (4.0, 8.0, 12.0):
            state = driver.command([kpa, -kpa])
        self.assertGreater(state.time_s, 0.0)
        driver.vent()
        self.assertTrue(driver.vent_confirmed)
        np.testing.assert_allclose(driver.look().pressure_kpa, [0, 0], atol=2.0)  # [kPa]
        driver.command([4.0, -4.0])
        del driver  # what is let go, vents
        self.assertEqual(told(self.log)[-1], "vent")

    def test_a_closed_driver_says_so(self):
        driver = self.driver()
        driver.close()
        driver.close()
        with self.assertRaisesRegex(limber.InputError, "was closed"):
            driver.command([0.0, 0.0])

    def test_what_is_wrong_is_named(self):
        for command, words in [("python3 x.py", "expected exec:COMMAND"),
                               ("exec:", "expected exec:COMMAND"),
                               ("exec:no_such_program", "can't be started")]:
            with self.assertRaisesRegex(limber.InputError, words):
                limber.ProcessDriver(self.arm, command)
        with self.assertRaisesRegex(limber.InputError, "limit_scale = 2"):
            self.driver(limit_scale=2.0)
        three = limber.load_arm(ROOT / "arms" / "three_segment.yaml")
        with self.assertRaisesRegex(limber.SystemFault, "segments"):
            limber.ProcessDriver(three, exec_of(self.log), simulated=True)

    def test_nothing_moves_beyond_the_drivers_limits(self):
        with self.driver(limit_scale=0.02) as driver:
            with self.assertRaisesRegex(limber.InputError, "Nothing was moved"):
                limber.execute(self.arm, self.environment, self.plan, driver)
            schedule = limber.ScheduleSettings(kind=limber.ScheduleKind.random, count=1)
            with self.assertRaisesRegex(limber.InputError, r"ScheduleSettings\(limit_scale=0.02\)"):
                limber.collect(self.arm, limber.virtual_collection(self.arm, schedule), driver,
                               self.folder / "x.h5")
        self.assertEqual(set(told(self.log)), {"vent"})

    def test_messages_go_to_standard_error(self):
        text = io.StringIO()
        with contextlib.redirect_stderr(text):
            driver = limber.ProcessDriver(self.arm, exec_of(self.log), simulated=True)
            driver.command([4.0, 4.0])
            driver.close()
        self.assertIn("vented", text.getvalue())

    def test_signals_stay_pythons(self):
        numbers = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGTSTP)

        def caught():
            (line,) = [line for line in pathlib.Path("/proc/self/status").read_text().splitlines()
                       if line.startswith("SigCgt:")]
            mask = int(line.split()[1], 16)
            return [number for number in numbers if mask >> (number - 1) & 1]
        before = caught()
        with self.driver():
            self.assertEqual(caught(), before)


class Deadman(InFolder):
    """A notebook in a process of its own, whose end or stop may not hold valves open."""

    def setUp(self):
        super().setUp()
        self.log = self.folder / "log.txt"
        limber.write_plan(self.folder / "plan.json", planned())
        self.notebooks = []
        self.addCleanup(self.end)

    def end(self):
        for notebook in self.notebooks:
            if notebook.poll() is None:
                notebook.kill()  # also one that is stopped
            notebook.communicate()

    def start(self, hold_s=FOREVER_S):
        notebook = subprocess.Popen(
            [sys.executable, str(NOTEBOOK), str(TWO_SEGMENT), str(chain().environment_file),
             str(self.folder / "plan.json"), exec_of(self.log, "real_time"), str(hold_s)],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8")
        self.notebooks.append(notebook)
        return notebook

    def wait_until(self, condition, what):
        end = time.monotonic() + LIMIT_S
        while not condition():
            self.assertLess(time.monotonic(), end, f"{what}: {told(self.log)[-20:]}")
            time.sleep(0.02)

    def holds_valves_open(self):
        last = told(self.log)[-1:]
        return bool(last) and last != ["vent"] and last[0] > OPEN_KPA

    def executing(self):
        notebook = self.start()
        self.wait_until(self.holds_valves_open, "the arm was never moved")
        return notebook

    def test_kill_9_of_the_notebook_vents(self):
        notebook = self.executing()
        os.kill(notebook.pid, signal.SIGKILL)
        notebook.wait(LIMIT_S)
        self.wait_until(lambda: told(self.log)[-1] == "vent", "not vented")

    def test_a_breakpoint_vents(self):
        notebook = self.executing()
        os.kill(notebook.pid, signal.SIGSTOP)  # it sends nothing, and its pipes stay open
        self.wait_until(lambda: told(self.log)[-1] == "vent", "not vented")
        self.assertIsNone(notebook.poll())

    def test_a_kernel_restart_vents_and_the_next_kernel_drives(self):
        notebook = self.executing()
        os.kill(notebook.pid, signal.SIGINT)
        self.assertIn("KeyboardInterrupt", notebook.communicate(timeout=LIMIT_S)[1])
        self.assertEqual(told(self.log)[-1], "vent")
        before = len(told(self.log))
        again = self.start(hold_s=0.5)
        output, errors = again.communicate(timeout=LIMIT_S)
        self.assertEqual((again.returncode, output.split()), (0, ["executing", "executed"]), errors)
        later = told(self.log)[before:]
        self.assertGreater(max(kpa for kpa in later if kpa != "vent"), OPEN_KPA)
        self.assertEqual(later[-1], "vent")


if __name__ == "__main__":
    unittest.main()
