"""A driver with one fault, for tests of limber's side: fake_driver.py LOG [FAULT]. LOG gets a line for each thing
that happened to it, with the monotonic clock's time."""

import json
import os
import signal
import sys
import time

log = open(sys.argv[1], "a", buffering=1, encoding="utf-8")
fault = sys.argv[2] if len(sys.argv) > 2 else ""
pressures = [0.0, 0.0]
setpoints = [0.0, 0.0]
clock = 100.0
period = 0.05
sets = 0
vents = 0


def note(event):
    log.write(f"{time.monotonic()} {event}\n")


def send(text, end="\n"):
    sys.stdout.write(text + end)
    sys.stdout.flush()


def state(request, **changed):
    shape = {"backbone": [[0.1 * i, 0.0, 0.0] for i in range(5)]}
    if fault == "tilted" or fault == "bodies" and sets >= 4:
        shape = {"bodies": [[0.1 * i, 0.0, 0.2, 0.0, 0.0, 0.0, 1.0] for i in range(5)]}
    if fault == "tilted" and sets >= 4:
        shape["bodies"][2][3:] = [1.0, 0.0, 0.0, 0.0]
    if fault == "unseen" and sets >= 4:  # one body of five, from then on
        shape["backbone"].pop()
    return json.dumps({
        "type": "state", "seq": request["seq"], "t": clock, "pressure_kpa": pressures, "setpoint_kpa": setpoints,
        **shape, **changed,
    })


def answer_wrongly(request):
    """From the fourth set on."""
    whole = state(request)
    if fault == "late":
        time.sleep(0.2)
        send(whole)
    elif fault == "frame":  # answers at its end
        time.sleep(0.045)
        send(whole)
    elif fault == "repeat":
        send(whole)
        send(whole)
    elif fault == "old":
        send(state(request, seq=request["seq"] - 1))
    elif fault == "half":
        send(whole[: len(whole) // 2], end="")
    elif fault == "huge":
        while True:
            send("x" * 65536, end="")
    elif fault == "nan":
        send(state(request, pressure_kpa=[float("nan"), 0.0]))
    elif fault == "size":
        send(state(request, pressure_kpa=[0.0, 0.0, 0.0]))
    elif fault == "die":
        sys.exit(7)
    elif fault == "hang":
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
        time.sleep(3600)
    elif fault == "flood":
        while True:
            send(whole)
    elif fault == "clock":
        send(state(request, t=clock - 1.0))
    elif fault == "bom":
        send("\ufeff" + whole)
    elif fault == "frozen":
        send(state(request, t=101.0))
    elif fault == "group":
        os.setpgid(0, os.getpgid(os.getppid()))  # limber's
        os.kill(os.getpid(), signal.SIGSTOP)
    elif fault == "milliseconds":
        send(state(request, t=clock + 50.0))
    elif fault == "nanosecond":
        send(state(request, t=clock - 0.05 + 1e-9))
    elif fault == "twice":
        send('{"type": "fault", "message": "valve 3 is hot", ' + whole[1:])
    elif fault == "other":
        send(state(request, setpoint_kpa=[value + 7.0 for value in setpoints]))
    elif fault == "told":
        send(state(request, setpoint_kpa=[0.0, 99999.0]))
    elif fault == "fault":
        send(json.dumps({"type": "fault", "message": "valve 3 is hot"}))
    elif fault == "released":
        send(state(request, setpoint_kpa=[0.0, 0.0]))
    elif fault == "over":
        send(state(request, pressure_kpa=[106.0, 0.0]))
    elif fault == "babble":
        send("?")
    else:
        send(whole)


def vented():
    if fault == "absolute":
        return [101.3, 101.2]
    if fault == "sealed" and sets > 0:
        return pressures
    if fault == "overtaken" and sets > 0:  # the first sample is of before
        return [24.0, 0.0] if 1 < vents < 5 else [0.0, 0.0]
    return [0.0, 0.0] if sets == 0 else [p * 0.5 for p in pressures]


note(f"group {os.getpgrp() == os.getpid()} stdin {os.fstat(0).st_size} words {len(sys.argv)}")
if fault == "mute":
    time.sleep(3600)
for line in sys.stdin:
    request = json.loads(line)
    note(request["type"])
    if request["type"] == "vent":
        vents = vents + 1 if sets > 0 else 0
    # A vent right behind a set overtakes the sampling.
    if fault != "overtaken" or request["type"] != "vent" or vents != 1:
        clock += 5e-5 if fault == "crawling" else period
    if request["type"] == "hello":
        wrong = 3 if fault == "hello" else 2
        period = 1 / request["rate_hz"]
        send(json.dumps({
            "type": "hello", "protocol": 1, "driver": "fake", "device": "none", "rate_hz": request["rate_hz"],
            "segments": wrong, "real_time": fault not in ("fast", "behind"),
            "limit_kpa": [100, 60 if fault == "weak" else 100],
        }))
    elif request["type"] == "vent":
        pressures = vented()
        setpoints = [0.0, -106.0 if fault == "told_vented" else 0.0]
        send("?" if fault == "babble" and sets >= 4 else state(request))
    elif request["type"] == "set":
        before, setpoints = setpoints, request["pressure_kpa"]
        pressures = list(before if fault == "behind" else setpoints)
        sets += 1
        if sets >= 4:
            answer_wrongly(request)
        else:
            send(state(request))
    else:
        break
note("end")
