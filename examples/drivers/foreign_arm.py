"""A driver of an arm that is simulated in this file, to try docs/first_day.md on before there is an arm:

    limber driver calibrate --arm arms/two_segment.yaml --driver "exec:python3 examples/drivers/foreign_arm.py" …

It is not limber's virtual arm, and knows nothing of it: two segments of constant curvature with play, first-order valves, and a
tracker of markers. And its wire is as wires are: valve channel 0 is segment 1's, with left and right swapped; the sensors come in
another order than the valves and are off zero; the tracker sends mm and degrees, counts turns clockwise, and stands anywhere.
With --fast it simulates as fast as it is asked, for limber's --simulated."""

import argparse
import math
import random
import time

from limber_driver import serve

LENGTH_M, GAPS = 0.235, 5  # of each segment
LIMIT_KPA = 100.0
VALVE_S, BENDING_S = 0.06, 0.05  # time constants
FULL_TURN_RAD, PLAY_RAD = 1.1, 0.02
FULL_CONTRACTION = 0.05
STEP_S = 0.005
VALVES = [(1, 1.0), (0, -1.0)]  # each channel's segment, and its sign
SENSORS = [(0, -1.0, 0.4), (1, 1.0, -0.3)]  # the same, and what the sensor reads when vented, kPa
BASE_MM, BASE_RAD = (812.0, -133.0), 0.7  # where the arm's base lies in the tracker's frame, seen in its mirror
MARKER_M = (0.01, 0.02)  # of each marker body on its plate
NOISE_MM = 0.1


class Segment:
    def __init__(self):
        self.told_kpa = self.kpa = self.turn_rad = self.bent_rad = 0.0

    def step(self):
        self.kpa += STEP_S / VALVE_S * (self.told_kpa - self.kpa)
        wanted = -FULL_TURN_RAD * self.kpa / LIMIT_KPA  # a positive pressure bends to the right
        self.turn_rad = min(max(self.turn_rad, wanted - PLAY_RAD), wanted + PLAY_RAD)
        self.bent_rad += STEP_S / BENDING_S * (self.turn_rad - self.bent_rad)

    def gap(self):
        """(length, turn) from plate to plate."""
        length = LENGTH_M * (1.0 - FULL_CONTRACTION * abs(self.kpa) / LIMIT_KPA)
        return length / GAPS, self.bent_rad / GAPS


class ForeignArm:
    def __init__(self, fast):
        self.fast = fast
        self.segments = [Segment() for _ in VALVES]
        self.noise = random.Random(7)
        self.start_s = time.monotonic()
        self.time_s = 0.0
        self.sample = None

    def limits_kpa(self, hello):
        if hello["segments"] != len(self.segments):
            raise ValueError(f"this arm has {len(self.segments)} segments; limber's file has {hello['segments']}")
        self.period_s = 1.0 / hello["rate_hz"]
        return [LIMIT_KPA] * len(self.segments)

    def take_sample(self):
        until_s = self.time_s + self.period_s if self.fast else time.monotonic() - self.start_s
        while self.time_s + STEP_S <= until_s + 1e-9:
            self.time_s += STEP_S
            for segment in self.segments:
                segment.step()
        if not self.fast:  # requests may come closer together than steps; samples have a time of their own
            until_s = max(until_s, self.time_s)
        pressures = [zero + sign * self.segments[s].kpa for s, sign, zero in SENSORS]
        self.sample = (until_s, pressures, self.bodies())

    def set(self, pressures_kpa):
        self.take_sample()
        for (s, sign), kpa in zip(VALVES, pressures_kpa):
            self.segments[s].told_kpa = sign * kpa

    def vent(self):
        self.take_sample()
        for segment in self.segments:
            segment.told_kpa = 0.0

    def read(self):
        return self.sample

    def bodies(self):
        x = y = theta = 0.0
        poses = [(x, y, theta)]
        for segment in self.segments:
            length, turn = segment.gap()
            chord = length if abs(turn) < 1e-9 else length * math.sin(turn / 2) / (turn / 2)
            for _ in range(GAPS):
                x += chord * math.cos(theta + turn / 2)
                y += chord * math.sin(theta + turn / 2)
                theta += turn
                poses.append((x, y, theta))
        return [self.on_wire(*pose) for pose in poses]

    def on_wire(self, x, y, theta):
        """A plate's marker body as the tracker says it: mm and degrees, mirrored."""
        c, s = math.cos(theta), math.sin(theta)
        body = (x + c * MARKER_M[0] - s * MARKER_M[1], y + s * MARKER_M[0] + c * MARKER_M[1])
        c, s = math.cos(BASE_RAD), math.sin(BASE_RAD)
        noisy = [1000.0 * value + self.noise.gauss(0.0, NOISE_MM) for value in body]
        across = c * noisy[0] - s * noisy[1] + BASE_MM[0]
        up = s * noisy[0] + c * noisy[1] + BASE_MM[1]
        return [across, -up, -math.degrees(theta + BASE_RAD)]


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fast", action="store_true", help="simulate as fast as limber asks (limber … --simulated)")
    arguments = parser.parse_args()
    serve(ForeignArm(arguments.fast), "foreign_arm 1", "a simulation of its own", tracked=True,
          real_time=not arguments.fast)
