"""Recordings made to do harm, written by h5py and by hand: each is refused by one message that names the
file and the place, by the program and from Python, and nothing else is opened, loaded or used up."""

import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

PROGRAM = os.environ["LIMBER_PROGRAM"]
MODULE = pathlib.Path(PROGRAM).resolve().parents[1] / "python"
sys.path.insert(0, str(MODULE))
try:
    import limber
except ImportError:
    limber = None  # built without the module, as with sanitizers
FRAMES = 5
POINTS = 4
SEGMENTS = 1
UNKNOWN_FILTER = 32099  # registered by nobody here
MAX_MEMORY_KB = 400_000  # of the program and its child, whatever the file says
# Says that it was loaded, as a plugin of HDF5 could do anything.
PLUGIN = """
#include <cstdio>
#include <cstdlib>
struct Loaded { Loaded() { std::fclose(std::fopen(std::getenv("LIMBER_TEST_LOADED"), "w")); } } loaded;
"""


def write(path, **how):
    """A recording as an h5py user writes one. how: libver, userblock_size."""
    with h5py.File(path, "w", **how) as file:
        file.attrs.update(schema="limber/recording/1", arm_name="one", arm_hash="0" * 16, source="h5py",
                          settings="", program_version="none", rate_hz=20.0, segments=SEGMENTS,
                          points=POINTS, seed=1)
        for number in range(2):
            group = file.create_group(f"episodes/{number:06}")
            for name, data in arrays().items():
                group.create_dataset(name, data=data, chunks=True, compression="gzip", shuffle=True)


def arrays():
    backbone = np.zeros((FRAMES, POINTS, 3), "f4")
    backbone[:, :, 0] = np.linspace(0, 0.3, POINTS)
    return {"time_s": np.arange(FRAMES) / 20.0, "pressure_kpa": np.zeros((FRAMES, SEGMENTS), "f4"),
            "setpoint_kpa": np.zeros((FRAMES, SEGMENTS), "f4"), "backbone": backbone,
            "motion_index": np.zeros(FRAMES, "i4")}


