"""A driver for boards that speak text over a serial line, as Arduino sketches do (board.ino beside this file is one):

    limber collect … --driver "exec:python3 examples/drivers/serial_text/driver.py /dev/ttyACM0 --limit-kpa 100"

Host to board, a line each:   S 0 250 0 0 1000 0    pressures in mbar gauge, one per valve channel: right 0, left 0, right 1, …
                              V                     open every vent valve
Board to host, to each line:  P 12345 0 248 …       its clock in ms, then the measured pressures in mbar

With --tracker-port, shapes come from a tracker as ../udp_tracker.py says. The board vents by itself when no line came for 300 ms: that is the deadman which works when this program does not."""

import argparse
import os
import pathlib
import sys
import termios
import tty

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from limber_driver import Lines, serve  # noqa: E402
from udp_tracker import UdpTracker  # noqa: E402
from units import Unit, sides_of, signed_of  # noqa: E402

REPLY_S = 0.04  # within limber's frame of 0.05 s
RESET_S = 3.0  # many boards restart when their port is opened


class SerialBoard:
    def __init__(self, port, limit_kpa, unit, tracker=None):
        self.port = os.open(port, os.O_RDWR | os.O_NOCTTY)
        tty.setraw(self.port)
        attributes = termios.tcgetattr(self.port)
        attributes[4] = attributes[5] = termios.B115200
        termios.tcsetattr(self.port, termios.TCSANOW, attributes)
        self.lines = Lines(self.port)
        self.limit_kpa = limit_kpa
        self.unit = unit
        self.tracker = tracker
        self.time_s = 0.0
        self.pressures_kpa = []

    def limits_kpa(self, hello):
        self.ask("V", RESET_S)
        if len(self.pressures_kpa) != hello["segments"]:
            raise ValueError(f"the board has {2 * len(self.pressures_kpa)} channels; the arm needs {2 * hello['segments']}")
        return [self.limit_kpa] * hello["segments"]

    def ask(self, line, timeout_s=REPLY_S):
        os.write(self.port, (line + "\n").encode("ascii"))
        reply = self.lines.next(timeout_s)
        if reply is None:
            raise TimeoutError(f"the board did not answer '{line}' within {timeout_s} s")
        word, clock_ms, *pressures = reply.split()
        if word != "P":
            raise ValueError(f"the board answered '{reply}' to '{line}'")
        self.time_s = int(clock_ms) / 1000.0
        self.pressures_kpa = signed_of([self.unit.to_kpa(float(p)) for p in pressures])

    def set(self, pressures_kpa):
        self.ask("S " + " ".join(f"{self.unit.from_kpa(p):.0f}" for p in sides_of(pressures_kpa)))

    def vent(self):
        self.ask("V")

    def read(self):
        return self.time_s, self.pressures_kpa, self.tracker.newest() if self.tracker else None


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("port")
    parser.add_argument("--limit-kpa", type=float, required=True, help="what the supply and the actuators stand")
    parser.add_argument("--tracker-port", type=int, help="UDP port of this computer that shapes are sent to")
    arguments = parser.parse_args()
    tracker = UdpTracker(arguments.tracker_port) if arguments.tracker_port else None
    serve(SerialBoard(arguments.port, arguments.limit_kpa, Unit("mbar"), tracker), "serial_text 1",
          f"text in mbar over {arguments.port}", tracked=tracker is not None)
