"""limber campaign: the same bytes from one process, shards and ranks; nothing is done twice; failures stop nothing."""

import csv
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import time
import unittest

import slurm_node
from program import PROGRAM, ROOT, InFolder, cpu_levels, limber

COLLECT = """schema: limber/campaign/1
verb: collect
seed: 7
flags: {arm: two_segment, schedule: random, count: 6, hold-s: 0.5, vary-physics: 1.5}
grid:
  episodes: [1, 2, 3]
repeat: 2
charts:
  - {x: episodes, y: frames}
"""
UNITS = 6
MPIRUN = ("mpirun", "--oversubscribe", "--allow-run-as-root", "--bind-to", "none")
HAS_MPI = shutil.which("mpirun") is not None and \
    (pathlib.Path(PROGRAM).parent / "../lib/limber/limber_mpi.so").exists()


def mpi_environment():
    return {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def job_scripts():
    """The scripts of docs/cluster.md by their first comment's file name."""
    text = (ROOT / "docs" / "cluster.md").read_text(encoding="utf-8")
    scripts = re.findall(r"^```sh\n(#!/bin/bash\n# (\S+\.sh).*?)^```$", text, flags=re.M | re.S)
    return {name: script for script, name in scripts}


class Campaigns(InFolder):
    def setUp(self):
        super().setUp()
        self.write("c.yaml", COLLECT)

    def campaign(self, *flags, code=0):
        return self.run_limber("campaign", "c.yaml", *flags, code=code)

    def joined(self, out):
        self.campaign("--out", out, "--collect")
        return (self.folder / out / "recording.h5").read_bytes()

    def made_of(self, out):
        """Every unit's last file, and when it was written."""
        return {path.parent: path.stat().st_mtime_ns
                for path in (self.folder / out / "units").glob("*/*/done_*.json")}

    def run_ranks(self, ranks, out, code=0):
        result = subprocess.run(
            [*MPIRUN, "-n", str(ranks), PROGRAM, "campaign", "c.yaml", "--out", out], cwd=self.folder,
            env=mpi_environment(), capture_output=True, encoding="utf-8", check=False)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result

    def test_one_process_and_shards_make_the_same_bytes(self):
        self.campaign("--out", "one")
        for shard in (2, 0, 1):
            self.campaign("--out", "shards", "--shard", f"{shard}/3", "--jobs", 1)
        self.assertEqual(self.joined("one"), self.joined("shards"))
        for name in ("table.csv", "report.html"):
            self.assertEqual((self.folder / "one" / name).read_bytes(),
                             (self.folder / "shards" / name).read_bytes())

    @unittest.skipUnless(HAS_MPI, "no mpirun, or limber was built without MPI")
    def test_any_number_of_ranks_makes_the_same_bytes(self):
        self.campaign("--out", "one")
        for ranks in (1, 2, 4, 8):
            self.run_ranks(ranks, f"ranks_{ranks}")
            self.assertEqual(self.joined("one"), self.joined(f"ranks_{ranks}"), f"{ranks} ranks")

    @unittest.skipUnless(HAS_MPI, "no mpirun, or limber was built without MPI")
    def test_ranks_end_by_themselves_where_the_folder_is_refused(self):
        self.campaign("--out", "one", "--shard", "0/6")
        self.write("c.yaml", COLLECT.replace("count: 6", "count: 5"))
        refused = self.run_ranks(3, "one", code=2).stderr
        self.assertIn("of another campaign", refused)
        self.assertNotIn("finalize", refused)  # as Open MPI says of a rank that left the others behind

    def test_the_bytes_do_not_depend_on_the_machines_cpu(self):
        """Neither on limber's kernels nor on those of the C library."""
        self.campaign("--out", "one")
        for level in cpu_levels():
            result = limber("campaign", "c.yaml", "--out", level, folder=self.folder,
                            environment={"LIMBER_CPU": level})
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(self.joined("one"), self.joined(level))

    def test_a_level_that_the_machine_lacks_is_refused(self):
        lacking = [level for level in ("avx2", "avx512") if level not in cpu_levels()]
        if not lacking:
            self.skipTest("this machine has every level")
        self.write("c.yaml", COLLECT + f"cpu: {lacking[0]}\n")
        self.assertIn("this machine lacks", self.campaign(code=2).stderr)

    def test_finished_units_are_not_done_again(self):
        self.campaign()
        before = self.made_of("c")
        self.assertEqual(len(before), UNITS)
        first = next(iter(before))
        shutil.rmtree(first)
        self.campaign()
        after = self.made_of("c")
        self.assertNotEqual(before[first], after[first])
        del before[first], after[first]
        self.assertEqual(before, after)

    def test_another_campaign_does_not_take_its_folder(self):
        self.campaign()
        self.write("c.yaml", COLLECT.replace("count: 6", "count: 5"))
        self.assertIn("of another campaign", self.campaign(code=2).stderr)
        self.write("c.yaml", COLLECT.replace("[1, 2, 3]", "[1, 2, 3, 4]"))
        before = self.made_of("c")
        self.campaign("--force")  # more of the same: what is the same stays
        after = self.made_of("c")
        self.assertEqual(before, {unit: after[unit] for unit in before})
        self.assertEqual(len(after), UNITS + 2)

    def test_a_failing_unit_is_named_and_stops_nothing(self):
        self.write("c.yaml", COLLECT.replace("vary-physics: 1.5", "").replace(
            "grid:", "grid:\n  vary-physics: [1.5, 99]"))
        message = self.campaign(code=1).stderr
        self.assertIn("failed", message)
        status = self.run_json("campaign", "c.yaml", "--status", code=1)
        self.assertEqual((status["done"], status["failed"], status["waiting"]), (UNITS, UNITS, 0))
        log = self.folder / "c" / "units" / "000" / f"{status['failures'][0]:03}" / "log.txt"
        self.assertIn("--vary-physics 99", log.read_text(encoding="utf-8"))
        self.campaign("--collect", code=1)  # what is there

    def test_status_and_dry_run_run_nothing(self):
        units = self.run_json("campaign", "c.yaml", "--dry-run")
        self.assertEqual(len(units["units"]), UNITS)
        self.assertEqual([unit["cost"] for unit in units["units"]], [3, 3, 6, 6, 9, 9])
        self.assertFalse((self.folder / "c").exists())
        self.campaign("--shard", "0/2")
        status = self.run_json("campaign", "c.yaml", "--status")
        self.assertEqual((status["done"], status["waiting"]), (UNITS // 2, UNITS // 2))
        self.assertGreater(status["left_s"], 0)

    def test_what_is_on_by_default_can_be_switched_off(self):
        self.write("c.yaml", "schema: limber/campaign/1\nverb: train\nflags: {data: a.h5, epochs: 4}\n"
                   "grid: {velocity: [true, false], setpoints: [true, false]}\n")
        commands = [unit["command"] for unit in self.run_json("campaign", "c.yaml", "--dry-run")["units"]]
        self.assertEqual(["--no-velocity" in command for command in commands], [False, False, True, True])
        self.assertEqual(["--setpoints" in command for command in commands], [True, False, True, False])

    def test_a_forest_is_grown_before_units_run_and_not_needed_after(self):
        self.write("c.yaml", "schema: limber/campaign/1\nverb: experiment\nflags: {model: m.safetensors, max-queries: 100, "
                   "forest: none.forest}\ngrid: {trials: [1]}\n")
        self.assertIn("'none.forest': not found; grow it first", self.campaign("--dry-run", code=2).stderr)
        self.assertEqual(self.run_json("campaign", "c.yaml", "--status")["done"], 0)

    def test_budgets_in_seconds_and_unknown_flags_are_refused(self):
        for flag, wanted in (("time-limit-s: 3", "budgets are"), ("jobs: 3", "limber campaign"),
                             ("dry-run: true", "give --dry-run to limber campaign"),
                             ("build-forest: true", "grow it first"),
                             ("nonsense: 3", "nonsense")):
            self.write("c.yaml", COLLECT.replace("count: 6", f"count: 6, {flag}"))
            message = self.campaign(code=2).stderr
            self.assertIn(wanted, message)
        self.write("c.yaml", COLLECT.replace("collect", "train"))
        self.assertIn("no budget", self.campaign(code=2).stderr)
        for shard in ("2/2", "1", "-1/2", "x/2"):
            self.assertIn("expected I/N", self.run_limber("campaign", self.valid(), f"--shard={shard}", code=2).stderr)

    def valid(self):
        return self.write("valid.yaml", COLLECT)

    def test_a_random_design_draws_each_unit_from_its_index(self):
        design = ("schema: limber/campaign/1\nverb: collect\nflags: {arm: two_segment, schedule: random, count: 3}\n"
                  "random:\n  count: %d\n  arm.friction_coefficient: {from: 0.1, to: 0.4}\n"
                  "  hold-s: {from: 0.5, to: 2, scale: logarithmic}\n  episodes: {from: 1, to: 3, scale: integer}\n")

        def commands(count):
            self.write("c.yaml", design % count)
            return [unit["command"] for unit in self.run_json("campaign", "c.yaml", "--dry-run")["units"]]

        self.assertEqual(commands(5), commands(50)[:5])
        self.assertEqual(len(set(commands(50))), 50)
        self.write("c.yaml", design % 2)
        self.campaign()
        arms = [(path / "arm.yaml").read_text(encoding="utf-8") for path in (self.folder / "c/units/000").iterdir()]
        self.assertNotEqual(*arms)
        self.campaign("--collect")
        with (self.folder / "c" / "table.csv").open(encoding="utf-8") as table:
            rows = list(csv.DictReader(table))
        self.assertTrue(all(0.1 <= float(row["arm.friction_coefficient"]) <= 0.4 for row in rows))

    def test_the_verbs_that_need_a_model(self):
        """What collect joined is learnt from; models are evaluated, and an experiment's table is that of one process."""
        self.campaign("--out", "family")
        stale = self.folder / "family/recording_000.h5"  # of an earlier one that took several files
        stale.write_bytes(b"")
        self.campaign("--out", "family", "--collect")
        self.assertFalse(stale.exists())
        self.write("train.yaml", "schema: limber/campaign/1\nverb: train\n"
                   "flags: {arm: two_segment, data: family/recording.h5, epochs: 4, keep-broken: true}\n"
                   "grid: {hidden: [[8, 8], [12, 12, 12]]}\n")
        self.run_limber("campaign", "train.yaml")
        self.run_limber("campaign", "train.yaml", "--collect")
        self.assertIn("validation_position_error_cm over hidden",
                      (self.folder / "train/report.html").read_text(encoding="utf-8"))
        self.write("evaluate.yaml", "schema: limber/campaign/1\nverb: evaluate\n"
                   "flags: {arm: two_segment, model: train/units/000/000/model.safetensors}\n"
                   "grid: {data: {files: family/units/000/001/*.h5}}\n")
        self.run_limber("campaign", "evaluate.yaml")
        self.run_limber("campaign", "evaluate.yaml", "--collect")
        self.run_limber("train", "--arm", "three_segment", *self.three_segment_data(), "--epochs", 4,
                        "--out", "m.safetensors")
        budget = ("--model", "m.safetensors", "--trials", 2, "--max-queries", 500)
        places = [ROOT / "environments" / name for name in ("01_pillar.yaml", "03_gap_in_a_wall.yaml")]
        self.write("e.yaml", "schema: limber/campaign/1\nverb: experiment\nseed: 3\n"
                   "flags: {model: m.safetensors, trials: 2, max-queries: 500}\n"
                   f"grid:\n  environments:\n    - {places[0]}\n    - {places[1]}\n")
        for shard in ("0/2", "1/2"):
            self.run_limber("campaign", "e.yaml", "--shard", shard)
        self.run_limber("campaign", "e.yaml", "--collect")
        alone = limber("experiment", *budget, "--seed", 3, "--out", "alone",
                       *(word for place in places for word in ("--environments", place)), folder=self.folder,
                       environment={"LIMBER_CPU": "baseline", "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX,-AVX2,-FMA,-FMA4"})
        self.assertEqual(alone.returncode, 0, alone.stderr)
        tables = [without_times(json.loads((self.folder / name / "table.json").read_text(encoding="utf-8")))
                  for name in ("alone", "e/experiment")]
        self.assertEqual(*tables)
        self.write("f.yaml", "schema: limber/campaign/1\nverb: experiment\n"
                   "flags: {model: m.safetensors, trials: 1, max-queries: 200, arm.friction_coefficient: 0.5}\n"
                   f"grid:\n  environments:\n    - {places[0]}\n    - {places[1]}\n")
        self.run_limber("campaign", "f.yaml")
        self.run_limber("campaign", "f.yaml", "--collect")
        self.assertTrue((self.folder / "f/experiment/table.json").exists())
        self.write("ways.yaml", "schema: limber/campaign/1\nverb: experiment\n"
                   f"flags: {{model: m.safetensors, trials: 1, max-queries: 200, environments: {places[0]}}}\n"
                   "grid: {planner: [default, paper]}\n")
        self.run_limber("campaign", "ways.yaml")
        self.assertIn("no experiment/", self.run_limber("campaign", "ways.yaml", "--collect").stderr)
        self.assertTrue((self.folder / "ways/table.csv").exists())
        self.write("cal.yaml", "schema: limber/campaign/1\nverb: calibrate\n"
                   "flags: {model: m.safetensors, check: 2, max-queries: 200}\nrepeat: 2\n")
        self.run_limber("campaign", "cal.yaml", "--dry-run")

    def three_segment_data(self):
        self.run_limber("collect", "--schedule", "random", "--count", 20, "--episodes", 3, "--out", "t.h5")
        return "--data", "t.h5"

    def test_processes_killed_at_random_lose_nothing(self):
        """A small one of campaign_kills.py."""
        self.campaign("--out", "one")
        chance = random.Random(5)
        while len(self.made_of("shards") if (self.folder / "shards").exists() else ()) < UNITS:
            runs = [subprocess.Popen([PROGRAM, "campaign", "c.yaml", "--out", "shards", "--shard", f"{i}/2", "--jobs", "1"],
                                     cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                    for i in range(2)]
            time.sleep(chance.uniform(0.0, 1.5))
            runs[chance.randrange(2)].kill()
            for run in runs:
                run.wait()
        self.assertEqual(self.joined("one"), self.joined("shards"))

    def run_script(self, name, environment):
        self.write(name, job_scripts()[name])
        path = f"{pathlib.Path(PROGRAM).parent}:{environment.get('PATH', '')}"
        return subprocess.run(["bash", name], cwd=self.folder, env={**environment, "PATH": path}, capture_output=True,
                              encoding="utf-8", check=False)

    @unittest.skipUnless(HAS_MPI, "no mpirun, or limber was built without MPI")
    def test_the_documents_mpi_script_runs(self):
        self.write("friction.yaml", COLLECT)
        environment = {**mpi_environment(), "RANKS": "2", "OMPI_MCA_rmaps_base_oversubscribe": "1"}
        result = self.run_script("ranks.sh", environment)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertTrue((self.folder / "friction" / "recording.h5").exists())

    @unittest.skipIf(slurm_node.missing(), f"Slurm can't be started: {slurm_node.missing()}")
    def test_the_documents_slurm_scripts_run(self):
        self.write("friction.yaml", COLLECT)
        with slurm_node.slurm_node() as environment:
            path = f"{pathlib.Path(PROGRAM).parent}:{environment['PATH']}"
            environment = {**mpi_environment(), **environment, "PATH": path}
            for name in ("array.sbatch.sh", "mpi.sbatch.sh"):
                if name == "mpi.sbatch.sh" and not HAS_MPI:
                    continue
                shutil.rmtree(self.folder / "friction", ignore_errors=True)
                self.write(name, job_scripts()[name])
                sent = subprocess.run(["sbatch", "--wait", "--array=0-1" if "array" in name else "--ntasks=2", name],
                                      cwd=self.folder, env=environment, capture_output=True, encoding="utf-8", check=False)
                logs = "\n".join(log.read_text(errors="replace") for log in self.folder.glob("slurm-*.out"))
                self.assertEqual(sent.returncode, 0, sent.stderr + logs)
                status = self.run_json("campaign", "friction.yaml", "--status")
                self.assertEqual(status["done"], UNITS, logs)
                for log in self.folder.glob("slurm-*.out"):
                    log.unlink()


def without_times(rows):
    return [{key: value for key, value in row.items() if not key.endswith("_s")} for row in rows]


if __name__ == "__main__":
    unittest.main()
