"""For scripts that measure in parts: limber's answers, and parts that are not measured twice."""

import json
import random
import subprocess
import sys


def seed_of(commit, *names):
    """A seed that depends on the commit and on what it is for."""
    return random.Random(":".join([commit, *map(str, names)])).randrange(1, 2**31)


class KeptParts:
    """Runs limber, in the folder `cwd`; keeps the results of parts as OUT/NAME.json."""

    def __init__(self, limber, out, cwd=None):
        self.program = limber
        self.out = out
        self.cwd = cwd
        self.out.mkdir(parents=True, exist_ok=True)

    def limber(self, *arguments, codes=(0,)):
        """The JSON that limber prints; ends the script where the exit code is another."""
        command = [str(self.program), *map(str, arguments)]
        done = subprocess.run(command, cwd=self.cwd, stdout=subprocess.PIPE, encoding="utf-8", check=False)
        if done.returncode not in codes:
            sys.exit(f"{' '.join(command)}: exit code {done.returncode}")
        return json.loads(done.stdout)

    def kept(self, name, make):
        """A part's JSON: read if it is there, else made and written."""
        path = self.out / f"{name}.json"
        if path.exists():
            return json.loads(path.read_text(encoding="utf-8"))
        found = make()
        path.write_text(json.dumps(found, indent=1), encoding="utf-8")
        return found

    def has(self, name):
        """Whether the part is there."""
        return (self.out / f"{name}.json").exists()

    def trials(self, folder, *arguments):
        """All trials of `limber experiment` with these arguments; those in the folder are kept."""
        self.limber("experiment", "--json", *arguments, "--out", folder, "--resume")
        return [json.loads(path.read_text(encoding="utf-8"))
                for path in sorted((folder / "trials").glob("*.json"))]

    def random_environments(self, seed, count, name="random", arm="three_segment"):
        """The folder of so many, which are sampled if they are not all there."""
        folder = self.out / name
        if len(list(folder.glob("*.yaml"))) < count:
            self.limber("environment", "--json", "--random", "--arm", arm, "--seed", seed,
                        "--count", count, "--out", folder, "--force")
        return folder
