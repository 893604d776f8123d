"""Checks that a bare machine has what Python files import: each module comes with Python, from the project,
or from a package that packages.txt lists. A machine that happens to have a package would hide that it is
not listed. What a test looks for first, and does without, is listed too. Usage: check_packages.py [PROJECT]
"""

import ast
import pathlib
import re
import sys

# Modules, and programs that tests run where they find them, by the package that brings them.
PACKAGES = {
    "cmake": "cmake",
    "ctest": "cmake",
    "cv2": "python3-opencv",
    "git": "git",
    "groff": "groff-base",
    "h5py": "python3-h5py",
    "mpirun": "openmpi-bin",
    "mypy": "mypy",
    "numpy": "python3-numpy",
    "sbatch": "slurm-wlm",
    "setuptools": "python3-setuptools",
    "torch": "python3-torch",
    "yaml": "python3-yaml",
    "zsh": "zsh",
}
# Of Debian's essential packages, and of those that come with a compiler.
EVERY_MACHINE_HAS = {"bash", "dpkg-query", "mount", "setpriv", "sh", "umount", "unshare"} | {"c++", "nm"}
INSTALLED = ("build", "test")
OPTIONAL = (*INSTALLED, "benchmark", "cluster")
# Examples and benchmarks may ask their readers for more; what made stored values is run by nobody.
FOLDERS = {"tests": INSTALLED, "tools": INSTALLED, "python": INSTALLED,
           "examples": OPTIONAL, "benchmarks": OPTIONAL}
BY_HAND = {"make_pytorch_gradients.py"}
OTHERS = {"examples": {"rclpy", "std_msgs"},  # of ROS 2, which is not Debian's
          "tests": {"mpirun", "sbatch", "sinfo"},  # of a cluster; tests without them are skipped
          # Whoever measures a state of the project, or draws a picture again.
          "tools": {"git", "llvm-cov-14", "llvm-profdata-14", "matplotlib"}}
OWN = {"limber"}  # and every file's own name


def listed_packages(project):
    """Section to packages, as tools/packages.sh reads them."""
    sections, section = {}, None
    for line in (project / "packages.txt").read_text(encoding="utf-8").splitlines():
        words = line.split("#")[0].split()
        if words and words[0].startswith("["):
            section = sections.setdefault(words[0].strip("[]"), set())
        elif words:
            section.add(words[0])
    return sections


def started_programs(tree):
    """Programs that subprocess starts by name where nobody waits for FileNotFoundError: name and line."""
    guarded = {id(node) for attempt in ast.walk(tree) if isinstance(attempt, ast.Try)
               and any("FileNotFoundError" in ast.dump(handler) for handler in attempt.handlers)
               for statement in attempt.body for node in ast.walk(statement)}
    for call in ast.walk(tree):
        if (isinstance(call, ast.Call) and ast.unparse(call.func).startswith("subprocess.") and id(call) not in guarded
                and call.args and isinstance(call.args[0], ast.List) and call.args[0].elts
                and isinstance(call.args[0].elts[0], ast.Constant) and "/" not in call.args[0].elts[0].value):
            yield call.args[0].elts[0].value, call.lineno


def needs(path, sections):
    """Top-level modules that a file imports, and modules and programs that it looks for: name, line and
    the sections that may list it."""
    text = path.read_text(encoding="utf-8")
    tree = ast.parse(text)
    for name, line in started_programs(tree):
        yield name, line, sections
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            for name in node.names:
                yield name.name.split(".")[0], node.lineno, sections
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            yield node.module.split(".")[0], node.lineno, sections
    for number, line in enumerate(text.splitlines(), 1):
        for name in re.findall(r"\b(?:which|find_spec)\(\"([\w-]+)\"\)", line):
            yield name, number, OPTIONAL


def problems_of(project):
    packages = listed_packages(project)
    files = {folder: sorted((project / folder).rglob("*.py")) for folder in FOLDERS}
    own = OWN | {path.stem for paths in files.values() for path in paths}
    known = own | EVERY_MACHINE_HAS | set(sys.stdlib_module_names)
    for folder, path in ((folder, path) for folder in FOLDERS for path in files[folder]):
        for name, line, sections in needs(path, FOLDERS[folder]) if path.name not in BY_HAND else ():
            where = f"{path.relative_to(project)}:{line}: '{name}'"
            if name in known or name in OTHERS.get(folder, ()):
                continue
            if name not in PACKAGES:
                yield f"{where} is in no package that {pathlib.Path(__file__).name} knows; add it there"
            elif not any(PACKAGES[name] in packages.get(section, ()) for section in sections):
                wanted = " or ".join(f"[{section}]" for section in sections)
                yield f"{where} is in {PACKAGES[name]}, which packages.txt does not list in {wanted}"


def main():
    project = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[2]
    problems = list(problems_of(project))
    print("\n".join(problems) or "packages.txt lists what Python files need")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
