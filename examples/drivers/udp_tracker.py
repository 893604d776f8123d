"""A bridge to motion capture: whatever tracks the arm sends one JSON object per frame to a UDP port of this computer, such as

    {"t": 12.375, "backbone": [[0.0, 0.0, 0.0], [0.047, 0.001, 0.02], …]}

with every plate's x and y in m and heading in rad, in the arm's frame, base first. A driver asks for the newest shape and hands
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
        self.backbone = None
        self.tracker_time_s = -math.inf
        self.received_s = -math.inf
        self.refused = 0

    def newest(self):
        """The newest shape, as a list of [x, y, theta]; None where there is none or it is too old."""
        while True:
            try:
                packet = self.socket.recv(65536)
            except BlockingIOError:
                break
            self.take(packet)
        return self.backbone if time.monotonic() - self.received_s <= MAX_AGE_S else None

    def take(self, packet):
        try:
            frame = json.loads(packet)
            time_s = float(frame["t"])
            backbone = [[float(number) for number in pose] for pose in frame["backbone"]]
            finite = all(math.isfinite(number) for pose in backbone for number in pose)
            if not (finite and time_s > self.tracker_time_s and all(len(pose) == 3 for pose in backbone)):
                raise ValueError
        except (ValueError, KeyError, TypeError):
            self.refused += 1
            return
        self.backbone, self.tracker_time_s, self.received_s = backbone, time_s, time.monotonic()
