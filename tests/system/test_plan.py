"""`limber plan` with the no-load model: results, exit codes, pictures, broken environments."""

import copy
import json
import math
import unittest

from program import InFolder

ARM = ("--arm", "two_segment", "--no-load")
BUDGET = ("--max-iterations", 400)

# Easy for the arm of two segments, 0.47 m long: a pillar beside its way.
PILLAR = {
    "schema": "limber/environment/1",
    "name": "pillar",
    "obstacles": [{"circle": {"x_m": 0.3, "y_m": -0.25, "radius_m": 0.04}}],
    "start": "rest",
    "goal": {"x_m": 0.38, "y_m": 0.2, "position_tolerance_m": 0.03},
}

KEYS = {
    "status", "reason", "limit", "best_partial", "planner", "model", "seed", "cost_kpa", "cost_psi",
    "first_solution", "first_candidate_s", "first_certificate_s", "largest_clearance_cm", "time_s", "queries", "nodes", "distance_to_goal_cm", "clearance_cm", "frames",
}


def changed(**parts):
    environment = copy.deepcopy(PILLAR)
    environment.update(parts)
    return environment


class Plan(InFolder):
    def plan_file(self, environment, name="e.yaml"):
        return self.write(name, json.dumps(environment))  # JSON is YAML

    def plan(self, environment, *arguments, code=0):
        path = self.plan_file(environment)
        return self.run_json("plan", *ARM, *BUDGET, "--environment", path, *arguments, code=code)

    def test_a_problem_that_cannot_be_planned_in_is_told_even_when_quiet(self):
        goal = {"x_m": 3.0, "y_m": 0.2, "position_tolerance_m": 0.03}
        blocked = [{"circle": {"x_m": 0.2, "y_m": 0.0, "radius_m": 0.04}}]
        for parts, status in (({"goal": goal}, "goal_unreachable"),
                              ({"obstacles": blocked}, "invalid_start")):
            with self.subTest(status=status):
                path = self.plan_file(changed(**parts))
                found = self.run_limber("plan", *ARM, *BUDGET, "--environment", path, "--quiet",
                                        "--svg", "p.svg", code=2)
                self.assertIn(f"error: no plan: {status}: ", found.stderr)
                self.assertEqual(found.stdout, "")
                self.assertFalse((self.folder / "p.svg").exists())
                found = self.run_limber("environment", "check", path, "--arm", "two_segment",
                                        "--quiet", code=2)
                self.assertIn(status, found.stderr)
                found = self.run_json("environment", "check", path, "--arm", "two_segment", code=2)
                self.assertEqual(found["status"], status)

    def test_where_nothing_keeps_the_clearance_the_largest_that_gave_a_plan_is_named(self):
        found = self.plan(PILLAR, "--margin-m", "0.2", code=2)
        self.assertEqual(found["status"], "invalid_start")
        self.assertIn("with less clearance than the 20.00 cm asked for there is a plan", found["reason"])
        self.assertGreater(found["largest_clearance_cm"], 0.0)
        self.assertLess(found["largest_clearance_cm"], 20.0)

    def test_the_no_load_model_keeps_no_clearance_and_says_so(self):
        path = self.plan_file(PILLAR)
        found = self.run_limber("plan", *ARM, *BUDGET, "--environment", path)
        self.assertIn("warning: the no-load model's error is not known", found.stderr)
        found = self.run_limber("plan", *ARM, *BUDGET, "--environment", path, "--margin-m", "0")
        self.assertNotIn("error is not known", found.stderr)

    def test_forest_nodes_alone_are_refused(self):
        error = self.run_limber("plan", *ARM, *BUDGET, "--environment", "01_pillar", "--forest-nodes", 20, code=2).stderr
        self.assertIn("--forest-nodes 20: nothing would be grown; give --forest FILE or --build-forest too", error)

    def test_recordings_that_nobody_knows_cannot_be_kept_to(self):
        path = self.plan_file(PILLAR)
        found = self.run_limber("plan", *ARM, *BUDGET, "--environment", path, "--stay-recorded",
                                code=2)
        self.assertIn("--stay-recorded: the model does not store", found.stderr)

    def test_a_byte_order_mark_changes_nothing(self):
        self.plan(PILLAR, "--out", "p.json")
        text = (self.folder / "p.json").read_bytes()
        (self.folder / "bom.json").write_bytes(b"\xef\xbb\xbf" + text)
        for name in ("p.json", "bom.json"):
            self.assertEqual(self.run_json("inspect", name)["kind"], "plan")
            self.run_limber("export", name, "--csv", name + ".csv")

    def test_a_forest_is_grown_once_and_never_stale(self):
        rest = self.plan_file(PILLAR, "rest.yaml")

        def said(*arguments, nodes=2000):
            budget = BUDGET if "--environment" in arguments else ()
            forest = ("--forest", "f", "--forest-nodes", nodes)
            return self.run_limber("plan", *ARM, *budget, *forest, *arguments).stderr

        self.assertIn("f: 2000 motions", said("--environment", rest))
        grown = (self.folder / "f").read_bytes()
        self.assertNotIn("motions", said("--environment", rest))
        self.assertIn("f: has 2000 motions, and is used as it is; --build-forest grows 3000",
                      said("--environment", rest, nodes=3000))
        self.assertEqual((self.folder / "f").read_bytes(), grown)
        self.assertIn("growing it again, as asked for", said("--build-forest"))
        self.assertEqual((self.folder / "f").read_bytes(), grown, "same seed, same forest")
        other = self.run_limber("plan", "--arm", "three_segment", "--no-load", "--forest", "f",
                                "--forest-nodes", 2000, "--build-forest")
        self.assertIn("growing it again", other.stderr)
        other = (self.folder / "f").read_bytes()
        refused = self.run_limber("plan", *ARM, *BUDGET, "--forest", "f", "--environment", rest, code=2)
        self.assertIn("f: grown for another arm, model, valves or start; --build-forest replaces it",
                      refused.stderr)
        self.assertEqual((self.folder / "f").read_bytes(), other)

    def test_a_forest_of_another_form_is_grown_again_where_asked_for(self):
        rest = self.plan_file(PILLAR, "rest.yaml")
        forest = ("--forest", "f", "--forest-nodes", 2000)
        plan = ("plan", *ARM, *BUDGET, *forest, "--environment", rest)
        self.run_limber(*plan)
        grown = (self.folder / "f").read_bytes()
        (self.folder / "f").write_bytes(grown.replace(b"limber/forest/3", b"limber/forest/1"))
        refused = self.run_limber(*plan, code=2)
        self.assertIn("f: schema 'limber/forest/1'; expected limber/forest/3: --build-forest grows "
                      "it again", refused.stderr)
        self.run_limber(*plan, "--build-forest")
        self.assertEqual((self.folder / "f").read_bytes(), grown)

    def test_what_is_no_forest_is_never_replaced(self):
        rest = self.plan_file(PILLAR, "rest.yaml")
        self.write("f", "mine")
        for flags in ([], ["--build-forest"]):
            refused = self.run_limber("plan", *ARM, *BUDGET, "--forest", "f", *flags,
                                      "--environment", rest, code=2)
            self.assertIn("f: ", refused.stderr)
            self.assertEqual((self.folder / "f").read_text(), "mine")

    def test_finds_a_plan_and_draws_it(self):
        found = self.plan(PILLAR, "--out", "p.json", "--csv", "p.csv", "--svg", "p.svg")
        self.assertEqual(found["status"], "solved")
        self.assertLessEqual(KEYS, set(found))
        self.assertLessEqual(found["distance_to_goal_cm"], 3.0)
        self.assertGreaterEqual(found["clearance_cm"], 0.0)
        self.assertGreater(found["cost_kpa"], 0.0)
        plan = json.loads((self.folder / "p.json").read_text(encoding="utf-8"))
        self.assertEqual(len(plan["frames"]), found["frames"])
        # (2), by an independent sum over the file's frames.
        points = [frame["setpoint_kpa"] for frame in plan["frames"]]
        cost = sum(
            abs(b - a) for p, q in zip(points, points[1:]) for a, b in zip(p, q, strict=True)
        )
        self.assertAlmostEqual(cost, found["cost_kpa"], delta=1e-3 * cost)
        self.assertIn("<svg", (self.folder / "p.svg").read_text(encoding="utf-8"))
        rows = (self.folder / "p.csv").read_text(encoding="utf-8").splitlines()
        self.assertEqual(rows[0], "time_s,setpoint_0_kpa,setpoint_1_kpa,pressure_0_kpa,pressure_1_kpa")

    def test_the_same_seed_gives_the_same_plan(self):
        for name, jobs in (("one.json", 1), ("two.json", 2)):
            self.plan(PILLAR, "--seed", 5, "--jobs", jobs, "--out", name)
        self.assertEqual(
            (self.folder / "one.json").read_bytes(), (self.folder / "two.json").read_bytes()
        )

    def test_a_walled_in_goal_ends_with_1_and_no_file(self):
        wall = [
            {"rectangle": {"x_m": x, "y_m": y, "width_m": w, "height_m": h}}
            for x, y, w, h in (
                (0.38, 0.11, 0.2, 0.01), (0.38, 0.29, 0.2, 0.01),
                (0.29, 0.2, 0.01, 0.2), (0.47, 0.2, 0.01, 0.2),
            )
        ]
        found = self.plan(changed(obstacles=wall), "--out", "p.json", code=1)
        self.assertEqual(found["status"], "limit")
        self.assertFalse((self.folder / "p.json").exists())

    def test_a_margin_below_zero_is_refused_at_the_flag(self):
        path = self.plan_file(PILLAR)
        self.write("m.safetensors", "")
        for verb in (
            ("plan", *ARM, *BUDGET, "--environment", path, "--out", "p.json"),
            ("experiment", "--model", "m.safetensors", "--out", "table"),
            ("environment", "check", path),
        ):
            for margin in ("-1", "-1e-6", "nan"):
                with self.subTest(verb=verb[0], margin=margin):
                    error = self.run_limber(*verb, "--margin-m", margin, code=2).stderr
                    self.assertRegex(error, r"margin.m")
        self.assertEqual({p.name for p in self.folder.iterdir()}, {"e.yaml", "m.safetensors"})

    def test_a_start_that_is_no_arm_is_bad_input(self):
        rows = [[0.0, 0.0, 0.0]] * 11
        start = {"pressures_kpa": [0.0, 0.0], "backbone": rows}
        path = self.plan_file(changed(start=start))
        for verb in (
            ("plan", *ARM, *BUDGET, "--environment", path, "--out", "p.json"),
            ("environment", "check", path, "--arm", "two_segment"),
            ("inspect", path, "--arm", "two_segment"),
            ("experiment", "--arm", "two_segment", "--model", "none.safetensors",
             "--environments", ".", "--out", "table"),
        ):
            with self.subTest(verb=verb[0]):
                error = self.run_limber(*verb, code=2).stderr
                self.assertIn("start.backbone[1]: plate 1 is 0 m from plate 0; expected 0.0235",
                              error)

    def test_set_points_are_exported_only_within_somebodys_limits(self):
        self.plan(PILLAR, "--out", "p.json")
        self.run_limber("export", "p.json", "--csv", "sealed")
        plan = json.loads((self.folder / "p.json").read_text(encoding="utf-8"))
        del plan["certificate"]
        self.write("open.json", json.dumps(plan))
        error = self.run_limber("export", "open.json", "--csv", "open", code=2).stderr
        self.assertIn("certificate: missing", error)
        self.assertIn("--arm", error)
        self.run_limber("export", "open.json", "--csv", "open", "--arm", "two_segment")
        self.assertEqual(
            (self.folder / "open" / "setpoints.csv").read_bytes(),
            (self.folder / "sealed" / "setpoints.csv").read_bytes(),
        )
        frame = plan["frames"][-1]["setpoint_kpa"]
        for point in (plan["waypoints_kpa"][-1], *(f["setpoint_kpa"] for f in plan["frames"])):
            if point == frame:
                point[0] = 150.0  # of 100 kPa
        plan["cost_kpa"] = sum(
            abs(b - a)
            for one, two in zip(plan["frames"], plan["frames"][1:])
            for a, b in zip(one["setpoint_kpa"], two["setpoint_kpa"])
        )
        self.write("strong.json", json.dumps(plan))
        self.run_limber("export", "strong.json", "--csv", "strong", code=2)
        error = self.run_limber(
            "export", "strong.json", "--csv", "strong", "--arm", "two_segment", code=2
        ).stderr
        self.assertIn("setpoint_kpa[0]: 150 kPa found; expected ± 100 kPa", error)
        self.assertFalse((self.folder / "strong").exists())

    def test_what_cannot_be_planned_is_said_before_planning(self):
        cases = {
            "invalid_start": changed(
                obstacles=[{"circle": {"x_m": 0.2, "y_m": 0.0, "radius_m": 0.05}}]
            ),
            "goal_unreachable": changed(
                goal={"x_m": 3.0, "y_m": 0.2, "position_tolerance_m": 0.03}
            ),
            "goal_in_collision": changed(
                obstacles=[{"circle": {"x_m": 0.38, "y_m": 0.2, "radius_m": 0.1}}]
            ),
        }
        for status, environment in cases.items():
            with self.subTest(status=status):
                found = self.plan(environment, "--out", "p.json", code=2)
                self.assertEqual(found["status"], status)
                self.assertRegex(found["reason"], r"\d")  # by how much
                self.assertFalse((self.folder / "p.json").exists())

    def test_refusals_name_obstacle_plate_and_amount(self):
        base = {"circle": {"x_m": 0.0, "y_m": 0.05, "radius_m": 0.04}}
        found = self.plan(changed(obstacles=[*PILLAR["obstacles"], base]), code=2)
        self.assertEqual(found["status"], "invalid_start")
        self.assertRegex(
            found["reason"], r"\d\.\d\d cm deep in obstacle 1 \(circle\), between plates 0 and 1"
        )

    def test_a_goal_reached_only_in_collision_is_told_apart(self):
        # A bar across the arm's way that leaves the goal itself free.
        bar = {"rectangle": {"x_m": 0.3, "y_m": 0.1, "width_m": 0.4, "height_m": 0.02}}
        found = self.plan(changed(obstacles=[bar]), code=1)
        self.assertEqual(found["status"], "limit")
        self.assertIn("reaches the goal only in collision", found["reason"])
        self.assertIn("obstacle 0 (rectangle), between plates", found["reason"])
        self.assertIsNotNone(found["best_partial"])

    def test_nothing_and_hundreds_of_obstacles_are_no_problem(self):
        found = self.plan(changed(obstacles=[]))
        self.assertEqual(found["status"], "solved")
        self.assertIsNone(found["clearance_cm"])
        ring = [
            {"circle": {"x_m": 0.7 * math.cos(0.01 * k), "y_m": 0.7 * math.sin(0.01 * k),
                        "radius_m": 0.005}}
            for k in range(500)
        ]
        found = self.plan(changed(obstacles=ring))
        self.assertEqual(found["status"], "solved")
        self.assertGreater(found["clearance_cm"], 1.0)

    def test_a_tolerance_that_no_float_can_meet_ends_at_the_limit(self):
        goal = {**PILLAR["goal"], "position_tolerance_m": 1e-12}
        found = self.plan(changed(goal=goal), code=1)
        self.assertEqual(found["status"], "limit")

    def test_a_budget_of_nothing_is_refused(self):
        path = self.plan_file(PILLAR)
        for flag in ("--time-limit-s", "--max-iterations", "--max-queries"):
            with self.subTest(flag=flag):
                error = self.run_limber(
                    "plan", *ARM, flag, 0, "--environment", path, code=2
                ).stderr
                self.assertIn(flag, error)

    def test_a_model_of_another_arm_is_refused(self):
        other = ("--arm", "three_segment")
        self.run_limber("collect", *other, "--schedule", "random", "--count", 4, "--out", "t.h5")
        self.run_limber("train", *other, "--data", "t.h5", "--epochs", 3, "--out", "m.safetensors")
        error = self.run_limber(
            "plan", "--arm", "two_segment", "--model", "m.safetensors", *BUDGET,
            "--environment", self.plan_file(PILLAR), code=2,
        ).stderr
        self.assertIn("three_segment", error)
        self.assertIn("two_segment", error)

    def refused(self, environment, *expected):
        text = environment if isinstance(environment, str) else json.dumps(environment)
        path = self.write("e.yaml", text)
        result = self.run_limber(
            "plan", *ARM, *BUDGET, "--environment", path, "--out", "p.json", code=2
        )
        for part in ("e.yaml", *expected):
            self.assertIn(part, result.stderr)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["e.yaml"])

    def test_broken_environments_are_refused_by_file_and_field(self):
        goal = PILLAR["goal"]
        self.refused("")
        self.refused("goal: [")
        self.refused(changed(schema="limber/arm/1"), "limber/environment/1")
        for key in PILLAR:
            with self.subTest(missing=key):
                self.refused({k: v for k, v in PILLAR.items() if k != key}, key)
        for key in goal:
            with self.subTest(missing=key):
                self.refused(changed(goal={k: v for k, v in goal.items() if k != key}), key)
        self.refused(changed(color="red"), "color")
        self.refused(changed(start="here"), "start")
        for value in (float("nan"), -0.02, 0, "wide", None, [1]):
            with self.subTest(tolerance=value):
                text = json.dumps(changed(goal={**goal, "position_tolerance_m": value}))
                self.refused(text.replace("NaN", ".nan"), "position_tolerance_m")
        for obstacle, field in (
            ({"circle": {"x_m": 0.3, "y_m": 0.3}}, "radius_m"),
            ({"circle": {"x_m": 0.3, "y_m": 0.3, "radius_m": -1}}, "radius_m"),
            ({"square": {}}, "square"),
            ({"polygon": [[0, 0.3], [0.1, 0.3]]}, "polygon"),
            ({"polygon": [[0, 0.3], [0.1, 0.4], [0.1, 0.3], [0, 0.4]]}, "simple polygon"),
        ):
            with self.subTest(obstacle=obstacle):
                self.refused(changed(obstacles=[obstacle]), field)


if __name__ == "__main__":
    unittest.main()
