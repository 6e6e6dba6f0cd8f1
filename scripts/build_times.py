#!/usr/bin/env python3
"""What took longest in the last builds of a folder, from ninja's log: seconds of each file that is still there.

usage: build_times.py BUILD_FOLDER [ROWS]
"""
import pathlib
import sys


def times(folder):
    """Seconds by file; the last time that it was made counts."""
    seconds = {}
    for line in (folder / ".ninja_log").read_text().splitlines():
        fields = line.split("\t")
        if len(fields) >= 4 and (folder / fields[3]).is_file():
            seconds[fields[3]] = (int(fields[1]) - int(fields[0])) / 1000
    return seconds


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__.strip())
    seconds = times(pathlib.Path(sys.argv[1]))
    rows = sorted(seconds.items(), key=lambda row: -row[1])[:int(sys.argv[2]) if len(sys.argv) == 3 else 40]
    print(f"{sum(seconds.values()):8.1f} s in all, {len(seconds)} files")
    for name, taken in rows:
        print(f"{taken:8.1f}   {name}")


if __name__ == "__main__":
    main()
