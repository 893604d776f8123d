"""Files of every kind that limber reads, changed at random, given to the verbs that read them: every run ends by itself,
with one of the program's own codes, in time, and with a message that a user can read.

    damaged_files.py                       5000 files: about an hour of one core
    damaged_files.py --count 50 --seed 7   what the ordinary tests run
    damaged_files.py --seed 7 --only 31    file 31 of that seed alone, which is kept

What it does not cover: recordings with texts of variable length, which limber does not write and libhdf5 reads unchecked.
"""

import argparse
import concurrent.futures
import dataclasses
import pathlib
import random
import re
import resource
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time

from program import PROGRAM, ROOT, limber, temporary_files

LONGEST_S = 60.0  # of any run; those of undamaged files take a second
MOST_MEMORY = 4 << 30
CODES = {0, 1, 2, 3}  # done, no solution, wrong input, a fault of the arm or of its file
# What no user should have to read: the words of libraries, and of the end of a program.
FOREIGN_WORDS = re.compile(r"terminate called|std::|basic_string|bad_alloc|map::at|json\.exception|yaml-cpp|HDF5-DIAG|"
                           r"\bH5[A-Z]+[a-z]|Assertion|Segmentation|Traceback")

NUMBERS = [b"nan", b".nan", b"inf", b"-.inf", b"1e308", b"-1e308", b"1e309", b"5e-324", b"-0.0", b"0", b"1", b"-1",
           b"2147483648", b"-2147483648", b"18446744073709551616", b"1" + b"0" * 400, b"", b"~", b"null", b"true",
           b"0x10", b"1_000", b"1,5", b'"1"', b"[]", b"{}", b"1e39", b"1000", b"101"]
JUNK = [b"\0", b"\xef\xbb\xbf", b"\r\n", b"\xff\xfe", b"\xf0\x9f\x92\xa9", b"\xc3(", b"\xed\xa0\x80", b"%s%n", b"{}{0}", b'"',
        b"'", b"\\", b"&a *a", b"*a", b"<<: *a", b"!!binary aGk=", b"---\n", b"\t", b"# ", b"- ", b": ", b"|\n", b"[[[[[[[[",
        b'{"a":' * 50, b"../../../../etc/passwd", b"\x1b[2J", b",,,,", b"x" * 3000]
FLOATS = [struct.pack("<f", value) for value in (float("nan"), float("inf"), -float("inf"), 3.4e38, 1e30, -1e10, 0.0)]

# What was found is quoted, and something follows, or an ellipsis: a zero byte in it would end a C string.
CUT_MESSAGE = re.compile(r": '[^'…]*\Z")


@dataclasses.dataclass
class Kind:
    """A kind of file: whole ones, and what reads it; {f} is the damaged file, {o} a folder to write to."""

    name: str
    files: list
    commands: list
    change: object


def changed_text(draw, text):
    for _ in range(draw.choice([1, 1, 1, 2, 2, 3, 6])):
        text = draw.choice([a_number, a_number, a_number, a_bit, an_end, some_junk, a_line, a_piece, a_word])(draw, text)
    return text


def a_number(draw, text):
    found = list(re.finditer(rb"-?\d+\.?\d*(?:[eE][-+]?\d+)?", text))
    if not found:
        return text
    at = draw.choice(found)
    new = draw.choice(NUMBERS)
    if draw.random() < 0.2:
        new = b"%g" % (float(at.group()) * draw.choice([1e3, 1e-3, -1, 1e6, 1.5, 10]))
    return text[:at.start()] + new + text[at.end():]


def a_bit(draw, text):
    if not text:
        return text
    at = draw.randrange(len(text))
    return text[:at] + bytes([text[at] ^ 1 << draw.randrange(8)]) + text[at + 1:]


def an_end(draw, text):
    return text[:draw.randrange(len(text) + 1)]


def some_junk(draw, text):
    at = draw.randrange(len(text) + 1)
    return text[:at] + draw.choice(JUNK) + text[at:]


def a_line(draw, text):
    lines = text.split(b"\n")
    at = draw.randrange(len(lines))
    other = draw.randrange(len(lines))
    what = draw.randrange(3)
    if what == 0:
        lines[at:at] = [lines[at]] * draw.choice([1, 2, 50])
    elif what == 1:
        del lines[at]
    else:
        lines[at], lines[other] = lines[other], lines[at]
    return b"\n".join(lines)


