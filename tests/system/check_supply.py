"""Checks what a package of limber says of its parts, and how its programs were built.

    check_supply.py ROOT PACKAGES BUILD   ROOT: the packages, extracted; PACKAGES: packages.txt; BUILD: Ninja's folder

The bill of materials is SPDX 2.3 that holds together, and names every library that a program loads, every
package of [build] that is a library, and every one whose headers were compiled. Licences stand beside it. Programs are hardened."""

import pathlib
import re
import subprocess
import sys

# Of [build], but not in a package: what `limber bench` compares with, and what makes the module.
NOT_INSIDE = {"libdnnl-dev", "libxsmm-dev"}
TAGS = {"PackageName", "SPDXID", "PackageVersion", "PackageDownloadLocation", "FilesAnalyzed",
        "PackageLicenseConcluded", "PackageLicenseDeclared", "PackageCopyrightText", "ExternalRef"}
LICENCES = {"BSD-3-Clause", "BSD-2-Clause", "MIT", "MPL-2.0", "Apache-2.0", "BSL-1.0", "LGPL-2.1-or-later",
            "GPL-3.0-or-later WITH GCC-exception-3.1", "PSF-2.0", "Zlib"}
COMPILER = ("libstdc++", "libgcc", "libc-dev", "linux-libc")  # the bill has its libraries


def output(*command):
    return subprocess.run(command, capture_output=True, encoding="utf-8", check=True).stdout


def read_bill(path):
    """Packages by identifier, and relationships; every line is a tag that SPDX 2.3 has."""
    head, *blocks = path.read_text(encoding="utf-8").split("\n\n")
    lines = dict(line.split(": ", 1) for line in head.splitlines())
    assert lines["SPDXVersion"] == "SPDX-2.3" and lines["DataLicense"] == "CC0-1.0", head
    assert re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", lines["Created"]), head
    assert re.fullmatch(r"urn:uuid:[0-9a-f-]{36}", lines["DocumentNamespace"]), head
    packages, relations = {}, []
    for block in blocks:
        fields = [line.split(": ", 1) for line in block.strip().splitlines()]
        relations += [value.split() for tag, value in fields if tag == "Relationship"]
        package = {tag: value for tag, value in fields if tag != "Relationship"}
        assert set(package) == TAGS, block
        assert re.fullmatch(r"SPDXRef-[A-Za-z0-9.-]+", package["SPDXID"]), block
        assert package["PackageLicenseDeclared"] in LICENCES, block
        assert package["PackageVersion"] != "NOASSERTION", block
        assert re.fullmatch(r"PACKAGE-MANAGER purl pkg:[!-~]+", package["ExternalRef"]), block
        assert package["SPDXID"] not in packages, block
        packages[package["SPDXID"]] = package
    for one, _, other in relations:
        assert {one, other} <= packages.keys() | {"SPDXRef-DOCUMENT"}, (one, other)
    return packages, relations


def loaded_sources(program):
    """Source packages of the libraries that a program names."""
    paths = dict(re.findall(r"^\t(\S+) => (\S+)", output("ldd", program), re.M))
    for name in re.findall(r"\(NEEDED\).*\[(.*)\]", output("readelf", "--dynamic", "--wide", program)):
        path = pathlib.Path(paths.get(name, "/lib64/ld-linux-x86-64.so.2"))
        owner = output("dpkg-query", "--search", path.resolve().name).split(":")[0]
        yield output("dpkg-query", "--show", "--showformat=${source:Package}", owner)


def without_version(package):
    """libboost1.74-dev, which libboost-dev stands for."""
    return re.sub(r"(?<=\D)[\d.]+-dev$", "-dev", package)


def compiled_packages(build):
    """Packages of the headers that went into the programs; the peers of `limber bench` are no part of them."""
    objects = output("ninja", "-C", build, "-t", "deps").split("\n\n")
    headers = {line.strip() for one in objects if re.search(r"^(apps|python|src)/", one, re.M) and "_peer.dir" not in one
               for line in one.splitlines() if line.startswith("    /usr/")}
    owned = subprocess.run(["dpkg-query", "--search", *headers], capture_output=True, encoding="utf-8", check=False)
    return {without_version(line.split(":")[0]) for line in owned.stdout.splitlines()}


def check_hardened(program):
    """PIE or a module, tables read-only at once, no stack that runs, canaries, checked copies."""
    segments = output("readelf", "--program-headers", "--wide", program)
    dynamic = output("readelf", "--dynamic", "--wide", program)
    symbols = output("readelf", "--dyn-syms", "--wide", program)
    assert "Elf file type is DYN" in segments, segments
    assert "GNU_RELRO" in segments, segments
    assert re.search(r"GNU_STACK .* RW +0x", segments), segments
    assert "BIND_NOW" in dynamic and re.search(r"FLAGS_1\).*\bNOW\b", dynamic), dynamic
    assert "TEXTREL" not in dynamic and "RPATH" not in dynamic and "RUNPATH" not in dynamic, dynamic
    assert "__stack_chk_fail" in symbols, "no canary"
    assert re.search(r"__\w+_chk@", symbols), "no checked function"


def main():
    root, listed, build = map(pathlib.Path, sys.argv[1:])
    documents = root / "usr/share/doc"
    packages, relations = read_bill(documents / "limber/limber.spdx")
    names = {package["PackageName"] for package in packages.values()}
    section = re.search(r"^\[build\]\n(.*?)^\[", listed.read_text(encoding="utf-8"), re.M | re.S)[1]
    libraries = {line.split()[0] for line in section.splitlines()
                 if re.match(r"(lib|nlohmann|pybind11).*-dev\b", line)} - NOT_INSIDE
    assert libraries <= names, f"not in the bill: {sorted(libraries - names)}"
    compiled = {name for name in compiled_packages(build) if not name.startswith(COMPILER)}
    assert compiled, "no headers known: expected a build by Ninja"
    unnamed = compiled - set(map(without_version, names))
    assert not unnamed, f"compiled, but not in the bill: {sorted(unnamed)}"

    programs = {"limber": root / "usr/bin/limber"}
    for module in root.glob("usr/lib/python3/dist-packages/limber/_limber*.so"):
        programs["python3-limber"] = module
    for package, program in programs.items():
        check_hardened(program)
        linked = [packages[other]["PackageName"] for one, kind, other in relations
                  if one == f"SPDXRef-{package}" and kind == "DYNAMIC_LINK"]
        known = {output("dpkg-query", "--show", "--showformat=${source:Package}", name) for name in linked}
        unknown = set(loaded_sources(program)) - known
        assert not unknown, f"{package} loads what the bill does not name: {sorted(unknown)}"
    for one, kind, other in relations:
        package, name = packages[one]["PackageName"] if one in packages else "", packages[other]["PackageName"]
        if kind == "CONTAINS" and (documents / package).is_dir():
            notice = {"npm/three": "three.js authors", "npm/uplot": "Leon Sorokin"}.get(
                name, f"Parts of {name} are inside")
            text = (documents / package / "copyright").read_text(encoding="utf-8")
            assert notice in text, f"{package}: no licence of {name}"
    print(f"{len(packages)} packages in the bill; hardened: {', '.join(sorted(programs))}")


if __name__ == "__main__":
    main()
