#!/usr/bin/env python3
"""Wall time of `poinsot solve FILE`, from the start of the process to its end, for each problem file.

usage: startup.py PROGRAM FILE...
"""
import statistics
import subprocess
import sys
import time

RUNS = 7
SHOWN = 10
LIMIT = 60  # seconds for one run


def solve(program, file):
    """Seconds and exit code of one run; the code is None if the limit was reached."""
    begin = time.perf_counter()
    try:
        run = subprocess.run([program, "solve", file], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                             stderr=subprocess.DEVNULL, timeout=LIMIT, check=False)
        code = run.returncode
    except subprocess.TimeoutExpired:
        code = None
    return time.perf_counter() - begin, code


def measure(program, file):
    """Median seconds and exit code; a file that reaches the limit is not run again."""
    solve(program, file)  # brings program and file into the caches
    times = []
    for _ in range(RUNS):
        seconds, code = solve(program, file)
        times.append(seconds)
        if code is None:
            break
    return statistics.median(times), code


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__.strip())
    program, files = sys.argv[1], sys.argv[2:]
    rows = sorted(((*measure(program, file), file) for file in files), key=lambda row: row[0], reverse=True)

    print(f"poinsot solve FILE, start of the process included: median of {RUNS} runs, the {SHOWN} slowest of {len(rows)}")
    print(f"{'ms':>9}  {'exit':>4}  file")
    for seconds, code, file in rows[:SHOWN]:
        print(f"{1000 * seconds:9.1f}  {'-' if code is None else code:>4}  {file}")
    print(f"{1000 * sum(row[0] for row in rows):9.1f}        all {len(rows)} files")
    print(f"{1000 * statistics.median(row[0] for row in rows):9.1f}        median file")
    answered = sum(row[1] == 0 for row in rows)
    if answered < len(rows):
        print(f"{len(rows) - answered} files were not fully answered; their times say little")


if __name__ == "__main__":
    main()
