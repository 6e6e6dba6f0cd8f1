#!/usr/bin/env python3
"""Wall time of `poinsot solve --json FILE`, from the start of the process to its end, for each problem file: the least
of some runs, which is what the program takes, and their median, to which the machine adds what else it does.

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
    """Least and median seconds, and exit code; what reaches the limit is not run again."""
    run_once(command)  # brings program and file into the caches
    times = []
    for _ in range(RUNS):
        seconds, code = run_once(command)
        times.append(seconds)
        if code is None:
            break
    return min(times), statistics.median(times), code


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__.strip())
    program, files = sys.argv[1], sys.argv[2:]
    *start, _ = measure(program, "--version")
    rows = sorted(((*measure(program, "solve", "--json", file), file) for file in files), reverse=True,
                  key=lambda row: row[:2])
    slow = [row for row in rows if 1000 * row[1] > AIM]

    def table_row(least, median, *words):
        print(f"{1000 * least:9.1f} {1000 * median:9.1f}  ", *words)

    print(f"poinsot solve --json FILE, start of the process included, {RUNS} runs: {len(slow)} of {len(rows)} files "
          f"take more than {AIM} ms in the median, {sum(1000 * row[0] > AIM for row in rows)} at the least")
    print(f"{'least ms':>9} {'median':>9}   exit  file")
    for least, median, code, file in slow:
        table_row(least, median, f"{'-' if code is None else code:>4}  {file}")
    for name, over in (("all files", sum), ("median file", statistics.median)):
        table_row(over(row[0] for row in rows), over(row[1] for row in rows), " " * 5, name)
    table_row(*start, " " * 5, "start alone: poinsot --version")
    answered = sum(row[2] == 0 for row in rows)
    if answered < len(rows):
        print(f"{len(rows) - answered} files were not fully answered; their times say little")


if __name__ == "__main__":
    main()
