"""A bridge to motion capture: whatever tracks the arm sends one JSON object per frame to a UDP port of this computer, such as

    {"t": 12.375, "backbone": [[0.0, 0.0, 0.0], [0.047, 0.001, 0.02], …]}

with every plate's x and y in m and heading in rad, in the arm's frame, base first; or, from a tracker that sees in 3D, "bodies" in
its place, with [x, y, z, qx, qy, qz, qw] of every plate's marker body in the tracker's own frame. A driver asks for the newest shape and hands
it to limber with its pressures. Shapes that are old, broken or out of order are left out: limber bridges short gaps and marks
them, and a wrong shape would be worse than none."""

import json
import math
import socket
import time

MAX_AGE_S = 0.05  # a frame of 20 Hz: an older shape is no measurement of this one


class UdpTracker:
    def __init__(self, port, address="127.0.0.1"):
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind((address, port))
        self.socket.setblocking(False)
        self.shape = None
        self.tracker_time_s = -math.inf
        self.received_s = -math.inf
        self.refused = 0

    def newest(self):
        """The newest shape, a list of poses with 3 or 7 numbers each; None where there is none or it is too old."""
        while True:
            try:
                packet = self.socket.recv(65536)
            except BlockingIOError:
                break
            self.take(packet)
        return self.shape if time.monotonic() - self.received_s <= MAX_AGE_S else None

    def take(self, packet):
        try:
            frame = json.loads(packet)
            time_s = float(frame["t"])
            key, numbers = ("bodies", 7) if "bodies" in frame else ("backbone", 3)
            shape = [[float(number) for number in pose] for pose in frame[key]]
            finite = all(math.isfinite(number) for pose in shape for number in pose)
            if not (finite and time_s > self.tracker_time_s and all(len(pose) == numbers for pose in shape)):
                raise ValueError
        except (ValueError, KeyError, TypeError):
            self.refused += 1
            return
        self.shape, self.tracker_time_s, self.received_s = shape, time_s, time.monotonic()
