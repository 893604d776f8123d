"""Checks the project's Markdown: every relative link leads to a file, every document in docs/ is
listed in docs/README.md, every public header in docs/library.md and says who it is for, no sentence is
long and no line wide, and no page, comment of a header or text of the Python module uses words that plain
English has others for. With a program given, every verb of it is named in the README, and its help is
read too."""

import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
MAX_SENTENCE_WORDS = 30
MAX_COLUMNS = 120
# What a page must not say, and what it says instead.
BANNED_WORDS = {
    r"\banew\b": "again",
    r"\bof late\b": "recently",
    r"\bthere where\b": "where",
    r"\berr(s|ed)? by\b": "the error is",
    r"(?<!\bon )(?<!\bof )(?<!\bfrom )(?<!\bfor )\ba core\b": "per core",
    r"\b(queries|[Ff]rames|rows|multiply-adds|motions|times) a second\b": "per second",
    r"\b(ns|ms|multiply-adds|times) (a|an) (query|epoch|motion|frame)\b": "per",
}


def documents():
    skipped = {"build", "out", ".git", "node_modules"}
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


def unfinished_merges(path):
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if re.match(r"(<{7}|>{7}) ", line):
            yield f"{path.relative_to(ROOT)}:{number}: mark of a merge that was not finished"


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


def prose(path):
    """Paragraphs, list items and table rows, one line each, without code, tags and link targets."""
    text = path.read_text(encoding="utf-8")
    text = re.sub(r"```.*?```|<!--.*?-->|<[a-z/][^>]*>", "", text, flags=re.S)
    text = re.sub(r"`[^`]*`", "code", text)
    text = LINK.sub(lambda link: link.group(0)[1:].split("](")[0], text)
    for block in re.split(r"\n\s*\n|\n(?=\s*(?:[-*|]|\d+\.) |#|\|)", text):
        yield " ".join(block.split())


def long_sentences(path):
    for block in prose(path):
        if block.startswith(("|", "#")):
            continue
        for sentence in re.split(r"(?<=[.?!])\W*\s", block):
            words = [word for word in sentence.split() if re.search(r"\w", word)]
            if len(words) > MAX_SENTENCE_WORDS:
                yield f"{path.relative_to(ROOT)}: {len(words)} words in \"{sentence[:70]} …\""


def long_lines(path):
    """Of text: code, tables, pictures and formulas are as wide as they are."""
    text = re.sub(r"```.*?```|^\$\$.*?\$\$", lambda code: "\n" * code.group(0).count("\n"), path.read_text(encoding="utf-8"),
                  flags=re.S | re.M)
    for number, line in enumerate(text.splitlines(), 1):
        if len(line) > MAX_COLUMNS and not line.startswith(("|", "<", "![")):
            yield f"{path.relative_to(ROOT)}:{number}: {len(line)} columns, at most {MAX_COLUMNS}"


def banned_words(name, blocks):
    for block in blocks:
        for pattern, instead in BANNED_WORDS.items():
            for found in re.finditer(pattern, block):
                around = block[max(0, found.start() - 30) : found.end() + 30]
                yield f"{name}: \"… {around} …\"; say \"{instead}\""


def sources_that_speak():
    """Headers, whose comments people read, and the bindings, whose texts are Python's help."""
    for folder in ("src", "apps", "python/bindings"):
        yield from sorted((ROOT / folder).rglob("*.hpp"))
    yield from sorted((ROOT / "python" / "bindings").glob("*.cpp"))


def comments_and_texts(path):
    """Runs of comment lines, and of string literals that the compiler joins, one line each."""
    text = path.read_text(encoding="utf-8")
    text = re.sub(r"\n\s*///? ?", " ", text)
    return re.sub(r"\"\s*\n\s*\"", "", text).splitlines()


def help_of(program, *verb):
    return subprocess.run([program, *verb, "--help"], capture_output=True, text=True, check=True).stdout


def verbs_of(program):
    return re.findall(r"^  ([a-z-]+) ", help_of(program).split("Subcommands:")[1], flags=re.M)


def words_of_help(program, verbs):
    for verb in verbs:
        yield from banned_words(f"limber {verb} --help", [" ".join(help_of(program, verb).split())])


def unnamed_verbs(verbs):
    if not verbs:
        yield "limber --help lists no verbs"
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    for verb in verbs:
        if f"limber {verb}" not in readme:
            yield f"README.md does not name `limber {verb}`"


def main():
    problems = [problem for path in documents() for rule in (broken_links, unfinished_merges) for problem in rule(path)]
    problems += unlisted_documents()
    problems += unlisted_headers()
    pages = [ROOT / name for name in ("README.md", "CONTRIBUTING.md", "SECURITY.md")]
    for path in [*pages, *sorted((ROOT / "docs").glob("*.md"))]:
        problems += long_sentences(path)
        problems += long_lines(path)
        problems += banned_words(path.relative_to(ROOT), prose(path))
    for path in sources_that_speak():
        problems += banned_words(path.relative_to(ROOT), comments_and_texts(path))
    if len(sys.argv) > 1:
        verbs = verbs_of(sys.argv[1])
        problems += unnamed_verbs(verbs)
        problems += words_of_help(sys.argv[1], verbs)
    print("\n".join(problems) or "documents are whole")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
