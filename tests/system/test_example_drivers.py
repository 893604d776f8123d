"""The reference drivers in examples/drivers against simulated devices: a board behind a pseudo-terminal, a Modbus server
and a tracker on local sockets, a stub of ROS 2's topics. Units are checked against laws."""

import contextlib
import io
import json
import os
import socket
import struct
import subprocess
import sys
import threading
import time
import tty
import unittest

from program import ROOT, InFolder

DRIVERS = ROOT / "examples" / "drivers"
sys.path.insert(0, str(DRIVERS))

from limber_driver import Lines, state  # noqa: E402
from ros2_bridge import Bridge  # noqa: E402
from udp_tracker import UdpTracker  # noqa: E402
from units import AMBIENT_KPA, KPA_PER, Counts, Unit, sides_of, signed_of  # noqa: E402


class SimulatedBoard(threading.Thread):
    """What board.ino does, for two segments: first-order pressures, a clock in ms, and the watchdog of 300 ms."""

    SILENCE_S = 0.3
    TIME_CONSTANT_S = 0.08

    def __init__(self, channels=4):
        super().__init__(daemon=True)
        self.channels = channels
        self.deaf_s = 0.0  # vents only so long after the last set points, and by itself never
        self.master, slave = os.openpty()
        tty.setraw(self.master)
        self.port = os.ttyname(slave)
        self.keep_open = slave
        self.setpoints = [0.0] * channels
        self.pressures = [0.0] * channels
        self.set_s = 0.0
        self.heard = []  # (time, line)
        self.vents = []  # (time, why)
        self.silent = False
        self.stopped = False
        self.start_s = self.last_s = time.monotonic()
        self.last_line_s = 0.0
        self.vented = True

    def run(self):
        os.set_blocking(self.master, False)
        buffer = b""
        while not self.stopped:
            time.sleep(0.002)
            self.move()
            try:
                buffer += os.read(self.master, 4096)
            except BlockingIOError:
                pass
            while b"\n" in buffer:
                line, _, buffer = buffer.partition(b"\n")
                self.take(line.decode("ascii"))
            if not self.vented and not self.deaf_s and time.monotonic() - self.last_line_s > self.SILENCE_S:
                self.vent("silence")

    def move(self):
        now = time.monotonic()
        share = min(1.0, (now - self.last_s) / self.TIME_CONSTANT_S)
        self.last_s = now
        self.pressures = [p + share * (s - p) for p, s in zip(self.pressures, self.setpoints)]

    def take(self, line):
        self.last_line_s = time.monotonic()
        self.heard.append((self.last_line_s, line))
        words = line.split()
        if words[0] == "S" and len(words) == 1 + self.channels:
            self.setpoints = [float(w) for w in words[1:]]
            self.vented, self.set_s = False, self.last_line_s
        elif self.last_line_s - self.set_s >= self.deaf_s:
            self.vent("command")
        if not self.silent:
            clock_ms = int(1000 * (time.monotonic() - self.start_s))
            reply = f"P {clock_ms} " + " ".join(f"{p:.1f}" for p in self.pressures) + "\n"
            os.write(self.master, reply.encode("ascii"))

    def vent(self, why):
        self.setpoints = [0.0] * self.channels
        if not self.vented:
            self.vents.append((time.monotonic(), why))
        self.vented = True


