"""The half of a driver that is the same for every device: limber's protocol on standard input and output (docs/driver.md),
and the deadman. A driver is a device with four methods, given to `serve`:

    limits_kpa(hello)   the device's own limits, a list with one number per segment; `set` gets nothing beyond them
    set(pressures_kpa)  hands the device these set points, gauge, signed, one per segment, and takes a sample
    vent()              opens every vent valve, and takes a sample; has to work at any time, more than once
    read()              (time_s, pressures_kpa, shape): that sample. time_s is on the device's or the driver's clock
                        and goes on with every sample; shape is a list of [x_m, y_m, theta_rad], base first, or of
                        [x, y, z, qx, qy, qz, qw] from a tracker that sees in 3D, or None

Nothing here knows a unit but kPa, m, rad and s. Standard output belongs to limber: print messages to standard error.
Copy this file and change it as you like."""

import json
import os
import select
import sys
import time

PROTOCOL = 1
SILENT_FRAMES = 3  # without a request: vent
MAX_LINE = 1 << 20
ROUNDING_KPA, ROUNDING_SHARE = 1e-3, 1e-5  # of set points, beyond a limit: the larger of both


class Lines:
    """Lines from a file descriptor, with a timeout."""

    def __init__(self, descriptor):
        self.descriptor = descriptor
        self.buffer = b""

    def next(self, timeout_s):
        """The next line; None after `timeout_s` without one. EOFError at the end."""
        while b"\n" not in self.buffer:
            ready, _, _ = select.select([self.descriptor], [], [], timeout_s)
            if not ready:
                return None
            chunk = os.read(self.descriptor, 65536)
            if not chunk or len(self.buffer) > MAX_LINE:
                raise EOFError
            self.buffer += chunk
        line, _, self.buffer = self.buffer.partition(b"\n")
        return line.decode("utf-8")


def send(message):
    sys.stdout.write(json.dumps(message, allow_nan=False) + "\n")
    sys.stdout.flush()


def state(request, device, setpoints):
    time_s, pressures, shape = device.read()
    key = "bodies" if shape and len(shape[0]) == 7 else "backbone"
    return {"type": "state", "seq": request["seq"], "t": time_s, "pressure_kpa": pressures, "setpoint_kpa": setpoints,
            key: shape}


def require_within(limits_kpa, pressures_kpa):
    """@throws ValueError for set points that the device is never to get, whoever asks for them."""
    if len(pressures_kpa) != len(limits_kpa):
        raise ValueError(f"{len(pressures_kpa)} set points; expected {len(limits_kpa)}")
    for segment, (limit, kpa) in enumerate(zip(limits_kpa, pressures_kpa)):
        if not abs(kpa) <= limit + max(ROUNDING_KPA, ROUNDING_SHARE * limit):  # NaN is not, either
            raise ValueError(f"the set point of segment {segment} is {kpa} kPa; this driver's limit is {limit} kPa")


def answer(request, device, session):
    """One request. @return whether there will be more."""
    kind = request["type"]
    if kind == "hello":
        session.update(period_s=1.0 / request["rate_hz"], zero=[0.0] * request["segments"],
                       limits_kpa=device.limits_kpa(request))
        send({"type": "hello", "protocol": PROTOCOL, "driver": session["name"], "device": session["device"],
              "rate_hz": request["rate_hz"], "segments": request["segments"], "tracked": session["tracked"], "real_time": session["real_time"],
              "limit_kpa": session["limits_kpa"]})
    elif kind == "set":
        require_within(session["limits_kpa"], request["pressure_kpa"])
        session["vented"] = False
        in_force = session.get("in_force", session["zero"])
        device.set(request["pressure_kpa"])
        session["in_force"] = request["pressure_kpa"]
        send(state(request, device, in_force))  # the sample was taken before the new set points acted
    elif kind == "vent":
        device.vent()
        session.update(vented=True, in_force=session["zero"])
        send(state(request, device, session["zero"]))
    else:
        return False
    return True


def vent_for_sure(device, name):
    try:
        device.vent()
    except Exception as error:
        print(f"{name}: the device could not be told to vent ({error}); its own watchdog has to", file=sys.stderr)


def serve(device, name, description, tracked=False, real_time=True):
    """Runs until limber says goodbye, closes the driver's input or does something wrong. Vents however it ends.
    real_time is False for a simulation alone, which limber then asks as fast as it answers (--simulated)."""
    session = {"name": name, "device": description, "tracked": tracked, "real_time": real_time, "vented": True,
               "period_s": 1.0}
    lines = Lines(sys.stdin.fileno())
    heard = time.monotonic()
    try:
        while True:
            left_s = heard + SILENT_FRAMES * session["period_s"] - time.monotonic()
            line = lines.next(None if session["vented"] else max(0.0, left_s))
            if line is None:
                print(f"{name}: no request for {SILENT_FRAMES} frames: venting", file=sys.stderr)
                device.vent()
                session.update(vented=True, in_force=session["zero"])
                continue
            heard = time.monotonic()
            if not answer(json.loads(line), device, session):
                return
    except EOFError:
        pass
    except Exception as error:  # whatever the device or limber did: the arm is vented, and limber hears of it
        vent_for_sure(device, name)
        send({"type": "fault", "message": f"{type(error).__name__}: {error}"})
    finally:
        vent_for_sure(device, name)
