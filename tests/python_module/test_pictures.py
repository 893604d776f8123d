"""What a notebook shows of limber's objects."""

import unittest
import xml.etree.ElementTree

import limber
from chain import chain

SVG = "{http://www.w3.org/2000/svg}svg"


class Pictures(unittest.TestCase):
    def setUp(self):
        self.chain = chain()
        forward = limber.ForwardModel(self.chain.arm, limber.read_model(self.chain.model))
        problem = limber.PlanningProblem(self.chain.arm, limber.MotionModel(forward),
                                         self.chain.environment)
        self.result = limber.make_planner().plan(problem, limber.PlannerLimits(iterations=200), 5)

    def assert_svg(self, text, *words):
        root = xml.etree.ElementTree.fromstring(text)
        self.assertEqual(root.tag, SVG)
        written = " ".join(root.itertext())
        for word in words:
            self.assertIn(word, written)

    def test_arms_environments_and_plans_draw_themselves(self):
        self.assert_svg(self.chain.arm._repr_svg_(), self.chain.arm.name)
        self.assert_svg(self.chain.environment._repr_svg_(), "a wall")
        self.assert_svg(self.result._repr_svg_(), "a wall")
        self.assert_svg(self.result.plan._repr_svg_(), "a wall")

    def test_learning_curves_draw_themselves(self):
        data = limber.hold_back_validation(
            limber.read_recording(self.chain.recording).episodes, 0.1, 1)
        settings = limber.best_preset()
        limber.set_epoch_count(settings, 3)
        self.assert_svg(limber.train(self.chain.arm, data, settings)._repr_svg_())

    def test_errors_draw_themselves(self):
        arm, environment, plan = self.chain.arm, self.chain.environment, self.result.plan
        network = limber.ForwardModel(arm, limber.read_model(self.chain.model))
        episodes = limber.read_recording(self.chain.recording).episodes
        words = ("open loop", "no load", "mean position error [cm]")
        self.assert_svg(limber.evaluate(limber.ForwardModel(arm), network, episodes)._repr_svg_(),
                        *words)
        self.assert_svg(limber.evaluate(limber.ForwardModel(arm), None, episodes)._repr_svg_(),
                        *words[1:])
        run = limber.execute(arm, environment, plan, limber.VirtualArm(arm))
        self.assertEqual(run._repr_svg_(),
                         limber.execution_picture(arm, environment, plan, run))

    def test_whole_pictures(self):
        arm, environment, plan = self.chain.arm, self.chain.environment, self.result.plan
        self.assert_svg(limber.plan_picture(arm, environment, self.result))
        self.assert_svg(limber.environment_picture(arm, environment))
        self.assert_svg(limber.pressure_picture(arm, plan))
        self.assertIn('<script type="application/json" id="data">', limber.plan_animation(arm, environment, plan))
        run = limber.execute(arm, environment, plan, limber.VirtualArm(arm))
        self.assert_svg(limber.execution_picture(arm, environment, plan, run))

    def test_reprs_name_their_fields(self):
        self.assertEqual(repr(limber.PlannerLimits(time_s=1.0)),
                         "PlannerLimits(time_s=1.0, iterations=None, queries=None, memory_mb=None, "
                         "cost_threshold_kpa=None)")
        self.assertEqual(repr(limber.Circle(x_m=0.1, y_m=0.2, radius_m=0.3)),
                         "Circle(x_m=0.1, y_m=0.2, radius_m=0.3)")
        self.assertIn("name='", repr(self.chain.arm))
        for name, kind in vars(limber).items():
            if isinstance(kind, type):
                self.assertTrue(kind.__doc__, name)
                self.assertIsNot(kind.__repr__, object.__repr__, name)

    def test_reprs_of_what_is_no_record(self):
        arm, environment = self.chain.arm, self.chain.environment
        model = limber.read_model(self.chain.model)
        episodes = limber.read_recording(self.chain.recording).episodes
        learnt = limber.MotionModel(limber.ForwardModel(arm, model))
        stream = limber.RandomStream(1)
        stream.next_u32()
        for thing, text in [
                (stream, "RandomStream(position=1)"),
                (limber.fit_simple_model(arm, episodes), "SimpleFit(segments=2, lag_s="),
                (limber.gap_bounds_of(episodes), "GapBounds(gaps="),
                (model.learnt, "LearntRegion(pressure_kpa=[("),
                (limber.RecordedRegion(model.learnt, 20.0), "RecordedRegion(segments=2, points="),
                (limber.CollisionChecker(arm, environment), "CollisionChecker(obstacles=1, gaps="),
                (limber.ParallelForward(2), "ParallelForward(jobs=2)"),
                (limber.Certifier(arm, None, limber.ValveParameters(), environment),
                 "Certifier(environment_hash='"),
                (limber.virtual_arm_factory(arm), "DriverFactory(a VirtualArm for each episode)"),
                (limber.ClosedLoop(arm, learnt, environment),
                 "ClosedLoop(arm='two_segment', environment='a wall')")]:
            self.assertTrue(repr(thing).startswith(text), repr(thing))

    def test_fields_that_are_not_there_are_refused(self):
        with self.assertRaisesRegex(TypeError, "no field 'tim_s'; it has time_s, iterations"):
            limber.PlannerLimits(tim_s=1.0)
        with self.assertRaises(TypeError):
            limber.PlannerLimits(time_s="soon")


if __name__ == "__main__":
    unittest.main()
