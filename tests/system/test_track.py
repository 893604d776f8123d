"""`limber execute --track`: the tip follows a path over time; paths and flags that do not fit are
refused by file and line."""

import math
import unittest

from program import InFolder

ARM = ("--arm", "two_segment")


class Track(InFolder):
    def setUp(self):
        super().setUp()
        self.run_limber("collect", *ARM, "--schedule", "random", "--count", 40, "--out", "t.h5")
        self.run_limber("train", *ARM, "--data", "t.h5", "--epochs", 5, "--out", "m.safetensors")

    def circle(self, name="circle.csv", radius_m=0.01, lap_s=4.0):
        lines = ["time_s,x_m,y_m"]
        for k in range(41):
            turn = 2.0 * math.pi * k / 40
            lines.append(f"{lap_s * k / 40:.3f},{0.38 + radius_m * math.cos(turn):.6f},"
                         f"{0.15 + radius_m * math.sin(turn):.6f}")
        self.write(name, "\n".join(lines) + "\n")
        return name

    def track(self, *arguments, code=0):
        return self.run_json("execute", *ARM, "--model", "m.safetensors", *arguments, code=code)

    def test_on_an_arm_that_the_model_knows_the_tip_keeps_to_its_path(self):
        found = self.track("--track", self.circle(), "--laps", 2, "--driver",
                           "model:m.safetensors", "--out", "run.h5", "--svg", "run.svg")
        self.assertEqual((found["status"], found["path"]["laps"]), ("done", 2))
        self.assertAlmostEqual(found["path"]["length_cm"], 2.0 * math.pi, places=1)
        # Half the circle's radius: a tip that stayed in the middle would be off by all of it.
        self.assertLess(found["later_laps"]["rmse_cm"], 0.5)
        self.assertEqual(found["first_lap"]["frames"] + found["later_laps"]["frames"], 161)
        self.assertIn("</svg>", (self.folder / "run.svg").read_text(encoding="utf-8"))
        inspected = self.run_json("inspect", "run.h5")
        self.assertEqual(inspected["frames"], found["frames"] + 1)

    def test_a_run_on_the_virtual_arm_repeats_and_a_disturbance_changes_it(self):
        command = ("--track", self.circle(), "--track-queries", 1000)
        found = self.track(*command)
        self.assertEqual(found["status"], "done")
        self.assertIsNone(found["later_laps"])
        self.assertEqual([found[key] for key in ("goal_reached", "distance_to_goal_cm", "orientation_to_goal_rad",
                                                 "prediction_error_cm", "min_clearance_cm", "replans")],
                         [None] * 5 + [0])
        self.assertEqual(found, self.track(*command))
        disturbed = self.track(*command, "--disturbance", "friction")
        self.assertEqual(disturbed["disturbance"], "friction")
        self.assertNotEqual(disturbed["first_lap"], found["first_lap"])

    def refuses(self, message, *arguments):
        error = self.run_limber("execute", *ARM, *arguments, code=2).stderr
        self.assertIn(message, error)

    def test_what_does_not_fit_is_refused_by_file_and_line(self):
        model = ("--model", "m.safetensors")
        self.refuses("--plan is required, unless --track", *model)
        self.write("late.csv", "time_s,x_m,y_m\n0,0.4,0\n2,0.4,0.1\n1,0.4,0\n")
        self.refuses("late.csv:4:1: time_s = 1 is not later than 2", *model, "--track", "late.csv")
        self.write("far.csv", "time_s,x_m,y_m\n0,0.4,0\n2,0.9,0.1\n")
        self.refuses("far.csv:3: (0.900, 0.100) m is", *model, "--track", "far.csv")
        self.write("behind.csv", "time_s,x_m,y_m\n0,-0.3,0\n2,-0.3,0.1\n")
        self.refuses("behind.csv:2: the path starts at (-0.300, 0.000) m", *model, "--track",
                     "behind.csv")
        self.write("open.csv", "time_s,x_m,y_m\n0,0.38,0.15\n2,0.38,0.16\n")
        self.refuses("open.csv:3: ends 10.0 mm from where the path starts", *model, "--track",
                     "open.csv", "--laps", 2)
        self.refuses("--replan belongs to a plan", *model, "--track", "open.csv", "--replan")
        for kind in ("obstacle", "lost_tracking", "picked_up", "leak"):
            self.refuses("is sampled for a plan", *model, "--track", "open.csv", "--disturbance", kind)


if __name__ == "__main__":
    unittest.main()
