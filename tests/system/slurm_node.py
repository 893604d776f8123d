"""A real Slurm on this machine alone, without systemd, for as long as a test lasts: munged, slurmctld and slurmd with their
files in one folder.

    slurm_node.py COMMAND …     runs the command with SLURM_CONF set, and takes Slurm down again

Needs root, and the packages slurm-wlm and munge. Processes are followed by proctrack/linuxproc, which needs no cgroups.
"""

import contextlib
import os
import pathlib
import secrets
import shutil
import socket
import subprocess
import sys
import tempfile
import time

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "srun", "squeue", "sinfo")
START_S = 60.0  # until the node is idle


def missing():
    """What keeps it from starting, or an empty text."""
    if os.geteuid() != 0:
        return "no root"
    path = os.environ.get("PATH", "") + ":/usr/sbin"
    gone = [name for name in PROGRAMS if shutil.which(name, path=path) is None]
    return f"no {', '.join(gone)} (apt install slurm-wlm munge)" if gone else ""


def free_port():
    with socket.socket() as listener:
        listener.bind(("", 0))
        return listener.getsockname()[1]


def configuration(folder):
    host = socket.gethostname().split(".")[0]
    lines = {
        "ClusterName": "limber",
        "SlurmctldHost": host,
        "SlurmUser": "root",
        "AuthType": "auth/munge",
        "AuthInfo": f"socket={folder}/munge.socket",
        "ProctrackType": "proctrack/linuxproc",
        "TaskPlugin": "task/none",
        "JobAcctGatherType": "jobacct_gather/none",
        "SelectType": "select/cons_tres",
        "SelectTypeParameters": "CR_CPU",
        "SwitchType": "switch/none",
        "MpiDefault": "pmix",
        "ReturnToService": "2",
        "SlurmctldPort": free_port(),
        "SlurmdPort": free_port(),
        "StateSaveLocation": f"{folder}/state",
        "SlurmdSpoolDir": f"{folder}/spool",
        "SlurmctldPidFile": f"{folder}/slurmctld.pid",
        "SlurmdPidFile": f"{folder}/slurmd.pid",
        "SlurmctldLogFile": f"{folder}/slurmctld.log",
        "SlurmdLogFile": f"{folder}/slurmd.log",
    }
    text = "".join(f"{key}={value}\n" for key, value in lines.items())
    text += f"NodeName={host} NodeAddr=127.0.0.1 CPUs={os.cpu_count()} State=UNKNOWN\n"
    return text + f"PartitionName=all Nodes={host} Default=YES State=UP\n"


def settle(folder):
    """Waits until slurmd's steps have ended: they would wait forever for a controller that is gone."""
    end = time.monotonic() + START_S
    while list((folder / "spool").glob("*_*.*")) and time.monotonic() < end:  # a step's socket, HOST_JOB.STEP
        time.sleep(0.2)


@contextlib.contextmanager
def slurm_node():
    """Yields the environment for commands of Slurm."""
    folder = pathlib.Path(tempfile.mkdtemp(prefix="limber_slurm_"))
    os.chmod(folder, 0o755)  # munged trusts no folder that others may write to
    for name in ("state", "spool"):
        (folder / name).mkdir()
    (folder / "munge.key").write_bytes(secrets.token_bytes(128))
    os.chmod(folder / "munge.key", 0o600)
    (folder / "slurm.conf").write_text(configuration(folder), encoding="utf-8")
    environment = {**os.environ, "SLURM_CONF": str(folder / "slurm.conf"),
                   "PATH": os.environ.get("PATH", "") + ":/usr/sbin"}
    started = []

    def start(*command):
        with open(folder / f"{command[0]}.out", "wb") as out:
            started.append(subprocess.Popen(command, env=environment, stdin=subprocess.DEVNULL, stdout=out, stderr=out))

    try:
        start("munged", "--foreground", "--force", f"--key-file={folder}/munge.key", f"--socket={folder}/munge.socket",
              f"--pid-file={folder}/munged.pid", f"--log-file={folder}/munged.log", f"--seed-file={folder}/munge.seed")
        end = time.monotonic() + START_S
        while not (folder / "munge.socket").exists() and time.monotonic() < end:
            time.sleep(0.1)
        start("slurmctld", "-D", "-i")
        start("slurmd", "-D")
        while time.monotonic() < end:
            state = subprocess.run(["sinfo", "--noheader", "--format=%T"], env=environment, capture_output=True,
                                   encoding="utf-8", check=False).stdout.strip()
            if state == "idle":
                break
            time.sleep(0.5)
        else:
            logs = "\n".join(f"{log.name}: {log.read_text(errors='replace')[-2000:]}"
                             for log in sorted(folder.glob("*.log")) + sorted(folder.glob("*.out")))
            raise RuntimeError(f"Slurm's node is not idle after {START_S} s\n{logs}")
        yield environment
        settle(folder)
    finally:
        for process in reversed(started):  # slurmd first, munged last
            process.terminate()
        for process in started:
            try:
                process.wait(timeout=20)
            except subprocess.TimeoutExpired:
                process.kill()
        shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    if missing():
        sys.exit(f"Slurm can't be started: {missing()}")
    with slurm_node() as settings:
        sys.exit(subprocess.run(sys.argv[1:], env=settings, check=False).returncode)
