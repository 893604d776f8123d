"""Python ends while threads work in limber: they are stopped, and the process ends as it would."""

import signal
import subprocess
import sys
import textwrap
import time
import unittest

from chain import ROOT, InFolder, chain

LONGEST_S = 60.0  # of an end; it takes a fraction of a second, on a machine with nothing else to do
TRIES = 3

WORK = """
    import sys, threading, time
    import limber
    arm = limber.load_arm(sys.argv[1])
    episodes = limber.read_recording(sys.argv[2]).episodes
    data = limber.hold_back_validation(episodes, 0.1, 1)
    settings = limber.best_preset()
    limber.set_epoch_count(settings, 10**7)
    forward = limber.ForwardModel(arm)
    behind = limber.Environment(
        "behind", [], limber.PoseGoal(x_m=-0.35, y_m=0.0, position_tolerance_m=0.001))
    problem = limber.PlanningProblem(arm, limber.MotionModel(forward), behind)

    def train():
        limber.train(arm, data, settings, lambda point: begun.set())

    def plan():
        limber.make_planner().plan(problem, limber.PlannerLimits(time_s=3600), 1,
                                   lambda progress: begun.set())

    def evaluate():
        begun.set()
        while True:
            limber.evaluate(forward, None, episodes * 20)

    begun = threading.Event()
"""


class Exit(InFolder):
    def start(self, script):
        path = self.folder / "script.py"
        path.write_text(textwrap.dedent(WORK) + textwrap.dedent(script), encoding="utf-8")
        return subprocess.Popen(
            [sys.executable, str(path), str(ROOT / "arms" / "two_segment.yaml"),
             str(chain().recording)],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8")

    def end_of(self, process):
        begin = time.monotonic()
        out, err = process.communicate(timeout=LONGEST_S)
        return process.returncode, out, err, time.monotonic() - begin

    def test_daemon_threads_are_stopped(self):
        for work in ("train", "plan", "evaluate"):
            for _ in range(TRIES):
                process = self.start(f"""
                    threading.Thread(target={work}, daemon=True).start()
                    begun.wait()
                    time.sleep(0.2)
                    print("ends")
                    """)
                code, out, err, _ = self.end_of(process)
                self.assertEqual((code, out, err), (0, "ends\n", ""))

    def test_ctrl_c_while_the_main_thread_waits_for_one(self):
        for _ in range(TRIES):
            process = self.start("""
                thread = threading.Thread(target=train)
                thread.start()
                begun.wait()
                print("begun", flush=True)
                thread.join()
                """)
            self.assertEqual(process.stdout.readline(), "begun\n")
            time.sleep(0.2)
            process.send_signal(signal.SIGINT)
            code, _, err, _ = self.end_of(process)
            self.assertEqual(code, -signal.SIGINT, err)
            self.assertIn("KeyboardInterrupt", err)

    def test_a_thread_that_is_no_daemon_ends_its_work_first(self):
        process = self.start("""
            def few():
                limber.set_epoch_count(settings, 5)
                print(limber.train(arm, data, settings).status)
            threading.Thread(target=few).start()
            """)
        code, out, err, _ = self.end_of(process)
        self.assertEqual((code, out), (0, "TrainingStatus.finished\n"), err)

    def test_work_that_begins_at_the_end_is_refused(self):
        process = self.start("""
            import atexit

            def forever():
                while True:
                    try:
                        train()
                    except limber.Interrupted:
                        pass
            threading.Thread(target=forever, daemon=True).start()
            begun.wait()
            """)
        code, _, err, _ = self.end_of(process)
        self.assertEqual(code, 0, err)

    def test_a_forked_child_does_not_wait_for_its_parents_threads(self):
        process = self.start("""
            import os
            threading.Thread(target=train, daemon=True).start()
            begun.wait()
            child = os.fork()
            if child == 0:
                sys.exit(0)
            print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
            """)
        code, out, err, _ = self.end_of(process)
        self.assertEqual((code, out), (0, "0\n"), err)


if __name__ == "__main__":
    unittest.main()
