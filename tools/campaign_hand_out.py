#!/usr/bin/env python3
"""What more ranks than this machine has would do with a campaign: the hand-out of limber campaign, simulated.

    tools/campaign_hand_out.py OUT --ranks 1000 --units 100000

OUT is the folder of a finished campaign, whose units' times are drawn from (with --seed). Rank 0 answers questions one after
the other, when it looks; dearest units first, as far as the estimated costs tell. Beside it stand a hand-out in any order,
shards (every n-th unit), and lock step (every rank waits for all before its next unit).
"""

import argparse
import heapq
import json
import pathlib
import random

LOOK_S = 0.3e-3  # kLook of src/lab/campaign/mpi_ranks.cpp
SERVICE_S = 9e-6  # of one question: probe, receive, send; measured after a look's sleep, 0.4e-6 without
LATENCY_S = 0.5e-6  # of a message, measured within one machine; about 50e-6 over Ethernet


def measured_times(folder):
    return sorted(json.loads(path.read_text(encoding="utf-8"))["run"]["wall_time_s"]
                  for path in pathlib.Path(folder).glob("units/*/*/done_*.json"))


def handed_out(times, ranks, look_s, service_s, latency_s):
    """(when the last unit ends, mean wait for a unit, share of the time that rank 0 answers)"""
    free = [(0.0, rank) for rank in range(ranks)]
    server_free, waits = 0.0, 0.0
    for time_s in times:
        asked, rank = heapq.heappop(free)
        arrived = asked + latency_s
        # A busy server goes on; one that sleeps looks up at a multiple of its look.
        looked = arrived if server_free >= arrived else -(-arrived // look_s) * look_s
        server_free = max(looked, server_free) + service_s
        begin = server_free + latency_s
        waits += begin - asked
        heapq.heappush(free, (begin + time_s, rank))
    end = max(free)[0]
    return end, waits / len(times), len(times) * service_s / end


def in_shards(times, ranks):
    return max(sum(times[rank::ranks]) for rank in range(ranks))


def in_lock_step(times, ranks):
    return sum(max(times[i:i + ranks]) for i in range(0, len(times), ranks))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--ranks", type=int, nargs="+", default=[1000])
    parser.add_argument("--units", type=int, default=100_000)
    parser.add_argument("--faster", type=float, nargs="+", default=[1.0], help="units so many times as short")
    parser.add_argument("--estimate-error", type=float, default=0.3, help="of the costs that sort them, relative")
    parser.add_argument("--look-s", type=float, default=LOOK_S)
    parser.add_argument("--service-s", type=float, default=SERVICE_S)
    parser.add_argument("--latency-s", type=float, default=LATENCY_S)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    chance = random.Random(options.seed)
    known = measured_times(options.folder)
    waiting = (options.look_s, options.service_s, options.latency_s)
    drawn = [chance.choice(known) for _ in range(options.units)]
    print(f"{len(known)} units measured: {min(known):.3f} to {max(known):.3f} s")
    print("| ranks | mean unit [s] | dearest first | wait [ms] | rank 0 answers | tail [units] | any order | shards | lock step |")
    print("|---|---|---|---|---|---|---|---|---|")
    for ranks in options.ranks:
        for faster in options.faster:
            times = [time_s / faster for time_s in drawn]
            ideal = sum(times) / ranks
            mean = sum(times) / len(times)
            by_cost = sorted(times, key=lambda t: -t * (1 + chance.gauss(0, options.estimate_error)))
            end, wait, busy = handed_out(by_cost, ranks, *waiting)
            other, _, _ = handed_out(times, ranks, *waiting)
            print(f"| {ranks} | {mean:.4g} | {ideal / end:.1%} | {1e3 * wait:.3f} | {busy:.1%} | {(end - ideal) / mean:.2f} "
                  f"| {ideal / other:.1%} | {ideal / in_shards(times, ranks):.1%} | {ideal / in_lock_step(times, ranks):.1%} |")


if __name__ == "__main__":
    main()
