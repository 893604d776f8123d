"""A driver of a simulated arm that logs what it is told, for test_driver.py.

    logging_driver.py LOG [real_time]
"""

import sys
import time

import limber
import limber.driver


class LoggingDriver(limber.driver.Driver):
    name = "logging_driver 1"
    device = "a file"
    rate_hz = 20.0
    segment_count = 2
    limit_kpa = (100.0, 80.0)
    real_time = False

    def __init__(self, log, real_time=False):
        self.real_time = real_time
        self.log = open(log, "a", encoding="utf-8", buffering=1)
        self.arm = limber.VirtualArm(
            limber.load_arm(limber.data_folder() / "arms" / "two_segment.yaml"))

    def command(self, setpoint_kpa):
        print("set", *setpoint_kpa.tolist())  # must not reach the protocol
        self.log.write(f"set {setpoint_kpa.tolist()} {time.monotonic()}\n")
        if setpoint_kpa[0] == 13.0:
            raise OSError("valve 0 is hot")
        state = self.arm.command(setpoint_kpa)
        return limber.ArmState(state.time_s, state.pressure_kpa, state.backbone, setpoint_kpa,
                               tracker_t=state.time_s + 100.0)

    def vent(self):
        self.log.write(f"vent {time.monotonic()}\n")
        self.arm.vent()
        return self.arm.command([0.0, 0.0])  # a frame later, as a device's newest sample is


if __name__ == "__main__":
    limber.driver.serve(LoggingDriver(sys.argv[1], "real_time" in sys.argv[2:]))
