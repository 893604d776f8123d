"""Man pages and shell completions of the program, made from what its --help says.

    tools/command_pages.py build/release/bin/limber FOLDER

writes FOLDER/man1/limber.1, limber-VERB.1 …, FOLDER/bash/limber and FOLDER/zsh/_limber.
"""

import argparse
import dataclasses
import pathlib
import re
import subprocess

# Flags that take one of limber's own files by name: the folder that it lies in.
OWN = {"--arm": "arms", "--environment": "environments"}


@dataclasses.dataclass
class Flag:
    names: list  # "-h", "--help"
    value: str  # "TEXT", "" where it takes none
    note: str  # ":POSITIVE", "=three_segment", " Excludes: --no-load"
    text: str = ""


@dataclasses.dataclass
class Page:
    name: str
    summary: str
    flags: list = dataclasses.field(default_factory=list)
    verbs: list = dataclasses.field(default_factory=list)  # (name, summary)
    example: list = dataclasses.field(default_factory=list)


FLAG = re.compile(r"^  ((?:-\w,)?--[\w-]+(?:,--[\w-]+)*)(.*)$")
VALUE = re.compile(r"^ (TEXT|INT|UINT|FLOAT|ENUM|\{[^}]*\})(\S*)")


def read_flag(line):
    """A flag's line: its names, its value, and the text behind at least two spaces or column 30."""
    names = FLAG.match(line)[1]
    head, text = (line[:30], line[30:]) if line[29:30] in ("", " ") else (line, "")
    rest = head[2 + len(names):]
    found = VALUE.match(rest)
    return Flag(names.split(","), found[1] if found else "",
                (rest[found.end(1):] if found else rest).strip(), text.strip())


def read_page(program, *verb):
    """What --help says of the program, or of one of its verbs."""
    lines = subprocess.run([program, *verb, "--help"], capture_output=True, check=True,
                           encoding="utf-8").stdout.splitlines()
    page = Page("-".join(["limber", *verb]), lines[0].rstrip("."))
    part = ""
    for line in lines[1:]:
        if re.match(r"^\w+.*:$", line):
            part = line.rstrip(":").split()[-1]
        elif part == "Subcommands" and (found := re.match(r"^  ([a-z-]+) +(.*)$", line)):
            page.verbs.append(found.groups())
        elif part in ("Example", "Examples"):
            page.example.append(line.strip())
        elif FLAG.match(line):
            page.flags.append(read_flag(line))
        elif line.startswith(" " * 30) and page.flags and part == "Options":
            page.flags[-1].text = f"{page.flags[-1].text} {line.strip()}".strip()
    page.example = [line for line in page.example if line]
    return page


def roff(text):
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq")
    return "\\&" + text if text.startswith(".") else text


def man_page(page, version, others):
    lines = [f'.TH {page.name.upper()} 1 "" "limber {version}" "limber"', ".SH NAME",
             f"{roff(page.name)} \\- {roff(page.summary)}", ".SH SYNOPSIS",
             f".B {roff(page.name.replace('-', ' ', 1))}",
             "VERB [OPTIONS]" if page.verbs else "[OPTIONS]"]
    if page.verbs:
        lines += [".SH VERBS"]
        for verb, summary in page.verbs:
            lines += [".TP", f"\\fBlimber\\-{roff(verb)}\\fR(1)", roff(summary)]
    lines += [".SH OPTIONS"]
    for flag in page.flags:
        value = f" \\fI{roff(flag.value)}\\fR" if flag.value else ""
        note = f" {roff(flag.note)}" if flag.note.startswith(("Excludes", "Needs", "REQUIRED")) else ""
        lines += [".TP", ", ".join(f"\\fB{roff(name)}\\fR" for name in flag.names) + value + note,
                  roff(flag.text) or "\\&"]
    if page.example:
        lines += [".SH EXAMPLE", ".nf", *map(roff, page.example), ".fi"]
    lines += [".SH EXIT STATUS", "0 done, 1 no solution or a check that failed, 2 bad input or "
              "usage, 3 a driver or system fault.", ".SH SEE ALSO",
              ",\n".join(f"\\fB{roff(name)}\\fR(1)" for name in others)]
    return "\n".join(lines) + "\n"


def bash_completion(verbs, names):
    cases = "\n".join(f"    {page.name.split('-', 1)[1]}) flags='"
                      f"{' '.join(name for flag in page.flags for name in flag.names)}' ;;"
                      for page in verbs)
    own = "\n".join(f"    {flag}) words='{' '.join(names[folder])}' ;;"
                    for flag, folder in OWN.items())
    return f"""# bash completion of limber, made from its --help by tools/command_pages.py
_limber() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} flags='' words=''
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    mapfile -t COMPREPLY < <(compgen -W '{' '.join(page.name.split('-', 1)[1] for page in verbs)} \
--help --version' -- "$word")
    return
  fi
  case ${{COMP_WORDS[1]}} in
{cases}
  esac
  case $before in
{own}
  esac
  case $word in
    -*) mapfile -t COMPREPLY < <(compgen -W "$flags" -- "$word") ;;
    *) mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word"; compgen -f -- "$word") ;;
  esac
}}
complete -o filenames -F _limber limber
"""


def zsh_quoted(text):
    return text.replace("'", "'\\''").replace("[", "\\[").replace("]", "\\]").replace(":", "\\:")


def zsh_completion(verbs, names):
    listed = "\n".join(f"    '{page.name.split('-', 1)[1]}:{zsh_quoted(page.summary)}'"
                       for page in verbs)
    cases = []
    for page in verbs:
        flags = []
        for flag in page.flags:
            for name in flag.names:
                own = OWN.get(name)
                action = f":{flag.value.lower()}:" + (
                    f"_alternative \"own:own:({' '.join(names[own])})\" \"files:file:_files\""
                    if own else "_files") if flag.value else ""
                flags.append(f"'*{name}[{zsh_quoted(flag.text)}]{action}'")
        joined = " \\\n        ".join([*flags, "'*:file:_files'"])
        cases.append(f"    {page.name.split('-', 1)[1]})\n      _arguments \\\n        {joined} ;;")
    return f"""#compdef limber
# zsh completion of limber, made from its --help by tools/command_pages.py
_limber() {{
  local -a verbs=(
{listed}
  )
  if (( CURRENT == 2 )); then
    _describe verb verbs
    return
  fi
  local verb=$words[2]
  shift words
  (( CURRENT-- ))
  case $verb in
{chr(10).join(cases)}
  esac
}}
_limber "$@"
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    arguments = parser.parse_args()
    root = pathlib.Path(__file__).resolve().parents[1]
    whole = read_page(arguments.program)
    verbs = [read_page(arguments.program, verb) for verb, _ in whole.verbs]
    version = subprocess.run([arguments.program, "--version"], capture_output=True, check=True,
                             encoding="utf-8").stdout.split()[-1]
    names = {folder: sorted(path.stem for path in (root / folder).glob("*.yaml"))
             for folder in OWN.values()}
    for part in ("man1", "bash", "zsh"):
        (arguments.folder / part).mkdir(parents=True, exist_ok=True)
    for page in [whole, *verbs]:
        others = ["limber"] if page is not whole else [verb.name for verb in verbs]
        (arguments.folder / "man1" / f"{page.name}.1").write_text(
            man_page(page, version, others), encoding="utf-8")
    (arguments.folder / "bash" / "limber").write_text(bash_completion(verbs, names), encoding="utf-8")
    (arguments.folder / "zsh" / "_limber").write_text(zsh_completion(verbs, names), encoding="utf-8")


if __name__ == "__main__":
    main()
