"""For scripts that break limber on purpose: a copy of its sources, so that the tree itself stays as it is."""

import shutil
import subprocess


def copy_sources(root, copy):
    """Takes over what git knows of the tree `root`, or would, and with it takes back every change in the copy."""
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "-z"], cwd=root, check=True,
                            capture_output=True, text=True).stdout.split("\0")
    for name in filter(None, listed):
        mine, copied = root / name, copy / name
        if mine.is_file() and not (copied.is_file() and copied.read_bytes() == mine.read_bytes()):
            copied.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(mine, copied)
