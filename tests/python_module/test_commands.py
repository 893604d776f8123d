"""Arms with other commands than one for each segment, in Python."""

import pathlib
import unittest

import numpy as np

import limber

ROOT = pathlib.Path(__file__).resolve().parents[2]
ARM = ROOT / "examples" / "six_motors" / "arm.yaml"


class Commands(unittest.TestCase):
    def setUp(self):
        self.arm = limber.load_arm(ARM)

    def test_the_arm_says_which_it_has(self):
        self.assertEqual([one.name for one in self.arm.commands], [f"motor_{k}" for k in range(6)])
        self.assertEqual(self.arm.commands[3].shares, [0.0, -0.5, 0.0])
        self.assertIn("motor_3", repr(self.arm.commands[3]))
        three = limber.load_arm(limber.data_folder() / "arms" / "three_segment.yaml")
        self.assertEqual(three.commands, [])
        np.testing.assert_array_equal(limber.command_shares(three), np.eye(3))

    def test_there_and_back(self):
        shares = limber.command_shares(self.arm)
        self.assertEqual(shares.shape, (3, 6))
        wanted = np.array([0.5, -1.0, 2.0])
        motors = limber.commands_for(self.arm, wanted)
        np.testing.assert_allclose(motors, np.linalg.pinv(shares) @ wanted, atol=1e-12)
        np.testing.assert_allclose(limber.segment_commands(self.arm, motors + 0.4), wanted, atol=1e-12)

    def test_sizes_and_numbers_are_checked(self):
        with self.assertRaisesRegex(limber.InputError, "3 commands; arm 'six_motors' has 6"):
            limber.segment_commands(self.arm, [0, 0, 0])
        with self.assertRaisesRegex(limber.InputError, "segment_commands"):
            limber.commands_for(self.arm, [0, np.nan, 0])
        with self.assertRaisesRegex(limber.InputError, "shape"):
            limber.commands_for(self.arm, [[0, 0, 0]])


if __name__ == "__main__":
    unittest.main()
