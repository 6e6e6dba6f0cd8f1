"""python -m poinsot study FILE: runs the study that a file describes."""

from __future__ import annotations

import argparse
import sys

from .errors import PoinsotError
from .studies.file import run_file


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m poinsot", description="Studies: one problem, many cases.")
    commands = parser.add_subparsers(dest="command", required=True)
    command = commands.add_parser("study", help="run the study that a TOML file describes, or go on with it")
    command.add_argument("file", metavar="FILE", help="the study: problem, over, asks, rows, seed, out (docs/python.md)")
    command.add_argument("-o", "--out", help="the folder for the rows, in place of the file's own")
    command.add_argument("--threads", type=int, help="all processors by default")
    chosen = parser.parse_args(arguments)
    try:
        study = run_file(chosen.file, out=chosen.out, threads=chosen.threads)
    except (PoinsotError, ValueError, TypeError) as error:
        # What is wrong in the problem file has its place with it.
        text = str(error)
        print(text if ": error: " in text else f"{chosen.file}: error: {text}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"{error.filename or chosen.file}: error: {error.strerror or error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("interrupted: the same command goes on where this one was stopped", file=sys.stderr)
        return 130
    counts = study.counts
    print(f"{counts.rows} rows in {study.folder}, {counts.answered} with every answer")
    print(f"{counts.by_formula} by formula, {counts.by_instant} by their instants alone; {counts.checked} of these were "
          f"solved in full as well, which refuted {counts.refuted}")
    if study.no_formulas:
        print(f"no formulas: {study.no_formulas}")
    return 0 if counts.answered == counts.rows else 1


if __name__ == "__main__":
    raise SystemExit(main())