def a_piece(draw, text):
    first = draw.randrange(len(text) + 1)
    end = first + draw.choice([1, 2, 5, 20, 200])
    piece = text[first:end]
    return text[:first] + piece * draw.choice([0, 2, 3, 20]) + text[end:]


def a_word(draw, text):
    words = list(re.finditer(rb"[A-Za-z_]{3,}", text))
    if not words:
        return text
    at = draw.choice(words)
    return text[:at.start()] + draw.choice([draw.choice(words).group(), b"", b"x", draw.choice(NUMBERS)]) + text[at.end():]


def changed_bytes(draw, data):
    data = bytearray(data)
    for _ in range(draw.choice([1, 1, 2, 3, 8, 30])):
        at = draw.randrange(len(data) if draw.random() < 0.5 else min(len(data), 4096))
        length = draw.choice([1, 2, 4, 8, 64])
        what = draw.randrange(6)
        if what == 0:
            data[at] ^= 1 << draw.randrange(8)
        elif what == 1:
            data[at:at + length] = draw.choice([b"\xff", b"\0", bytes([draw.randrange(256)])]) * length
        elif what == 2:
            del data[at:at + length]
        elif what == 3:
            data[at:at] = data[at:at + length]
        elif what == 4:
            other = draw.randrange(len(data))
            data[at:at + length] = data[other:other + length]
        else:
            del data[max(at, 1):]
        if not data:
            return b""
    return bytes(data)


