"""What help(limber) says, and what wrong arguments are told."""

import re
import textwrap
import unittest

import numpy as np

import limber
from chain import ROOT, InFolder

UNITS = {"_m": "[m]", "_cm": "[cm]", "_rad": "[rad]", "_kpa": "[kPa]", "_s": "[s]", "_hz": "[Hz]",
         "_kpa_per_s": "[kPa/s]", "_per_m": "[1/m]", "_percent": "[%]"}
TUTORIAL = ROOT / "docs" / "tutorial"
SHORTEST = 9  # letters: "Mean [cm]." says enough beside its class


def unit_of(name):
    """By the longest ending; None for a number without a unit."""
    fitting = [ending for ending in UNITS if name.endswith(ending)]
    return UNITS[max(fitting, key=len)] if fitting else None


def members():
    """(class, name, docstring without the signatures) of everything public."""
    for owner in (getattr(limber, name) for name in limber.__all__):
        if not isinstance(owner, type) or issubclass(owner, Exception):
            continue
        for name, member in vars(owner).items():
            if name.startswith("_") or hasattr(owner, "__members__"):
                continue
            text = member.__doc__ or ""
            yield owner.__name__, name, isinstance(member, property), re.sub(
                r"(?m)^(\d+\. )?\w+\(.*\) -> .*$", "", text).strip()


class Help(unittest.TestCase):
    def test_every_member_says_what_it_is(self):
        for owner, name, _, text in members():
            self.assertGreater(len(text), SHORTEST - 1, f"{owner}.{name}: {text!r}")

    def test_all_names_everything_public(self):
        public = {name for name in vars(limber._limber) if not name.startswith("_")}
        self.assertEqual(sorted(limber.__all__), sorted(public | {"ArmDriver", "Controller", "data_folder"}))

    def test_every_number_with_a_unit_names_it(self):
        for owner, name, is_property, text in members():
            if is_property and unit_of(name):
                self.assertRegex(text, re.escape(unit_of(name)), f"{owner}.{name}")

    def test_every_value_of_a_choice_says_what_it_means(self):
        for owner in (getattr(limber, name) for name in limber.__all__):
            for value in getattr(owner, "__members__", {}):
                self.assertRegex(owner.__doc__, rf"(?m)^  {value} : \S", owner.__name__)

    def test_constructors_say_their_defaults(self):
        self.assertIn("PlannerLimits(time_s=None, iterations=None",
                      limber.PlannerLimits.__init__.__doc__)

    def test_the_example_of_the_module_plans(self):
        example = re.search(r"(?m)(^    .*\n)+", limber.__doc__)[0]
        names = {"limber": limber, "print": lambda result: names.update(result=result)}
        exec(textwrap.dedent(example), names)
        self.assertEqual(names["result"].status, limber.PlanStatus.solved)
        for word in ("frame B", "Metres, radians, kPa", "from 0", "right side"):
            self.assertIn(word, limber.__doc__)


class Messages(InFolder):
    def setUp(self):
        super().setUp()
        self.arm = limber.load_arm(TUTORIAL / "arm.yaml")
        self.log = TUTORIAL / "logs" / "trial_0.csv"
        self.mapping = TUTORIAL / "mapping.yaml"

    def test_one_path_is_a_list_of_one(self):
        one = limber.import_csv(str(self.log), self.arm, self.mapping)
        several = limber.import_csv(iter([self.log]), self.arm, self.mapping)
        self.assertEqual(one.report, several.report)

    def test_what_is_no_path_is_named(self):
        for wrong, told in ((3, r"^logs: expected a path or a list of paths, found int 3$"),
                            ([self.log, 3], r"^logs\[1\]: expected a path .* found int 3$"),
                            (None, r"^logs: .* found NoneType None$")):
            with self.assertRaisesRegex(TypeError, told):
                limber.import_csv(wrong, self.arm, self.mapping)
        with self.assertRaisesRegex(TypeError, r"^command_logs: .* found float 0\.5$"):
            limber.import_csv([self.log], self.arm, self.mapping, command_logs=0.5)

    def test_what_is_no_list_of_episodes_is_named(self):
        recording = limber.import_csv(self.log, self.arm, self.mapping).recording
        for wrong, told in ((recording, "found Recording; its episodes are recording.episodes"),
                            (recording.episodes[0], "found Episode; put it in a list"),
                            ("one.h5", "found str; read_recording"),
                            (["one.h5"], "found str in the list; read_recording"),
                            (np.zeros(3), "expected a list of Episode, found float")):
            with self.assertRaisesRegex(TypeError, told):
                limber.fit_simple_model(self.arm, wrong)

    def test_one_log_of_which_the_last_is_held_back_leaves_none(self):
        episodes = limber.import_csv(self.log, self.arm, self.mapping).recording.episodes
        with self.assertRaisesRegex(limber.InputError, "no episodes given; expected at least one"):
            limber.fit_simple_model(self.arm, episodes[:-1])
        with self.assertRaisesRegex(limber.InputError, "hold no frame in 0 episodes"):
            limber.train(self.arm, limber.TrainingData([]), limber.best_preset())

    def test_millimetres_are_asked_for(self):
        text = (TUTORIAL / "arm.yaml").read_text(encoding="utf-8")
        (self.folder / "arm.yaml").write_text(text.replace("length_m: 0.20", "length_m: 160"),
                                              encoding="utf-8")
        with self.assertRaisesRegex(limber.InputError,
                                    r"arm.yaml:\d+: segments\[0\].length_m: 160 found; .*"
                                    "at most 10. Is it in millimetres"):
            limber.load_arm(self.folder / "arm.yaml")
        goal = limber.PoseGoal(x_m=120, y_m=400, position_tolerance_m=0.02)
        environment = limber.Environment("far", [], goal)
        model = limber.MotionModel(limber.ForwardModel(self.arm))
        problem = limber.PlanningProblem(self.arm, model, environment)
        result = limber.make_planner().plan(problem, limber.PlannerLimits(iterations=1), 1)
        self.assertEqual(result.status, limber.PlanStatus.goal_unreachable)
        self.assertIn("417.612 m from the base, and the arm is 0.4 m long", result.reason)
        self.assertIn("Is it in millimetres?", result.reason)


if __name__ == "__main__":
    unittest.main()
