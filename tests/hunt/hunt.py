#!/usr/bin/env python3
"""The hunt: statements, made at random and by changing the examples, and relations that must hold between their answers.

usage: hunt.py PROGRAM [--seconds S | --statements N | --fixed] [--seed N] [--relation NAME [--at I]] [--workers 1|2]

Statement I of a relation and a seed is the same everywhere and always. Exit code: 0 nothing was found, 1 something was, 130 interrupted.
"""
import argparse
import collections
import multiprocessing
import pathlib
import random
import signal
import sys
import time
import zlib

# Folders of compiled modules have no place among the sources.
sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import report  # noqa: E402
import runner  # noqa: E402
import statements  # noqa: E402
from all_relations import RELATIONS  # noqa: E402
from random_statements import made_statement  # noqa: E402
from runner import Program  # noqa: E402
from shrink import shrunk  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
# How many statements are drawn until one is found of which a relation says something.
DRAWS = 40
# The hunt that is a test: as many statements for each relation as take about two minutes on two cores.
FIXED_SEED, FIXED_FOR_EACH = 1, 55
# Processor seconds of an answer in it: three times what is found elsewhere, so that it fails on no slow machine.
FIXED_SECONDS = 60
worker = None


class Worker:
    def __init__(self, program, root, known):
        self.program, self.known = Program(program), known
        self.examples = statements.examples(root)

    def try_one(self, seed, name, index):
        """Holds a relation for its statement `index` of the seed; the outcome can be sent between processes."""
        draw, relation = random.Random(f"{seed}/{name}/{index}"), RELATIONS[name]
        for _ in range(DRAWS):
            statement = relation.make(draw) if hasattr(relation, "make") else self.statement(draw)
            inner = draw.randrange(2**32)
            finds = relation.hold(self.program, statement, random.Random(inner))
            if finds is not None:
                if (name, statement.name) not in self.known:
                    finds = [shrunk(relation, self.program, find, inner) for find in finds[:1]]
                return index, name, statement.name, finds
        return index, name, None, []

    def statement(self, draw):
        """One made at random, or an example: that of the smallest lot, so that a new example takes few others' place."""
        lot = draw.random()
        if draw.random() < 0.25:
            return made_statement(draw)
        example = min(self.examples, key=lambda one: zlib.crc32(f"{lot}/{one.name}".encode()))
        return statements.jiggled(example, draw) if draw.random() < 0.4 else example


def start_worker(*arguments):
    global worker
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    worker = Worker(*arguments)


def work(job):
    return worker.try_one(*job)


def known_finds(path):
    """Finds that are known: relation and example or made statement, of each line that is no comment."""
    lines = [line for line in path.read_text().splitlines() if line.strip() and not line.startswith("#")] if path.exists() else []
    return {tuple(line.split()[:2]): " ".join(line.split()[2:]) for line in lines}


class Hunt:
    def __init__(self, options):
        self.options = options
        self.names = options.relation or list(RELATIONS)
        self.tried, self.finds = collections.Counter(), []
        self.known = known_finds(pathlib.Path(__file__).parent / "known.txt") if options.fixed else {}
        self.met = set()
        if options.fixed:
            runner.SECONDS = FIXED_SECONDS

    def jobs(self):
        if self.options.at is not None:
            yield (self.options.seed, self.names[0], self.options.at)
            return
        began, index = time.monotonic(), 0
        while index < self.options.statements if self.options.statements else time.monotonic() - began < self.options.seconds:
            yield (self.options.seed, self.names[index % len(self.names)], index // len(self.names))
            index += 1

    def run(self):
        options = self.options
        print(f"Hunting with seed {options.seed}: {', '.join(self.names)}", flush=True)
        told = time.monotonic()
        interrupted = False
        pool = multiprocessing.Pool(options.workers, start_worker, (options.program, ROOT, set(self.known)))
        try:
            pending, jobs, more = collections.deque(), self.jobs(), True
            while pending or more:
                while more and len(pending) < 2 * options.workers:
                    job = next(jobs, None)
                    if job is None:
                        more = False
                    else:
                        pending.append(pool.apply_async(work, (job,)))
                if pending:
                    self.take(pending.popleft().get())
                if time.monotonic() - told > 5:
                    told = time.monotonic()
                    print(f"  {sum(self.tried.values())} statements, {len(self.finds)} found", flush=True)
        except KeyboardInterrupt:
            interrupted = True
        finally:
            pool.terminate()
            pool.join()
        self.tell(interrupted)
        return 130 if interrupted else 1 if self.finds else 0

    def take(self, outcome):
        index, relation, name, finds = outcome
        if name is None:
            return
        self.tried[relation] += 1
        for find in finds:
            if (relation, name) in self.known:
                self.met.add((relation, name))
                continue
            command = f"./test --hunt --seed {self.options.seed} --relation {relation} --at {index}"
            path = report.keep(find, pathlib.Path(self.options.kept), len(self.finds) + 1, command)
            self.finds.append(find)
            print(f"FOUND {relation}, {name}: {find.words[:400]}\n  {path}\n  {command}", flush=True)

    def tell(self, interrupted):
        print("\nStatements for each relation:")
        for name in self.names:
            print(f"  {name:12} {self.tried[name]}")
        if self.options.fixed and not interrupted:
            for relation, name in sorted(set(self.known) - self.met):
                print(f"FOUND no more: {relation}, {name}: take it out of tests/hunt/known.txt")
                self.finds.append(None)
        if self.met:
            print(f"{len(self.met)} that are known (tests/hunt/known.txt)")
        print(f"{len(self.finds)} found with seed {self.options.seed}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--statements", type=int, help="as many statements in place of seconds: the same on every machine")
    parser.add_argument("--seed", type=int, default=None, help="fresh when left out")
    parser.add_argument("--at", type=int, help="only this statement of the seed for the relation")
    parser.add_argument("--relation", action="append", choices=list(RELATIONS), help="only these (repeatable)")
    parser.add_argument("--workers", type=int, default=2, choices=[1, 2])
    parser.add_argument("--kept", default=str(ROOT / "build/hunt"), help="folder for what is found")
    parser.add_argument("--fixed", action="store_true", help="the statements that known.txt is about: of a test")
    options = parser.parse_args()
    if options.at is not None and len(options.relation or []) != 1:
        parser.error("--at needs one --relation")
    if options.fixed:
        options.seed, options.statements = FIXED_SEED, FIXED_FOR_EACH * len(RELATIONS)
    if options.seed is None:
        options.seed = random.SystemRandom().randrange(10**6)
    sys.exit(Hunt(options).run())


if __name__ == "__main__":
    main()