def changed_tensors(draw, data):
    """Of a safetensors file: its header as a text, its numbers, or any bytes."""
    length = struct.unpack("<Q", data[:8])[0]
    header, numbers = data[8:8 + length], bytearray(data[8 + length:])
    what = draw.random()
    if what < 0.2:
        return changed_bytes(draw, data)
    if what < 0.8:
        header = changed_text(draw, header)
    else:
        for _ in range(draw.choice([1, 3])):
            at = 4 * draw.randrange(len(numbers) // 4)
            numbers[at:at + 4] = draw.choice(FLOATS)
    said = len(header) if draw.random() < 0.9 else draw.choice([0, 1, length, 2**63, 2**64 - 1, len(data)])
    return struct.pack("<Q", said) + header + bytes(numbers)


def make_files(folder):
    """Whole files, made by limber itself, of a small arm and a small network."""

    def run(*arguments):
        result = limber(*arguments, folder=folder)
        if result.returncode not in (0, 1):
            sys.exit(f"limber {' '.join(map(str, arguments))}: {result.stderr}")

    arm = ("--arm", "two_segment")
    plan = ("plan", *arm, "--environment", "e.yaml", "--margin-m", 0.001, "--goal-margin-m", 0.001)
    (folder / "e.yaml").write_text(
        "schema: limber/environment/1\nname: e\nobstacles:\n  - circle: {x_m: 0.2, y_m: -0.3, radius_m: 0.03}\n"
        "  - rectangle: {x_m: -0.3, y_m: 0.1, width_m: 0.05, height_m: 0.1, angle_rad: 0.2}\nstart: rest\n"
        "goal: {x_m: 0.4, y_m: 0.05, position_tolerance_m: 0.1}\n", encoding="utf-8")
    run("collect", *arm, "--schedule", "random", "--count", 12, "--episodes", 2, "--hold-s", 0.5, "--out", "r.h5")
    run("collect", *arm, "--schedule", "random", "--count", 6, "--episodes", 4, "--hold-s", 0.5, "--vary-physics", "1.5",
        "--out", "arms.h5")
    run("export", "r.h5", "--csv", "csv")
    run("export", "r.h5", "--motive", "motive")
    learn = ("train", *arm, "--hidden", 8, "--windows", 2, "--quiet")
    run(*learn, "--data", "r.h5", "--epochs", 3, "--out", "m.safetensors")
    run(*learn, "--data", "arms.h5", "--family", "--family-size", 2, "--epochs", 3, "--out", "family.safetensors")
    run("characterize", *arm, "--valves", "r.h5", "--out", "valves.yaml")
    run(*plan, "--no-load", "--max-queries", 5000, "--out", "p.json")
    run(*plan, "--model", "m.safetensors", "--forest", "f.forest", "--forest-nodes", 50, "--max-queries", 2000,
        "--out", "p_net.json")
    (folder / "track.csv").write_text("time_s,x_m,y_m\n" + "".join(f"{0.1 * k},{0.4 - 0.001 * k},{0.05 + 0.002 * k}\n"
                                                                  for k in range(30)), encoding="utf-8")
    unfinished(folder, [*learn, "--data", "r.h5", "--epochs", 100000, "--checkpoint-interval-s", 0, "--out", "c.safetensors"])


def kinds_of(folder):
    """The kinds of these files, and of some that limber comes with."""
    on = "--arm two_segment"
    made = folder.resolve()
    quick = "--margin-m 0.001 --goal-margin-m 0.001 --max-queries 1000"
    text, tensors, data = changed_text, changed_tensors, changed_bytes
    motive = f"import motive {made}/motive/episode_000_motive.csv --pressures {made}/motive/episode_000_pressures.csv"
    kinds = [
        Kind("arm.yaml", [ROOT / "arms" / f"{name}.yaml" for name in ("two_segment", "motor_driven", "uneven_limits")], [
            "inspect {f}", f"plan --arm {{f}} --no-load --environment {made}/e.yaml {quick} --out {{o}}/p.json",
            "collect --arm {f} --schedule random --count 1 --hold-s 0.1 --out {o}/r.h5",
            "characterize --arm {f} --steps 4 --out {o}/a.yaml", f"evaluate --arm {{f}} --data {made}/r.h5",
            "export {f} --mjcf {o}/a.xml"], text),
        Kind("environment.yaml", [folder / "e.yaml", ROOT / "environments/07_clutter.yaml"], [
            f"environment check {{f}} {on} --svg {{o}}/e.svg", f"inspect {{f}} {on}",
            f"plan {on} --no-load --environment {{f}} {quick} --out {{o}}/p.json --svg {{o}}/p.svg",
            f"execute {on} --plan {made}/p.json --environment {{f}}"], text),
        Kind("mapping.yaml", [folder / "csv/mapping.yaml"],
             [f"import csv {made}/csv/episode_000.csv --mapping {{f}} {on} --out {{o}}/r.h5"], text),
        Kind("mapping.yaml", [folder / "motive/mapping.yaml"], [f"{motive} --mapping {{f}} {on} --out {{o}}/r.h5"], text),
        Kind("log.csv", [folder / "csv/episode_000.csv"],
             [f"import csv {{f}} --mapping {made}/csv/mapping.yaml {on} --out {{o}}/r.h5"], text),
        Kind("motive.csv", [folder / "motive/episode_000_motive.csv"],
             [motive.replace(f"{made}/motive/episode_000_motive.csv", "{f}") + f" {on} --out {{o}}/r.h5"], text),
        Kind("pressures.csv", [folder / "motive/episode_000_pressures.csv"],
             [motive.replace(f"{made}/motive/episode_000_pressures.csv", "{f}") + f" {on} --out {{o}}/r.h5"], text),
        Kind("track.csv", [folder / "track.csv"],
             [f"execute --track {{f}} --model {made}/m.safetensors {on} --track-queries 300 --out {{o}}/r.h5"], text),
        Kind("recording.h5", [folder / "r.h5", folder / "arms.h5"], [
            f"inspect {{f}} {on}", f"evaluate --data {{f}} {on} --model {made}/m.safetensors", "export {f} --csv {o}/c",
            f"train --data {{f}} {on} --epochs 1 --hidden 4 --windows 2 --out {{o}}/m.safetensors",
            f"characterize {on} --valves {{f}} --out {{o}}/v.yaml",
            f"adapt {on} --model {made}/family.safetensors --recording {{f}} --out {{o}}/m.safetensors"], data),
        Kind("model.safetensors", [folder / "m.safetensors", folder / "family.safetensors"], [
            "inspect {f}", f"plan {on} --model {{f}} --environment {made}/e.yaml {quick} --out {{o}}/p.json",
            f"evaluate --data {made}/r.h5 --model {{f}} {on}", "export {f} --onnx {o}/m.onnx",
            f"train --from {{f}} --data {made}/r.h5 --epochs 1 --windows 2 {on} --out {{o}}/m.safetensors",
            f"adapt {on} --model {{f}} --recording {made}/r.h5 --out {{o}}/m.safetensors"], tensors),
        Kind("plan.json", [folder / "p.json", folder / "p_net.json"], [
            f"inspect {{f}} {on}", f"verify {on} --no-load --plan {{f}} --environment {made}/e.yaml",
            f"verify {on} --model {made}/m.safetensors --plan {{f}} --environment {made}/e.yaml",
            f"execute {on} --plan {{f}} --environment {made}/e.yaml --out {{o}}/r.h5 --svg {{o}}/r.svg", "export {f} --csv {o}/c"], text),
        Kind("f.forest", [folder / "f.forest"], [
            f"plan {on} --model {made}/m.safetensors --environment {made}/e.yaml --forest {{f}} --forest-nodes 10 {quick} "
            "--out {o}/p.json", "inspect {f}"], data),
        Kind("valves.yaml", [folder / "valves.yaml"], [
            "inspect {f}", f"plan {on} --no-load --valves {{f}} --environment {made}/e.yaml {quick} --out {{o}}/p.json"], text),
        Kind("c.safetensors.checkpoint", [folder / "c.safetensors.checkpoint"], [
            f"train {on} --hidden 8 --windows 2 --data {made}/r.h5 --epochs 100000 --checkpoint-interval-s 1 --resume "
            "--out {o}/c.safetensors"], tensors),
    ]
    if missing := [path for kind in kinds for path in kind.files if not path.exists()]:
        sys.exit(f"{missing[0]}: not made")
    return kinds


def unfinished(folder, arguments):
    """A run that is stopped once its checkpoint stands."""
    with subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=folder, stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL) as process:
        end = time.monotonic() + LONGEST_S
        while not list(folder.glob("*.checkpoint")) and time.monotonic() < end:
            time.sleep(0.05)
        process.send_signal(signal.SIGINT)


