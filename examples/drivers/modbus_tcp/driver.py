"""A driver for valve terminals that speak Modbus TCP, with pressures in mbar gauge in 16-bit registers, one per valve channel:

    limber collect … --driver "exec:python3 examples/drivers/modbus_tcp/driver.py 192.168.1.10 --limit-kpa 100"

Set points are holding registers from --setpoint-register on (function 16), measured pressures input registers from
--measured-register on (function 4): right 0, left 0, right 1, … Your terminal's manual has the numbers, and the name of its
watchdog: set it to vent all channels after 300 ms without a message (often "fault state" or "fail-safe"). Only the terminal
can vent when this computer does not."""

import argparse
import pathlib
import socket
import struct
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from limber_driver import serve  # noqa: E402
from units import Unit, sides_of, signed_of  # noqa: E402

REPLY_S = 0.04  # within limber's frame of 0.05 s
READ_INPUT_REGISTERS = 4
WRITE_REGISTERS = 16


class ModbusTerminal:
    def __init__(self, address, port, setpoint_register, measured_register, limit_kpa, unit):
        self.socket = socket.create_connection((address, port), timeout=3.0)
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.socket.settimeout(REPLY_S)
        self.setpoint_register = setpoint_register
        self.measured_register = measured_register
        self.limit_kpa = limit_kpa
        self.unit = unit
        self.transaction = 0
        self.segments = 0
        self.sample = (0.0, [])

    def limits_kpa(self, hello):
        self.segments = hello["segments"]
        return [self.limit_kpa] * self.segments

    def receive(self, count):
        data = b""
        while len(data) < count:
            chunk = self.socket.recv(count - len(data))
            if not chunk:
                raise ConnectionError("the terminal closed the connection")
            data += chunk
        return data

    def ask(self, function, data):
        """One Modbus request. @return the data of its reply."""
        self.transaction = (self.transaction + 1) % 65536
        body = bytes([1, function]) + data  # 1: the unit's number
        self.socket.sendall(struct.pack(">HHH", self.transaction, 0, len(body)) + body)
        transaction = None
        while transaction != self.transaction:  # others are late answers to requests before
            transaction, _, length = struct.unpack(">HHH", self.receive(6))
            reply = self.receive(length)
        if reply[1] != function:
            raise ValueError(f"the terminal refused function {function} with code {reply[2]}")
        return reply[2:]

    def write(self, sides_kpa):
        values = [min(65535, max(0, round(self.unit.from_kpa(p)))) for p in sides_kpa]
        header = struct.pack(">HHB", self.setpoint_register, len(values), 2 * len(values))
        self.ask(WRITE_REGISTERS, header + struct.pack(f">{len(values)}H", *values))
        count = 2 * self.segments
        data = self.ask(READ_INPUT_REGISTERS, struct.pack(">HH", self.measured_register, count))
        measured = struct.unpack(f">{count}h", data[1:])  # signed: a sensor at rest reads around zero
        self.sample = (time.monotonic(), signed_of([self.unit.to_kpa(value) for value in measured]))

    def set(self, pressures_kpa):
        self.write(sides_of(pressures_kpa))

    def vent(self):
        self.write([0.0] * (2 * self.segments))

    def read(self):
        return (*self.sample, None)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("address")
    parser.add_argument("--port", type=int, default=502)
    parser.add_argument("--setpoint-register", type=int, default=0)
    parser.add_argument("--measured-register", type=int, default=0)
    parser.add_argument("--limit-kpa", type=float, required=True, help="what the supply and the actuators stand")
    arguments = parser.parse_args()
    serve(ModbusTerminal(arguments.address, arguments.port, arguments.setpoint_register, arguments.measured_register,
                         arguments.limit_kpa, Unit("mbar")),
          "modbus_tcp 1", f"Modbus TCP in mbar at {arguments.address}:{arguments.port}")
