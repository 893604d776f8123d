"""For scripts that break limber on purpose: a copy of its sources, so that the tree itself stays as it is."""

import json
import shutil
import subprocess


def copy_sources(root, copy):
    """Takes over what git knows of the tree `root`, or would, and with it takes back every change in the copy."""
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "-z"], cwd=root, check=True,
                            capture_output=True, text=True).stdout.split("\0")
    names = {name for name in listed if name and (root / name).is_file()}
    note = copy / ".copied.json"
    for gone in set(json.loads(note.read_text(encoding="utf-8")) if note.exists() else ()) - names:
        (copy / gone).unlink(missing_ok=True)
        for folder in (copy / gone).parents:
            if folder == copy or not folder.is_dir() or any(folder.iterdir()):
                break
            folder.rmdir()
    copy.mkdir(parents=True, exist_ok=True)
    note.write_text(json.dumps(sorted(names)), encoding="utf-8")
    for name in names:
        mine, copied = root / name, copy / name
        if not (copied.is_file() and copied.read_bytes() == mine.read_bytes()):
            copied.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(mine, copied)