class Recording(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.path = self.folder / "run.h5"
        write(self.path)

    def inspect(self, **more):
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        done = subprocess.run([PROGRAM, "inspect", self.path], capture_output=True, encoding="utf-8",
                              timeout=100, check=False, env={**os.environ, **more})
        after = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        self.assertLess(max(before, after), MAX_MEMORY_KB)
        return done

    def refused(self, *parts, **more):
        done = self.inspect(**more)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        for part in (str(self.path), *parts):
            self.assertIn(part, done.stderr)
        if limber is None:
            return
        # The same from Python, in a process where h5py has the same libhdf5.
        found = subprocess.run(
            [sys.executable, "-c", "import h5py, limber, sys\n"
             "try:\n    limber.read_recording(sys.argv[1])\n"
             "except limber.InputError as error:\n    print(error)", self.path],
            capture_output=True, encoding="utf-8", timeout=100, check=False,
            env={**os.environ, "PYTHONPATH": str(MODULE), **more})
        self.assertEqual(found.stderr, "")
        for part in (str(self.path), *parts):
            self.assertIn(part, found.stdout)

    def replace(self, name, **how):
        with h5py.File(self.path, "r+") as file:
            del file[name]
            return file.create_dataset(name, **how).id.get_storage_size()

    def test_reads_what_h5py_users_write(self):
        for how in ({}, {"libver": "latest"}, {"userblock_size": 512}, {"userblock_size": 2048}):
            write(self.path, **how)
            if limber is None:
                continue
            found = limber.read_recording(self.path)
            self.assertEqual(len(found.episodes), 2)
            np.testing.assert_array_equal(found.episodes[1].backbone.reshape(FRAMES, POINTS, 3),
                                          arrays()["backbone"])
        write(self.path)
        self.assertEqual(self.inspect().returncode, 0)

    def test_refuses_links_to_other_files(self):
        other = self.folder / "other.h5"
        write(other)
        for name in ("episodes", "episodes/000001", "episodes/000000/time_s"):
            for link in (h5py.ExternalLink("other.h5", name), h5py.SoftLink("/episodes/000000")):
                write(self.path)
                with h5py.File(self.path, "r+") as file:
                    del file[name]
                    file[name] = link
                self.refused(f"{name}: a link to other data; expected the data themselves")

    def test_refuses_external_storage(self):
        secret = self.folder / "secret"
        secret.write_bytes(b"s" * 8 * FRAMES)
        self.replace("episodes/000000/time_s", shape=(FRAMES,), dtype="f8",
                     external=[(str(secret), 0, 8 * FRAMES)])
        self.refused("episodes/000000/time_s: data in another file")

    def test_refuses_virtual_layouts(self):
        other = self.folder / "other.h5"
        write(other)
        layout = h5py.VirtualLayout((FRAMES,), "f8")
        layout[:] = h5py.VirtualSource(str(other), "episodes/000000/time_s", shape=(FRAMES,))
        with h5py.File(self.path, "r+") as file:
            del file["episodes/000000/time_s"]
            file.create_virtual_dataset("episodes/000000/time_s", layout)
        self.refused("episodes/000000/time_s: data in another file")

    def test_refuses_other_filters_and_loads_no_plugin(self):
        name = "episodes/000000/backbone"
        for how in ({"compression": "lzf"}, {"scaleoffset": 3}):
            write(self.path)
            self.replace(name, data=arrays()["backbone"], **how)
            self.refused(f"{name}: HDF5 filter ", "expected no filter, or deflate (gzip), shuffle and fletcher32")
        # One that only a plugin could have: lzf's number, changed in the file.
        write(self.path)
        with h5py.File(self.path, "r+") as file:
            how = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
            how.set_chunk((FRAMES, POINTS, 3))
            how.set_filter(h5py.h5z.FILTER_LZF, h5py.h5z.FLAG_OPTIONAL)
            del file[name]
            made = h5py.h5d.create(file.id, name.encode(), h5py.h5t.IEEE_F32LE,
                                   h5py.h5s.create_simple((FRAMES, POINTS, 3)), how)
            made.write_direct_chunk((0, 0, 0), arrays()["backbone"].tobytes())
        content = self.path.read_bytes()
        old, new = (number.to_bytes(2, "little") + b"\x08\x00"  # and the length of its name
                    for number in (h5py.h5z.FILTER_LZF, UNKNOWN_FILTER))
        self.assertEqual(content.count(old), 1)
        self.path.write_bytes(content.replace(old, new))
        source = self.folder / "plugin.cpp"
        source.write_text(PLUGIN, encoding="utf-8")
        plugins = self.folder / "plugins"
        plugins.mkdir()
        subprocess.run(["c++", "-shared", "-fPIC", "-o", plugins / "libplugin.so", source], check=True)
        loaded = self.folder / "loaded"
        self.refused(f"{name}: HDF5 filter {UNKNOWN_FILTER} found", HDF5_PLUGIN_PATH=str(plugins),
                     LIMBER_TEST_LOADED=str(loaded))
        self.assertFalse(loaded.exists(), "a plugin was loaded")

    def test_refuses_shapes_that_the_file_cannot_hold(self):
        self.replace("episodes/000000/time_s", shape=(1 << 27,), dtype="f8", chunks=(1024,))
        self.refused("episodes/000000/time_s: its shape says 134217728 numbers, but the file holds 0 bytes")
        write(self.path)
        with h5py.File(self.path, "r+") as file:
            del file["episodes/000000/time_s"]
            sparse = file.create_dataset("episodes/000000/time_s", (1 << 27,), "f8", chunks=(1024,))
            sparse[:FRAMES] = arrays()["time_s"]
        self.refused("episodes/000000/time_s: its shape says 134217728 numbers, but the file holds 8192 bytes")

    def test_refuses_large_chunks(self):
        self.replace("episodes/000000/time_s", data=np.arange(FRAMES) / 20.0, maxshape=(None,),
                     chunks=(1 << 23,), compression="gzip")
        self.refused("episodes/000000/time_s: chunks of more than 4194304 numbers")

    def test_refuses_the_same_data_a_thousand_times(self):
        """Each is small for its shape, and all are one: memory would be used up though the file is not."""
        frames = 1 << 18
        with h5py.File(self.path, "w", libver="latest") as file:
            with h5py.File(self.folder / "other.h5", "w") as other:
                del other
            write(self.folder / "plain.h5")
            with h5py.File(self.folder / "plain.h5") as plain:
                file.attrs.update(dict(plain.attrs.items()))
            first = file.create_group("episodes/000000")
            for name, data in arrays().items():
                large = np.resize(data, (frames, *data.shape[1:]))
                large = np.arange(frames) / 16.0 if name == "time_s" else large
                first.create_dataset(name, data=large, chunks=True, compression="gzip", compression_opts=9,
                                     shuffle=True)
            for number in range(1, 1000):
                file[f"episodes/{number:06}"] = first
        self.refused("holds more numbers than a file of its size can")


if __name__ == "__main__":
    unittest.main()
