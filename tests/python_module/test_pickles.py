"""Settings, arms, models, environments, plans and episodes come back from pickle and copy as they
were; what has no pickle says so, whatever the protocol."""

import copy
import pickle
import unittest

import numpy as np

import limber
from chain import InFolder, chain


def ways(value):
    """Every way there and back."""
    for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
        yield pickle.loads(pickle.dumps(value, protocol))
    yield copy.copy(value)
    yield copy.deepcopy(value)


class Pickles(InFolder):
    def test_arms_with_everything_in_their_files(self):
        arm = chain().arm
        for other in ways(arm):
            self.assertEqual(limber.arm_to_yaml(other), limber.arm_to_yaml(arm))
            self.assertEqual(other.hash(), arm.hash())

    def test_settings_by_their_fields(self):
        settings = limber.best_preset()
        settings.stages = [limber.TrainingStage(epochs=7), *settings.stages[1:]]
        settings.hidden_units = [5, 6]
        for other in ways(settings):
            self.assertEqual(repr(other), repr(settings))
            other.stages = []
        self.assertEqual(settings.stages[0].epochs, 7)
        for other in ways(limber.PlannerLimits(time_s=2.0)):
            self.assertEqual((other.time_s, other.queries), (2.0, None))
        schedule = limber.ScheduleSettings(kind=limber.ScheduleKind.random, count=3)
        for other in ways(limber.CollectionSettings(schedule=schedule)):
            self.assertEqual(other.schedule.kind, limber.ScheduleKind.random)
        for other in ways(limber.Restart.every_motion):
            self.assertEqual(other, limber.Restart.every_motion)

    def test_models_answer_as_before(self):
        model = limber.read_model(chain().model)
        for other in ways(model):
            self.assertEqual(other.training, model.training)
            for one, same in zip(model.layers, other.layers):
                np.testing.assert_array_equal(one.weight, same.weight)
            limber.ForwardModel(chain().arm, other)

    def test_plans_environments_and_episodes(self):
        environment = chain().environment
        problem = limber.PlanningProblem(
            chain().arm, limber.MotionModel(limber.ForwardModel(chain().arm)), environment)
        plan = limber.make_planner().plan(problem, limber.PlannerLimits(iterations=300), 5).plan
        for number, other in enumerate(ways(plan)):
            limber.write_plan(self.folder / "a", plan)
            limber.write_plan(self.folder / "b", other)
            self.assertEqual((self.folder / "a").read_bytes(), (self.folder / "b").read_bytes(),
                             number)
        for other in ways(environment):
            self.assertEqual(limber.environment_hash(other), limber.environment_hash(environment))
        class Derived(limber.Environment):
            pass
        for other in ways(Derived("derived", [], environment.goal)):
            self.assertEqual(other.name, "derived")
        for other in ways(limber.Polygon([[0.1, 0.2], [0.3, 0.2], [0.2, 0.4]])):
            np.testing.assert_array_equal(other.points_m, [[0.1, 0.2], [0.3, 0.2], [0.2, 0.4]])
        start = limber.start_state(environment, chain().arm)
        for other in ways(start):
            np.testing.assert_array_equal(other.backbone, start.backbone)
        episode = limber.read_recording(chain().recording).episodes[0]
        for other in ways(episode):
            np.testing.assert_array_equal(other.backbone, episode.backbone)
            np.testing.assert_array_equal(other.tracked, episode.tracked)
        named = limber.Episode(episode.time_s, episode.pressure_kpa, episode.setpoint_kpa, episode.backbone,
                               episode.motion_index, log="a.csv")
        for other in ways(named):
            self.assertEqual(other.log, "a.csv")

    def test_everything_else_is_a_type_error(self):
        arm = chain().arm
        recording = limber.read_recording(chain().recording)
        for value in (limber.ForwardModel(arm), limber.NoLoadModel(arm), limber.VirtualArm(arm),
                      limber.RandomStream(1), limber.make_planner(), recording,
                      limber.ParallelForward(1)):
            for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
                with self.assertRaises(TypeError):
                    pickle.dumps(value, protocol)
            with self.assertRaises(TypeError):
                copy.copy(value)
            with self.assertRaises(TypeError):
                value.__reduce__()

    def test_nothing_is_half_made(self):
        for made in (limber.NoLoadModel.__base__,
                     lambda: limber.ArmDescription.__new__(limber.ArmDescription),
                     lambda: limber.Plan.__base__.__new__(limber.Plan),
                     lambda: object.__new__(limber.Episode)):
            with self.assertRaises(TypeError):
                made()


if __name__ == "__main__":
    unittest.main()