class SerialText(InFolder):
    def setUp(self):
        super().setUp()
        self.board = SimulatedBoard()
        self.board.start()
        self.addCleanup(setattr, self.board, "stopped", True)

    def driver(self, *flags):
        words = [sys.executable, DRIVERS / "serial_text" / "driver.py", self.board.port, "--limit-kpa", 100, *flags]
        return [str(word) for word in words]

    def collect(self, *arguments, code=0):
        command = "exec:" + " ".join(f"'{word}'" for word in self.driver())
        return self.run_limber("execute", "--arm", "two_segment", *arguments, "--driver", command, code=code)

    def plan(self):
        goal = {"x_m": 0.38, "y_m": 0.2, "position_tolerance_m": 0.03}
        self.write("e.yaml", json.dumps({
            "schema": "limber/environment/1", "name": "e", "obstacles": [], "start": "rest", "goal": goal,
        }))
        self.run_limber("plan", "--arm", "two_segment", "--no-load", "--max-iterations", 300, "--environment", "e.yaml",
                        "--out", "p.json")

    def talk(self, *requests, wait_s=0.0, kill=False):
        """Speaks to the driver without limber. @return what it answered."""
        process = subprocess.Popen(self.driver(), stdin=subprocess.PIPE, stdout=subprocess.PIPE, encoding="utf-8")
        answers = []
        for request in requests:
            process.stdin.write(json.dumps(request) + "\n")
            process.stdin.flush()
            answers.append(json.loads(process.stdout.readline()))
        if kill:
            process.kill()
        time.sleep(wait_s)
        self.heard_by_then = len(self.board.vents)
        process.stdin.close()
        process.wait(timeout=10)
        process.stdout.close()
        return answers

    HELLO = {"type": "hello", "protocol": 1, "arm": "two_segment", "segments": 2, "points": 11, "rate_hz": 20.0}
    SET = {"type": "set", "seq": 5, "t": 0.0, "pressure_kpa": [12.5, -30.0]}

    def test_a_plan_reaches_the_board_in_its_own_units(self):
        self.plan()
        self.collect("--plan", "p.json", "--environment", "e.yaml", "--out", "run.h5", code=1)  # nothing tracks it
        plan = json.loads((self.folder / "p.json").read_text())
        sent = [[float(w) for w in line.split()[1:]] for _, line in self.board.heard if line.startswith("S")]
        for frame, mbar in zip(plan["frames"][1:], sent):
            for side, expected in zip(mbar, sides_of(frame["setpoint_kpa"])):
                self.assertAlmostEqual(side, 10.0 * expected, delta=0.51)
        self.assertEqual(self.board.heard[-1][1], "V")
        self.assertLess(max(self.board.pressures), 20.0)  # [mbar]

    def test_states_carry_the_set_point_that_was_in_force(self):
        first, second = self.talk(self.HELLO, self.SET, {**self.SET, "seq": 6})[1:]
        self.assertEqual((first["seq"], first["setpoint_kpa"]), (5, [0.0, 0.0]))
        self.assertEqual((second["seq"], second["setpoint_kpa"]), (6, [12.5, -30.0]))
        self.assertGreater(second["t"], first["t"] - 0.001)

    def test_a_check_tells_a_deadman_by_a_board_that_outlives_its_driver(self):
        self.write("one.yaml", json.dumps({
            "schema": "limber/arm/1", "name": "one", "frame_rate_hz": 20, "pressure_rate_limit_kpa_per_s": 200,
            "actuator_radius_m": 0.006, "segments": [{"length_m": 0.2, "width_m": 0.05, "gaps": 2,
                                                      "pressure_limit_kpa": 100, "strain_polynomial": []}],
        }))
        for deaf_s, verdict in ((0.0, True), (1.5, False)):
            self.board = SimulatedBoard(channels=2)
            self.board.SILENCE_S = 5.0  # what vents is the driver
            self.board.deaf_s = deaf_s
            self.board.start()
            self.addCleanup(setattr, self.board, "stopped", True)
            command = "exec:" + " ".join(f"'{word}'" for word in self.driver())
            for _ in range(5):  # a busy machine is late, which is a fault and no verdict
                result = self.run_limber("driver", "check", "--arm", "one.yaml", "--driver", command, "--out", "checked",
                                         "--force", "--json", code=None)
                if result.returncode != 3:
                    break
            self.assertIn(result.returncode, (0, 1), result.stderr)
            found = json.loads(result.stdout)
            self.assertEqual(found["deadmen"]["end_of_input"]["vented"], verdict, result.stdout + result.stderr)
            self.assertFalse(found["deadmen"]["end_of_input"]["starts_vented"])

    def test_the_driver_vents_without_requests_and_at_the_end_of_its_input(self):
        self.talk(self.HELLO, self.SET, wait_s=0.28)
        self.assertEqual(self.heard_by_then, 1)  # three frames of 0.05 s
        self.assertEqual(self.board.vents[0][1], "command")
        self.board.vents.clear()
        self.talk(self.HELLO, self.SET)
        self.assertEqual([why for _, why in self.board.vents], ["command"])

    def test_the_board_vents_when_the_driver_is_killed(self):
        self.talk(self.HELLO, self.SET, kill=True, wait_s=0.6)
        self.assertEqual([why for _, why in self.board.vents], ["silence"])

    def test_a_silent_board_is_a_fault(self):
        self.plan()
        self.board.silent = True
        result = self.collect("--plan", "p.json", "--environment", "e.yaml", "--out", "run.h5", code=3)
        self.assertIn("the board did not answer 'V'", result.stderr)

    def test_a_set_point_beyond_its_limit_is_a_fault_and_never_reaches_the_board(self):
        for pressures, message in (([12.5, -100.1], "segment 1 is -100.1 kPa; this driver's limit is 100.0 kPa"),
                                   ([float("nan"), 0.0], "segment 0 is nan kPa"), ([12.5], "1 set points; expected 2")):
            answer = self.talk(self.HELLO, {**self.SET, "pressure_kpa": pressures})[1]
            self.assertEqual(answer["type"], "fault")
            self.assertIn(message, answer["message"])
        self.assertFalse([line for _, line in self.board.heard if line.startswith("S")])
        rounded = self.talk(self.HELLO, {**self.SET, "pressure_kpa": [100.0005, -100.0]})[1]
        self.assertEqual(rounded["type"], "state")

    def test_another_arms_board_is_refused(self):
        answer = self.talk({**self.HELLO, "segments": 3})[0]
        self.assertEqual(answer["type"], "fault")
        self.assertIn("the board has 4 channels; the arm needs 6", answer["message"])


