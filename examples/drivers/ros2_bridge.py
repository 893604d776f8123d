"""A driver that hands limber's protocol on to ROS 2: each request of limber is published as JSON in a std_msgs/String on the topic
limber/request, and your node answers with limber's state (or hello) on limber/state:

    limber collect … --driver "exec:python3 examples/drivers/ros2_bridge.py"

Your node has a driver's duties (docs/driver.md): it converts units, keeps its own limits, and vents when no request came for
three frames. This bridge vents at the end of its input and when limber is silent, by a request of its own; it can do
nothing for a node that hangs, so the device needs its watchdog all the same."""

import json
import sys
import time

from limber_driver import SILENT_FRAMES, Lines, send

REQUESTS = "limber/request"
STATES = "limber/state"
REPLY_S = 0.08
HELLO_S = 9.0  # limber waits for 10 s
VENT_SEQ = 0  # of the bridge's own requests: limber's begin at 1, so these answers are never taken for limber's


class Bridge:
    """The message logic. `topics` has publish(text) and spin(timeout_s), which calls `heard` with each text that arrives."""

    def __init__(self, topics):
        self.topics = topics
        self.texts = []
        self.period_s = 0.05
        self.moving = False

    def heard(self, text):
        self.texts.append(text)

    def vent(self):
        self.topics.publish(json.dumps({"type": "vent", "seq": VENT_SEQ, "t": 0.0}))
        self.moving = False

    def answer_to(self, request):
        """The node's answer to limber's request. TimeoutError where it does not come."""
        wanted = "hello" if request["type"] == "hello" else "state"
        deadline = time.monotonic() + (HELLO_S if wanted == "hello" else REPLY_S)
        while time.monotonic() < deadline:
            while self.texts:
                message = json.loads(self.texts.pop(0))
                if message["type"] == "fault" or (message["type"] == wanted and message.get("seq") == request.get("seq")):
                    return message
            self.topics.spin(min(0.005, max(0.0, deadline - time.monotonic())))
        raise TimeoutError(f"no {wanted} on {STATES} after a request on {REQUESTS}")

    def relay(self, line):
        """One request of limber. @return whether there will be more."""
        request = json.loads(line)
        self.texts.clear()  # answers to nobody's question
        self.topics.publish(line)
        if request["type"] == "bye":
            return False
        self.moving = request["type"] == "set"
        if request["type"] == "hello":
            self.period_s = 1.0 / request["rate_hz"]
        send(self.answer_to(request))
        return True

    def run(self, lines):
        try:
            while True:
                line = lines.next(SILENT_FRAMES * self.period_s if self.moving else None)
                if line is None:
                    self.vent()
                elif not self.relay(line):
                    return
        except EOFError:
            pass
        except Exception as error:
            self.vent()
            send({"type": "fault", "message": f"{type(error).__name__}: {error}"})
        finally:
            self.vent()


class RosTopics:
    def __init__(self, rclpy, string_type):
        self.rclpy = rclpy
        self.string_type = string_type
        self.node = rclpy.create_node("limber_bridge")
        self.publisher = self.node.create_publisher(string_type, REQUESTS, 1)

    def listen(self, heard):
        self.node.create_subscription(self.string_type, STATES, lambda message: heard(message.data), 10)

    def publish(self, text):
        self.publisher.publish(self.string_type(data=text))

    def spin(self, timeout_s):
        self.rclpy.spin_once(self.node, timeout_sec=timeout_s)


def main():
    import rclpy  # of your ROS 2 installation
    from std_msgs.msg import String

    rclpy.init()
    topics = RosTopics(rclpy, String)
    bridge = Bridge(topics)
    topics.listen(bridge.heard)
    bridge.run(Lines(sys.stdin.fileno()))
    rclpy.shutdown()


if __name__ == "__main__":
    main()
