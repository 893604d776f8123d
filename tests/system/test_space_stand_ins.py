"""tools/space_stand_ins.py, small: logs as laboratories write them go all the way to errors of a network."""

import json
import subprocess
import sys
import unittest

import numpy as np

from program import PROGRAM, ROOT, InFolder

sys.path.insert(0, str(ROOT / "tools"))
import space_residual_model as model  # noqa: E402

TOOL = ROOT / "tools" / "space_stand_ins.py"


class SpaceStandIns(InFolder):
    def test_every_kind_is_logged_imported_learnt_and_measured(self):
        done = subprocess.run(
            [sys.executable, TOOL, "--limber", PROGRAM, "--out", "out", "--hash", "x", "--arms", "0", "--trainings", "1",
             "--share", "0.04", "--", "--epochs", "3", "--hidden", "8"],
            cwd=self.folder, capture_output=True, encoding="utf-8", check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual([line["test"] for line in lines],
                         ["last_fifth", "another_run", "load", "random", "plateau", "ramps", "last_fifth"])
        for line in lines:
            self.assertTrue(np.isfinite(line["network"]).all())
            self.assertLess(line["residual"][0], line["hold"][0])

    def test_its_gaps_chain_to_the_plates_that_they_are_of(self):
        omega = np.random.default_rng(1).uniform(-1.5, 1.5, (20, 3))
        rotation, _ = model.exponential(omega)
        np.testing.assert_allclose(model.logarithm(rotation), omega, atol=1e-9)
        gaps = np.random.default_rng(2).uniform(-0.5, 0.5, (20, 3, 6))
        np.testing.assert_allclose(model.places(gaps)[:, 0], gaps[:, 0, :3])
        turned = np.einsum("nij,nj->ni", model.exponential(gaps[:, 0, 3:])[0], gaps[:, 1, :3])
        np.testing.assert_allclose(model.places(gaps)[:, 1] - model.places(gaps)[:, 0], turned, atol=1e-12)


if __name__ == "__main__":
    unittest.main()
