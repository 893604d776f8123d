"""Functions compiled for a newer CPU must stay inside their file: the linker keeps one copy of an inline
function, and if that were the AVX-512 one, the program would die on a CPU without it.
Usage: private_symbols.py LIBRARY…
"""

import re
import subprocess
import sys

# The tables of pointers, Eigen in a namespace of its own, and data that exceptions need.
ALLOWED = re.compile(r"^limber::k\w+(Kernels|Peer)$|limber_eigen_peer_|^DW\.ref\.")


def main():
    checked = 0
    for library in sys.argv[1:]:
        listing = subprocess.run(["nm", "-C", "--defined-only", library], capture_output=True, text=True, check=True)
        member = ""
        for line in listing.stdout.splitlines():
            if line.endswith(":"):
                member = line
            elif line and re.search(r"_avx\w+\.cpp", member):
                _, kind, name = line.split(maxsplit=2)
                checked += 1
                assert kind in "tdrb" or ALLOWED.search(name), f"{library}, {member} shares {name}"
    assert checked > 10, "no kernels found"
    print(f"{checked} symbols, none shared")


main()
