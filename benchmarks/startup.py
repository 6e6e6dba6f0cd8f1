#!/usr/bin/env python3
"""Wall time of `poinsot solve --json FILE`, from the start of the process to its end, for each problem file.

usage: startup.py PROGRAM FILE...
"""
import os
import statistics
import subprocess
import sys
import threading
import time

RUNS = 7
AIM = 20  # ms that a file should take at most
LIMIT = 60  # seconds for one run


def run_once(command):
    """Seconds and exit code of one run; the code is None if the limit was reached."""
    with open(os.devnull, "r+b") as nothing:
        begin = time.perf_counter()
        run = subprocess.Popen(command, stdin=nothing, stdout=nothing, stderr=nothing)
        # Waiting with a limit would look in steps of up to 50 ms: the limit is kept by another thread.
        limit = threading.Timer(LIMIT, run.kill)
        limit.start()
        code = run.wait()
        seconds = time.perf_counter() - begin
        limit.cancel()
    return seconds, None if seconds >= LIMIT else code


def measure(*command):
    """Median seconds and exit code; what reaches the limit is not run again."""
    run_once(command)  # brings program and file into the caches
    times = []
    for _ in range(RUNS):
        seconds, code = run_once(command)
        times.append(seconds)
        if code is None:
            break
    return statistics.median(times), code


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__.strip())
    program, files = sys.argv[1], sys.argv[2:]
    start, _ = measure(program, "--version")
    rows = sorted(((*measure(program, "solve", "--json", file), file) for file in files), key=lambda row: row[0],
                  reverse=True)
    slow = [row for row in rows if 1000 * row[0] > AIM]

    print(f"poinsot solve --json FILE, start of the process included: median of {RUNS} runs; "
          f"{len(slow)} of {len(rows)} files take more than {AIM} ms")
    print(f"{'ms':>9}  {'exit':>4}  file")
    for seconds, code, file in slow:
        print(f"{1000 * seconds:9.1f}  {'-' if code is None else code:>4}  {file}")
    print(f"{1000 * sum(row[0] for row in rows):9.1f}        all {len(rows)} files")
    print(f"{1000 * statistics.median(row[0] for row in rows):9.1f}        median file")
    print(f"{1000 * start:9.1f}        start alone: poinsot --version")
    answered = sum(row[1] == 0 for row in rows)
    if answered < len(rows):
        print(f"{len(rows) - answered} files were not fully answered; their times say little")


if __name__ == "__main__":
    main()
