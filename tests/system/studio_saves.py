"""Starts limber studio in this folder, saves environments and a plan as its page does, and ends it. Exits with 0, or
with 3 and the studio's message where it can't save something.

    studio_saves.py --arm two_segment
"""

import http.client
import json
import re
import signal
import subprocess
import sys
import urllib.parse

from program import PROGRAM

ENVIRONMENTS = 20
ENVIRONMENT = {"schema": "limber/environment/1", "name": "wide", "obstacles": [], "start": "rest",
               "goal": {"x_m": 0.38, "y_m": 0.2, "position_tolerance_m": 0.15}}
PATIENCE_S = 120
FAULT = 3


class Refused(Exception):
    """What the studio answered."""


class Page:
    def __init__(self, address):
        where = urllib.parse.urlsplit(address)
        self.host = where.netloc
        self.headers = {"Origin": f"http://{self.host}"}
        self.headers["Cookie"] = self.answer("GET", f"/?{where.query}").getheader("Set-Cookie").split(";")[0]
        self.events = self.answer("GET", "/api/events")

    def answer(self, method, path, body=None):
        connection = http.client.HTTPConnection(self.host, timeout=PATIENCE_S)
        headers = {**self.headers, **({"Content-Type": "application/json"} if body else {})}
        connection.request(method, path, json.dumps(body) if body else None, headers)
        return connection.getresponse()

    def post(self, path, body):
        answer = self.answer("POST", path, body)
        text = answer.read().decode("utf-8")
        if answer.status != 200:
            raise Refused(text)

    def wait_for(self, pattern):
        """The first match in the lines of the page's events."""
        for line in self.events:
            found = re.search(pattern, line.decode("utf-8"))
            if found:
                return found
        raise Refused("the studio ended")


def save_all(page, arm):
    tab = page.wait_for('"id":"([0-9a-f]+)"').group(1)
    scene = {"tab": tab, "arm": f"limber:{arm}", "environment": ENVIRONMENT, "overwrite": True}
    for k in range(ENVIRONMENTS):
        page.post("/api/environment", {**scene, "name": f"e{k:02d}"})
    page.post("/api/plan", {**scene, "request": 1, "model": "", "time_limit_s": 20.0, "limit_scale": 1.0, "seed": 1,
                            "tree": False, "margin_m": None})
    page.wait_for("^event: plan")
    page.post("/api/plan/save", {**scene, "name": "p"})


def main():
    arm = sys.argv[sys.argv.index("--arm") + 1]
    studio = subprocess.Popen([PROGRAM, "studio", "--project", ".", "--port", "0", "--arm", arm],
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, encoding="utf-8")
    try:
        save_all(Page(studio.stdout.readline().strip()), arm)
    except (Refused, ConnectionError) as refused:
        print(f"error: {refused}", file=sys.stderr)
        return FAULT
    finally:
        studio.send_signal(signal.SIGINT)
        ended = studio.wait(timeout=PATIENCE_S)
    return 0 if ended == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