class Campaign:
    def __init__(self, options, folder):
        self.options = options
        self.folder = folder
        (folder / "whole").mkdir()
        make_files(folder / "whole")
        self.kinds = kinds_of(folder / "whole")

    def problem(self, number):
        """What went wrong with file `number`; empty: nothing."""
        draw = random.Random(self.options.seed * 1_000_003 + number)
        kind = draw.choice(self.kinds)
        own = self.folder / f"run_{number}"
        (own / "out").mkdir(parents=True)
        # A checkpoint lies where the run that goes on from it looks for it.
        damaged = (own / "out" if kind.name.endswith(".checkpoint") else own) / kind.name
        damaged.write_bytes(kind.change(draw, draw.choice(kind.files).read_bytes()))
        command = [part.format(f=damaged, o=own / "out") for part in draw.choice(kind.commands).split()]
        found = self.run(command, own, resumes=kind.name.endswith(".checkpoint"))
        if found:
            kept = pathlib.Path(self.options.keep) / f"{self.options.seed}_{number}_{kind.name}"
            kept.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(damaged, kept)
            found = f"{number}: limber {' '.join(command)}: {found}; the file: {kept}"
        shutil.rmtree(own)
        return found

    def run(self, command, folder, resumes):
        def limit():
            resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

        with subprocess.Popen([PROGRAM, *command], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, preexec_fn=limit) as process:
            try:
                said, _ = process.communicate(timeout=1.0 if resumes else LONGEST_S)
            except subprocess.TimeoutExpired:
                process.send_signal(signal.SIGINT if resumes else signal.SIGKILL)
                try:
                    said, _ = process.communicate(timeout=LONGEST_S)
                except subprocess.TimeoutExpired:
                    process.kill()
                    return "does not stop"
                if not resumes:
                    return f"not done after {LONGEST_S:.0f} s"
        text = said.decode("utf-8", "replace")
        if process.returncode not in CODES and not (resumes and process.returncode in (130, -signal.SIGINT)):
            return f"ends with {process.returncode}: {text[-300:]}"
        if foreign := FOREIGN_WORDS.search(text):
            return f"says {foreign[0]}: {text[-300:]}"
        if CUT_MESSAGE.search(text):
            return f"says but half: {text[-300:]}"
        if left := temporary_files(folder):
            return f"leaves {left[0]}"
        return ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=5000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, help="this one alone")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--keep", default="damaged", help="folder for files that show something")
    options = parser.parse_args()
    numbers = range(options.count) if options.only is None else [options.only]
    with tempfile.TemporaryDirectory(prefix="limber_damaged_") as name:
        campaign = Campaign(options, pathlib.Path(name))
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            problems = [found for found in pool.map(campaign.problem, numbers) if found]
    print("\n".join(problems))
    print(f"{len(numbers)} files of {len(campaign.kinds)} kinds, seed {options.seed}: {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