class SimulatedTerminal(threading.Thread):
    """A Modbus TCP server with four holding registers that the input registers follow at once."""

    def __init__(self):
        super().__init__(daemon=True)
        self.server = socket.create_server(("127.0.0.1", 0))
        self.port = self.server.getsockname()[1]
        self.registers = [0] * 4
        self.written = []
        self.refuses = False

    def run(self):
        connection, _ = self.server.accept()
        with self.server, connection:
            while header := connection.recv(6, socket.MSG_WAITALL):
                transaction, _, length = struct.unpack(">HHH", header)
                unit, function, *data = connection.recv(length, socket.MSG_WAITALL)
                body = bytes([unit, *self.answer(function, bytes(data))])
                connection.sendall(struct.pack(">HHH", transaction, 0, len(body)) + body)

    def answer(self, function, data):
        if self.refuses:
            return bytes([function | 0x80, 2])
        if function == 16:
            first, count, _ = struct.unpack(">HHB", data[:5])
            self.registers[first:first + count] = struct.unpack(f">{count}H", data[5:])
            self.written.append(list(self.registers))
            return bytes([function]) + data[:4]
        first, count = struct.unpack(">HH", data)
        values = self.registers[first:first + count]
        return bytes([function, 2 * count]) + struct.pack(f">{count}h", *values)


