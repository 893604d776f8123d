"""Figures of docs/python.md: rates from Python beside the same loop in C++, overhead of one query,
time to import, threads beside each other, and how soon Ctrl-C ends a plan. Rates and the import are
in processor time, the best of several stretches; the others are wall times, and want a machine that
does nothing else.

    PYTHONPATH=build/release/python benchmarks/python_figures.py build/release/bin/limber
"""

import argparse
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time

import numpy as np

import limber

BATCHES = (256, 1024, 4096)
QUERIES = 4096  # of a pass, all different
STRETCHES = 30  # Python and C++ in turns; the best of each counts, as the machine may be busy
REPEATS = 5


def queries(arm, count):
    random = np.random.default_rng(1)
    limits = arm.pressure_limits_kpa
    before, after, earlier = (
        random.uniform(-limits, limits, (count, len(limits))).astype(np.float32) for _ in range(3))
    return before, after, limber.NoLoadModel(arm).backbone(earlier)


def best_seconds(one_pass, cpp_pass):
    """Processor time of a pass, the best stretch from Python and the best in C++."""
    own, theirs = [], []
    for _ in range(STRETCHES):
        theirs.append(cpp_pass())
        begin = time.thread_time()
        one_pass()
        own.append(time.thread_time() - begin)
    return min(own), min(theirs)


def speed(arm, model):
    """Queries per second of processor time in batches, and what one query takes more than in C++."""
    arrays = (*queries(arm, QUERIES), np.empty((QUERIES, arm.point_count, 3), np.float32))
    found = {"batches": {}}

    def cpp(size):
        return lambda: limber._limber._pass_s(model, *arrays, size)
    for size in BATCHES:
        parts = [tuple(array[k:k + size] for array in arrays) for k in range(0, QUERIES, size)]
        own, theirs = best_seconds(lambda: [model.step_batch(*part) for part in parts], cpp(size))
        found["batches"][size] = {"python_per_s": QUERIES / own, "cpp_per_s": QUERIES / theirs,
                                  "share": theirs / own}
    ones = [tuple(array[k] for array in arrays) for k in range(QUERIES)]

    def one_by_one():
        for one in ones:
            model.step(*one)
    own, theirs = best_seconds(one_by_one, cpp(0))
    found["one_query"] = {"python_us": 1e6 * own / QUERIES, "cpp_us": 1e6 * theirs / QUERIES,
                          "more_us": 1e6 * (own - theirs) / QUERIES}
    return found


def import_time():
    """Processor time of a fresh Python, less that of one that does nothing."""
    def seconds(code):
        times = []
        for _ in range(REPEATS):
            before = os.times()
            subprocess.run([sys.executable, "-c", code], check=True)
            after = os.times()
            times.append(after.children_user + after.children_system - before.children_user
                         - before.children_system)
        return min(times)
    bare, numpy, whole = seconds("pass"), seconds("import numpy"), seconds("import limber")
    return {"import_s": whole - bare, "import_numpy_s": numpy - bare}


def threads(problem):
    """Two threads that plan beside each other, and a third that ticks every millisecond."""
    limits = limber.PlannerLimits(queries=200_000)

    def plan():
        limber.make_planner("paper", jobs=1).plan(problem, limits, 1)

    def timed(count):
        workers = [threading.Thread(target=plan) for _ in range(count)]
        begin = time.perf_counter()
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        return time.perf_counter() - begin
    late, ended = [], threading.Event()

    def tick():
        while not ended.is_set():
            before = time.perf_counter()
            time.sleep(0.001)
            late.append(time.perf_counter() - before - 0.001)
    one = min(timed(1) for _ in range(3))
    two = min(timed(2) for _ in range(3))
    ticker = threading.Thread(target=tick)
    ticker.start()
    timed(2)
    ended.set()
    ticker.join()
    return {"one_s": one, "two_s": two, "ratio": two / one, "ticker_late_s": max(late),
            "ticker_late_99_s": float(np.quantile(late, 0.99))}


def interrupt(problem):
    seconds = []
    for _ in range(REPEATS):
        sent = []

        def send():
            sent.append(time.perf_counter())
            os.kill(os.getpid(), signal.SIGINT)
        threading.Timer(0.3, send).start()
        try:
            limber.make_planner().plan(problem, limber.PlannerLimits(iterations=10**9), 1)
        except KeyboardInterrupt:
            seconds.append(time.perf_counter() - sent[0])
    return max(seconds)


def small_network(program, arm_file):
    with tempfile.TemporaryDirectory() as folder:
        recording, model_file = f"{folder}/train.h5", f"{folder}/model.safetensors"
        for command in (["collect", "--arm", arm_file, "--schedule", "random", "--count", "20",
                         "--out", recording],
                        ["train", "--arm", arm_file, "--preset", "paper", "--data", recording,
                         "--epochs", "2", "--out", model_file]):
            subprocess.run([program, *map(str, command), "--quiet"], check=True,
                           stdout=subprocess.DEVNULL)
        return limber.read_model(model_file)


def print_text(found):
    for size, rates in found["batches"].items():
        print(f"batch of {size}: {rates['python_per_s']:,.0f} queries per second in Python, "
              f"{rates['cpp_per_s']:,.0f} in C++: {100 * rates['share']:.0f} %")
    one, beside = found["one_query"], found["threads"]
    print(f"one query: {one['python_us']:.2f} us in Python, {one['cpp_us']:.2f} us in C++: "
          f"{one['more_us']:.2f} us more")
    print(f"import limber: {found['import_s']:.3f} s, of which NumPy {found['import_numpy_s']:.3f} s")
    print(f"plans of 200 000 queries: one thread {beside['one_s']:.2f} s, two threads "
          f"{beside['two_s']:.2f} s: {beside['ratio']:.2f} times; a 1 ms ticker beside them at most "
          f"{1000 * beside['ticker_late_s']:.1f} ms late, 99 % within "
          f"{1000 * beside['ticker_late_99_s']:.1f} ms")
    print(f"Ctrl-C ends a plan within {1000 * found['interrupt_s']:.0f} ms ({REPEATS} times)")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--model", type=pathlib.Path, help="of the default arm; else a small one")
    parser.add_argument("--json", action="store_true")
    arguments = parser.parse_args()
    arm_file = limber.data_folder() / "arms" / "three_segment.yaml"
    arm = limber.load_arm(arm_file)
    network = (limber.read_model(arguments.model) if arguments.model
               else small_network(arguments.program, arm_file))
    forward = limber.ForwardModel(arm, network)
    behind = limber.Environment("out of reach but for the model",
                                [limber.Circle(x_m=0.35, y_m=0.3, radius_m=0.05)],
                                limber.PoseGoal(x_m=0.1, y_m=0.3, theta_rad=3.0,
                                                position_tolerance_m=0.0005,
                                                orientation_tolerance_rad=0.002))
    problem = limber.PlanningProblem(arm, limber.MotionModel(forward), behind)
    found = {**speed(arm, forward), **import_time(), "threads": threads(problem),
             "interrupt_s": interrupt(problem)}
    if arguments.json:
        print(json.dumps(found, indent=2))
    else:
        print_text(found)


if __name__ == "__main__":
    main()
