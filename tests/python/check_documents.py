"""Checks the project's Markdown: every relative link leads to a file, every document in docs/ is
listed in docs/README.md, and every public header in docs/library.md, which says who it is for. With a program given, every verb of it is named in the README."""

import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")


def documents():
    skipped = {"build", "out", ".git"}
    for path in sorted(ROOT.rglob("*.md")):
        if not skipped & set(path.relative_to(ROOT).parts):
            yield path


def broken_links(path):
    # Code is no text: `f[i](x)` is no link.
    text = re.sub(r"```.*?```|`[^`\n]*`", "", path.read_text(encoding="utf-8"), flags=re.S)
    for target in LINK.findall(text):
        if re.match(r"[a-z]+:", target) or target.startswith("#"):
            continue
        if not (path.parent / target.split("#")[0]).exists():
            yield f"{path.relative_to(ROOT)}: link to {target}, which is not there"


def unlisted_documents():
    index = (ROOT / "docs" / "README.md").read_text(encoding="utf-8")
    for path in sorted((ROOT / "docs").glob("*.md")):
        if path.name != "README.md" and f"({path.name})" not in index:
            yield f"docs/README.md does not list {path.name}"


def unlisted_headers():
    page = (ROOT / "docs" / "library.md").read_text(encoding="utf-8")
    listed = set(re.findall(r"`(limber/[a-z]+/[a-z_0-9]+\.hpp)`", page))
    headers = {str(path).split("/include/")[1]: path
               for path in ROOT.glob("src/*/include/limber/*/*.hpp")}
    for name in sorted(listed ^ set(headers)):
        yield f"docs/library.md {'lists' if name in listed else 'does not list'} {name}"
    for name, path in sorted(headers.items()):
        if not path.read_text(encoding="utf-8").startswith("#pragma once\n// For "):
            yield f"{name} does not say in its second line who it is for"


def unnamed_verbs(program):
    help_text = subprocess.run([program, "--help"], capture_output=True, text=True, check=True)
    verbs = re.findall(r"^  ([a-z-]+) ", help_text.stdout.split("Subcommands:")[1], flags=re.M)
    if not verbs:
        yield "limber --help lists no verbs"
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    for verb in verbs:
        if f"limber {verb}" not in readme:
            yield f"README.md does not name `limber {verb}`"


def main():
    problems = [problem for path in documents() for problem in broken_links(path)]
    problems += unlisted_documents()
    problems += unlisted_headers()
    if len(sys.argv) > 1:
        problems += unnamed_verbs(sys.argv[1])
    print("\n".join(problems) or "documents are whole")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