class ModbusTcp(InFolder):
    def talk(self, *requests):
        terminal = SimulatedTerminal()
        terminal.start()
        terminal.refuses = self.refuses
        process = subprocess.Popen(
            [sys.executable, str(DRIVERS / "modbus_tcp" / "driver.py"), "127.0.0.1", "--port", str(terminal.port),
             "--limit-kpa", "80"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
            encoding="utf-8")
        answers = []
        for request in requests:
            process.stdin.write(json.dumps(request) + "\n")
            process.stdin.flush()
            answers.append(json.loads(process.stdout.readline()))
        process.stdin.close()
        process.wait(timeout=10)
        process.stdout.close()
        return terminal, answers

    refuses = False

    def test_set_points_are_registers_in_mbar(self):
        terminal, answers = self.talk(SerialText.HELLO, SerialText.SET)
        self.assertEqual(answers[0]["limit_kpa"], [80, 80])
        self.assertIn([125, 0, 0, 300], terminal.written)
        self.assertEqual(answers[1]["pressure_kpa"], [12.5, -30.0])
        self.assertEqual(terminal.written[-1], [0, 0, 0, 0])  # vented at the end of its input

    def test_a_set_point_beyond_its_limit_reaches_no_register(self):
        terminal, answers = self.talk(SerialText.HELLO, {**SerialText.SET, "pressure_kpa": [80.1, 0.0]})
        self.assertEqual(answers[1]["type"], "fault")
        self.assertTrue(terminal.written)
        self.assertFalse(any(any(registers) for registers in terminal.written))

    def test_a_terminal_that_refuses_is_a_fault(self):
        self.refuses = True
        _, answers = self.talk(SerialText.HELLO, SerialText.SET)
        self.assertEqual(answers[1]["type"], "fault")
        self.assertIn("refused function 16 with code 2", answers[1]["message"])


class Tracker(unittest.TestCase):
    def setUp(self):
        self.tracker = UdpTracker(0)
        self.addCleanup(self.tracker.socket.close)
        self.sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.addCleanup(self.sender.close)

    def send(self, text):
        self.sender.sendto(text.encode("utf-8"), self.tracker.socket.getsockname())
        time.sleep(0.005)

    def test_the_newest_shape_counts(self):
        self.assertIsNone(self.tracker.newest())
        self.send('{"t": 1.0, "backbone": [[0, 0, 0], [0.1, 0, 0]]}')
        self.send('{"t": 1.1, "backbone": [[0, 0, 0], [0.1, 0.01, 0.2]]}')
        self.assertEqual(self.tracker.newest()[1], [0.1, 0.01, 0.2])

    def test_bodies_in_3d_are_shapes_too(self):
        self.send('{"t": 1.0, "bodies": [[1, 2, 3, 0, 0, 0, 1], [1, 2, 4, 0, 0, 0, 1]]}')
        shape = self.tracker.newest()
        self.assertEqual(shape[1], [1, 2, 4, 0, 0, 0, 1])
        self.tracker.take('{"t": 1.1, "bodies": [[1, 2, 3]]}')
        self.assertEqual(self.tracker.refused, 1)

        class Device:
            def read(self):
                return 0.5, [1.0], shape
        said = state({"seq": 3}, Device(), [0.0])
        self.assertEqual(said["bodies"], shape)
        self.assertNotIn("backbone", said)

    def test_old_broken_and_disordered_shapes_are_left_out(self):
        self.send('{"t": 2.0, "backbone": [[0, 0, 0], [0.1, 0, 0]]}')
        for text in ("", "{", "[]", '{"t": 3}', '{"t": 3, "backbone": [[0, 0]]}', '{"t": 3, "backbone": [[0, 0, NaN]]}',
                     '{"t": 1.5, "backbone": [[9, 9, 9]]}', '{"t": "x", "backbone": []}'):
            self.send(text)
        self.assertEqual(self.tracker.newest(), [[0, 0, 0], [0.1, 0, 0]])
        self.assertEqual(self.tracker.refused, 8)
        time.sleep(0.06)
        self.assertIsNone(self.tracker.newest())


class NodeStub:
    """Stands for the topics and for a node behind them, which answers by `answers(request)`, a list of messages."""

    def __init__(self, answers):
        self.answers = answers
        self.published = []
        self.waiting = []
        self.heard = None

    def publish(self, text):
        request = json.loads(text)
        self.published.append(request)
        self.waiting += self.answers(request)

    def spin(self, timeout_s):
        if self.waiting:
            self.heard(json.dumps(self.waiting.pop(0)))
        else:
            time.sleep(timeout_s)


class RosBridge(unittest.TestCase):
    def run_bridge(self, answers, *requests, silence_s=0.0):
        """@return (the stub, what limber was told)"""
        stub = NodeStub(answers)
        bridge = Bridge(stub)
        stub.heard = bridge.heard
        read_end, write_end = os.pipe()
        for request in requests:
            os.write(write_end, (json.dumps(request) + "\n").encode("utf-8"))
        threading.Timer(silence_s, os.close, [write_end]).start()
        with contextlib.redirect_stdout(io.StringIO()) as told:
            bridge.run(Lines(read_end))
        os.close(read_end)
        return stub, [json.loads(line) for line in told.getvalue().splitlines()]

    @staticmethod
    def healthy(request):
        if request["type"] == "hello":
            return [{"type": "hello", "protocol": 1, "rate_hz": 20.0, "segments": 2}]
        if request["type"] == "bye":
            return []
        return [{"type": "state", "seq": request["seq"] - 1}, {"type": "state", "seq": request["seq"], "t": 1.0}]

    def test_requests_and_their_own_answers_pass(self):
        stub, told = self.run_bridge(self.healthy, SerialText.HELLO, SerialText.SET, {"type": "bye"})
        self.assertEqual([m["type"] for m in stub.published], ["hello", "set", "bye", "vent"])
        self.assertEqual([(m["type"], m.get("seq")) for m in told], [("hello", None), ("state", 5)])

    def test_vents_in_silence_and_at_the_end_of_input(self):
        stub, _ = self.run_bridge(self.healthy, SerialText.HELLO, SerialText.SET, silence_s=0.4)
        self.assertEqual([m["type"] for m in stub.published], ["hello", "set", "vent", "vent"])

    def test_a_silent_node_is_a_fault_and_vented(self):
        stub, told = self.run_bridge(lambda r: self.healthy(r) if r["type"] == "hello" else [], SerialText.HELLO,
                                     SerialText.SET)
        self.assertEqual(told[-1]["type"], "fault")
        self.assertIn("no state on limber/state", told[-1]["message"])
        self.assertEqual(stub.published[-1]["type"], "vent")


class Units(unittest.TestCase):
    def test_every_unit_survives_the_way_there_and_back(self):
        for name in KPA_PER:
            for absolute in (False, True):
                unit = Unit(name, absolute)
                for kpa in (-20.0, 0.0, 37.5, 400.0):
                    self.assertAlmostEqual(unit.to_kpa(unit.from_kpa(kpa)), kpa, places=9)

    def test_known_values(self):
        self.assertAlmostEqual(Unit("psi").to_kpa(14.5037738), 100.0, places=5)
        self.assertAlmostEqual(Unit("mbar").from_kpa(25.0), 250.0)
        self.assertAlmostEqual(Unit("mbar", absolute=True).to_kpa(1013.25), 0.0)
        self.assertAlmostEqual(Unit("bar", absolute=True, ambient_kpa=95.0).from_kpa(5.0), 1.0)
        self.assertAlmostEqual(Unit("atm", absolute=True).to_kpa(2.0), AMBIENT_KPA)
        with self.assertRaisesRegex(ValueError, "torr"):
            Unit("torr")

    def test_counts_are_linear_between_their_two_points(self):
        counts = Counts((102, 0.0), (920, 200.0))
        self.assertEqual(counts.from_kpa(0.0), 102)
        self.assertEqual(counts.from_kpa(200.0), 920)
        self.assertAlmostEqual(counts.to_kpa(511), 100.0)
        falling = Counts((1000, 0.0), (0, 100.0))
        self.assertEqual(falling.from_kpa(25.0), 750)
        with self.assertRaises(ValueError):
            Counts((5, 0.0), (5, 10.0))

    def test_sides_and_signs_are_each_others_way_back(self):
        signed = [30.0, -12.0, 0.0]
        self.assertEqual(sides_of(signed), [30.0, 0.0, 0.0, 12.0, 0.0, 0.0])
        self.assertEqual(signed_of(sides_of(signed)), signed)
        with self.assertRaisesRegex(ValueError, "3 channels"):
            signed_of([1.0, 2.0, 3.0])


if __name__ == "__main__":
    unittest.main()
