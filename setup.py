"""What pyproject.toml can't say: the version stands in CMakeLists.txt, and CMake builds the module.

With LIMBER_BUILD_DIR in the environment, the module of that build folder is taken instead.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

ROOT = pathlib.Path(__file__).resolve().parent
VERSION = re.search(r"project\(limber VERSION ([\d.]+)",
                    (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]


def build_with_cmake():
    """The folder of a finished build."""
    folder = ROOT / "build" / "wheel"
    subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                    "-DLIMBER_BUILD_TESTS=OFF", "-DLIMBER_BUILD_PEERS=OFF"], check=True)
    subprocess.run(["cmake", "--build", folder, "--target", "limber_python"], check=True)
    return folder


class BuildWithModule(build_py):
    """The package with its compiled module, and the arms, environments and families that limber comes with."""

    def run(self):
        super().run()
        folder = os.environ.get("LIMBER_BUILD_DIR") or build_with_cmake()
        package = pathlib.Path(self.build_lib) / "limber"
        with tempfile.TemporaryDirectory() as prefix:
            subprocess.run(["cmake", "--install", folder, "--component", "python", "--prefix",
                            prefix, "--strip"], check=True, stdout=subprocess.DEVNULL)
            for made in pathlib.Path(prefix).rglob("_limber*"):  # the module, and its stub
                shutil.copy2(made, package)
        module = package / ("_limber" + sysconfig.get_config_var("EXT_SUFFIX"))
        if not module.exists():
            raise SystemExit(f"{folder} holds no {module.name}: it needs pybind11-dev and python3-dev, "
                             f"and to be built for the Python that asks, {sys.executable}")
        for data in ("arms", "environments", "families"):
            shutil.copytree(ROOT / data, package / "data" / data, dirs_exist_ok=True)


class WithModule(Distribution):
    """A wheel for this machine's kind alone."""

    def has_ext_modules(self):
        return True


setup(version=VERSION, cmdclass={"build_py": BuildWithModule}, distclass=WithModule)
