"""Figures of docs/python.md: rates from Python beside C++, overhead of one query, time to import,
threads beside each other, and how soon Ctrl-C ends a plan.

    PYTHONPATH=build/release/python benchmarks/python_figures.py build/release/bin/limber
"""

import argparse
import json
import os
import pathlib
import signal
import statistics
import subprocess
import sys
import tempfile
import threading
import time

import numpy as np

import limber

BATCHES = (256, 1024)
QUERIES = 4096  # of a pass over different ones, as `limber bench` has them
REPEATS = 5
SECONDS = 1.0  # each measurement


def rate(one_pass, units):
    """Units per second in the median pass, as `limber bench` measures."""
    passes, end = [], time.perf_counter() + SECONDS
    while time.perf_counter() < end:
        begin = time.perf_counter()
        one_pass()
        passes.append(time.perf_counter() - begin)
    return units / statistics.median(passes)


def queries(arm, count):
    random = np.random.default_rng(1)
    limits = arm.pressure_limits_kpa
    before, after, earlier = (
        random.uniform(-limits, limits, (count, len(limits))).astype(np.float32) for _ in range(3))
    return before, after, limber.NoLoadModel(arm).backbone(earlier)


def program_rates(program, arm_file, model_file):
    bench = json.loads(subprocess.run(
        [program, "bench", "--quick", "--arm", arm_file, "--model", model_file, "--jobs", "1",
         "--json"],
        capture_output=True, check=True).stdout)
    network = bench.get("model", bench["network"])
    rates = {row["size"]: row["queries_per_s"] for row in network["batches"]
             if row.get("threads", 1) == 1}
    return {"single": network["single"]["queries_per_s"], **{size: rates[size] for size in BATCHES}}


def python_rates(arm_file, model_file):
    arm = limber.load_arm(arm_file)
    model = limber.ForwardModel(arm, limber.read_model(model_file))
    before, after, backbones = queries(arm, QUERIES)
    out = np.empty_like(backbones)
    rates = {}
    for size in BATCHES:
        parts = [tuple(array[k:k + size] for array in (before, after, backbones, out))
                 for k in range(0, QUERIES, size)]
        rates[size] = rate(lambda: [model.step_batch(*part) for part in parts], QUERIES)
    ones = [tuple(array[k] for array in (before, after, backbones, out)) for k in range(QUERIES)]

    def one_by_one():
        for one in ones:
            model.step(*one)
    rates["single"] = rate(one_by_one, QUERIES)
    return rates


def speed(program, arm_file, model_file):
    """Queries per second in batches and one by one, from Python and from the program, in turns."""
    own, theirs = [], []
    for _ in range(REPEATS):
        theirs.append(program_rates(program, arm_file, model_file))
        own.append(python_rates(arm_file, model_file))
    best = {key: (max(one[key] for one in own), max(one[key] for one in theirs)) for key in own[0]}
    for size in BATCHES:
        print(f"batch of {size}: {best[size][0]:,.0f} queries/s in Python, {best[size][1]:,.0f} in "
              f"C++: {100 * best[size][0] / best[size][1]:.0f} %")
    alone, program_alone = 1e6 / best["single"][0], 1e6 / best["single"][1]
    print(f"one query: {alone:.2f} us in Python, {program_alone:.2f} us in C++: "
          f"{alone - program_alone:.2f} us more")


def import_time():
    def seconds(code):
        times = []
        for _ in range(REPEATS):
            begin = time.perf_counter()
            subprocess.run([sys.executable, "-c", code], check=True)
            times.append(time.perf_counter() - begin)
        return statistics.median(times)
    bare, numpy, whole = seconds("pass"), seconds("import numpy"), seconds("import limber")
    print(f"import limber: {whole - bare:.3f} s, of which NumPy {numpy - bare:.3f} s")


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
    print(f"plans of 200 000 queries: one thread {one:.2f} s, two threads {two:.2f} s: "
          f"{two / one:.2f} times; a 1 ms ticker beside them at most {1000 * max(late):.1f} ms "
          f"late, 99 % within {1000 * np.quantile(late, 0.99):.1f} ms")


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
    print(f"Ctrl-C ends a plan within {1000 * max(seconds):.0f} ms ({len(seconds)} times)")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=pathlib.Path)
    arguments = parser.parse_args()
    arm_file = limber.data_folder() / "arms" / "three_segment.yaml"
    with tempfile.TemporaryDirectory() as folder:
        recording, model_file = f"{folder}/train.h5", f"{folder}/model.safetensors"
        for command in (["collect", "--arm", arm_file, "--schedule", "random", "--count", "20",
                         "--out", recording],
                        ["train", "--arm", arm_file, "--preset", "paper", "--data", recording,
                         "--epochs", "2", "--out", model_file]):
            subprocess.run([arguments.program, *map(str, command), "--quiet"], check=True,
                           stdout=subprocess.DEVNULL)
        speed(arguments.program, arm_file, model_file)
        network = limber.read_model(model_file)
    import_time()
    arm = limber.load_arm(arm_file)
    forward = limber.ForwardModel(arm, network)
    behind = limber.Environment("out of reach but for the model",
                                [limber.Circle(x_m=0.35, y_m=0.3, radius_m=0.05)],
                                limber.PoseGoal(x_m=0.1, y_m=0.3, theta_rad=3.0,
                                                position_tolerance_m=0.0005,
                                                orientation_tolerance_rad=0.002))
    problem = limber.PlanningProblem(arm, limber.MotionModel(forward), behind)
    threads(problem)
    interrupt(problem)


if __name__ == "__main__":
    main()
