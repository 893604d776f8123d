#!/usr/bin/env python3
"""Counts what has to be read: lines of code, public headers, types, constants and flags.

    tools/code_size.py                      of the working tree
    tools/code_size.py --at COMMIT          of an older commit
    tools/code_size.py --compare COMMIT     next to an older commit, with the difference

Lines of code are those of src, apps and the hand-written part of python, without blanks, comments, docstrings and
includes. Docs are counted in words, without docs/log.
"""

import argparse
import io
import pathlib
import re
import shutil
import subprocess
import tarfile
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
COMMENT = re.compile(r"""(R"(\w*)\(.*?\)\2"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*')|//[^\n]*|/\*.*?\*/""", re.S)
DOCSTRING = re.compile(r'^[ \t]*[rf]?"""(?:.*?)"""[ \t]*$', re.S | re.M)
TYPE = re.compile(r"^[ \t]*(?:class|struct|enum class|enum)\s+(?:\[\[\w+\]\]\s*)?\w+[^;()]*\{", re.M)
CONSTANT = re.compile(r"\bconstexpr\b[^;{=(]*\bk[A-Z]\w*")
FLAG = re.compile(r'add_(?:option|flag)\w*\(\s*"[^"]*--')


def cpp_lines(text):
    code = COMMENT.sub(lambda found: found.group(1) or "", text)
    return [line for line in code.splitlines() if line.strip() and not line.lstrip().startswith("#include")]


def python_lines(text):
    return [line for line in DOCSTRING.sub("", text).splitlines()
            if line.strip() and not line.lstrip().startswith(("#", "import ", "from "))]


def counts(root):
    found = {}
    texts = []
    for top in ("src", "apps", "python"):
        for path in sorted((root / top).rglob("*")):
            if path.suffix not in (".cpp", ".hpp", ".in", ".py") or not path.is_file():
                continue
            text = path.read_text(encoding="utf-8")
            lines = python_lines(text) if path.suffix == ".py" else cpp_lines(text)
            module = "/".join(path.relative_to(root).parts[:2 if top == "src" else 1])
            found[module] = found.get(module, 0) + len(lines)
            if path.suffix != ".py":
                texts.append((top, "\n".join(lines)))
    found["lines of code"] = sum(found.values())
    found["public headers"] = len(list(root.glob("src/*/include/limber/*/*.hpp")))
    found["types"] = sum(len(TYPE.findall(text)) for _, text in texts)
    found["constants"] = sum(len(CONSTANT.findall(text)) for _, text in texts)
    found["flags"] = sum(len(FLAG.findall(text)) for top, text in texts if top == "apps")
    pages = [root / "README.md", *(root / "docs").glob("*.md")]
    found["words of docs"] = sum(len(page.read_text(encoding="utf-8").split()) for page in pages)
    return found


def has_repository():
    return shutil.which("git") is not None and (ROOT / ".git").exists()


def counts_at(commit):
    archive = subprocess.run(["git", "archive", commit], cwd=ROOT, check=True, stdout=subprocess.PIPE).stdout
    with tempfile.TemporaryDirectory() as folder, tarfile.open(fileobj=io.BytesIO(archive)) as tar:
        tar.extractall(folder, filter="data") if hasattr(tarfile, "data_filter") else tar.extractall(folder)
        return counts(pathlib.Path(folder))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--at", metavar="COMMIT", help="counts an older commit alone")
    which.add_argument("--compare", metavar="COMMIT", help="an older commit")
    options = parser.parse_args()
    now = counts_at(options.at) if options.at else counts(ROOT)
    before = counts_at(options.compare) if options.compare else {}
    for name in [*before, *(name for name in now if name not in before)]:
        older = f"{before.get(name, 0):>8} -> " if before else ""
        change = f"  {now.get(name, 0) - before.get(name, 0):+d}" if before else ""
        print(f"{name:<20}{older}{now.get(name, 0):>8}{change}")


if __name__ == "__main__":
    main()
