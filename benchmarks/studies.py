"""studies.py: how many cases of a problem are answered in a second, by each road, beside SymPy's compiled formula.

Of items with an unknown that has no formula the equations of the instant are evaluated, with Newton's method. Where an
unknown has one (18.011), every thousandth row, which is solved in full, seeks it anew: that takes most of the time.

Times are those of the processor, for one thread, the least of three runs; the scaling, over threads and over workers of Dask,
is by the clock.
"""

import importlib
import os
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import sympy

import poinsot
from poinsot import _core

# Its functions have no types.
distributed: Any = importlib.import_module("distributed")

TEXTBOOK = Path(__file__).parents[1] / "examples/textbook"
ITEMS = ("18.005", "18.011", "18.024", "18.045", "18.062")
# With an unknown.
SOUGHT = ("18.011", "18.088", "18.113", "18.155", "18.157")
ROWS = 1_000_000
# For scaling.
SCALED = 6_000_000


def least(run: Callable[[], object], times: int = 3) -> float:
    spent = []
    for _ in range(times):
        begin = time.process_time()
        run()
        spent.append(time.process_time() - begin)
    return min(spent)


def compiled(problem: poinsot.Problem, names: list[str], formulas: bool) -> _core.Cases:
    first = [problem._core.value_in_si(name, problem.data[name]) for name in names]
    cases = problem._core.cases(_core.CaseQuestions(names, [], [], first, formulas), None, None)[0]
    assert cases is not None
    return cases


def rate(cases: _core.Cases, values: list[Any], first: int, repeat: int = 1) -> float:
    stop = _core.StopFlag()

    def run() -> None:
        for _ in range(repeat):
            cases.solve(values, first, stop)

    return repeat * len(values[0]) / least(run)


def lambdified(problem: poinsot.Problem, names: list[str], values: list[Any]) -> float:
    """The same formulas by SymPy and NumPy. The numbers of the other data are put in before."""
    text = problem.text
    # What is varied becomes a letter.
    units = {one.name: one.unit for one in compiled(problem, names, False).over}
    given = [f"{name}: {value}" for name, value in problem.data.items() if name not in names]
    lines = [line for line in text.split("\n") if not line.startswith("given:")]
    letters = ", ".join(f"{name}: {units[name] or 1}" for name in names)
    opened = "\n".join([f"given: {{{', '.join(given)}}}", f"letters: {{{letters}}}", *lines])
    found = poinsot.Problem.from_text(opened, problem.name).solve().solution.answers.values()
    formulas = [one.sympy() for one in found if one.formula is not None]
    numbers = [part for one in formulas for part in (list(one) if hasattr(one, "shape") else [one])]
    symbols = {one.name: one for part in numbers for one in part.free_symbols}
    function = sympy.lambdify([symbols.get(name, sympy.Symbol(name)) for name in names], numbers, "numpy")
    return len(values[0]) / least(lambda: function(*values))


def varied(item: str) -> tuple[poinsot.Problem, list[str], list[float]]:
    """A problem of the textbook, and its first data with units, with their values."""
    problem = poinsot.Problem.from_file(TEXTBOOK / f"{item}.yaml")
    stated = [one for one in problem._core.situations[0].data if one.unit][:3]
    return problem, [one.name for one in stated], [problem._core.value_in_si(one.name, one.text) for one in stated]


def main() -> None:
    random = np.random.default_rng(1)
    print("cases a second and processor: by formula; with every thousandth in full; by instants; with every thousandth; "
          "in full; Problem.solve(); SymPy's lambdify")
    for item in ITEMS:
        problem, names, near = varied(item)
        values = [value * random.uniform(0.95, 1.05, ROWS) for value in near]
        few = [np.ascontiguousarray(column[:999]) for column in values]
        by_formula, without = compiled(problem, names, True), compiled(problem, names, False)
        alone = [{name: f"{float(column[row])!r} {one.unit}" for name, column, one in zip(names, values, by_formula.over, strict=True)}
                 for row in range(50)]
        instants = rate(without, few, 1, 100) if without.by_instants else float("nan")
        checked = rate(without, values, 0) if without.by_instants else float("nan")
        slow = [np.ascontiguousarray(column[1:100]) for column in values]
        in_full = rate(without, slow, 1) if not without.by_instants else float("nan")
        solving = len(alone) / least(lambda: [problem.solve(case) for case in alone], 1)  # noqa: B023
        try:
            peer = f"{lambdified(problem, names, values):9.2e}"
        except Exception as error:  # a file that is laid out in another way
            peer = f"none ({type(error).__name__})"
        print(f"{item}  {rate(by_formula, few, 1, 1000):9.2e}  {rate(by_formula, values, 0):9.2e}  {instants:9.2e}  "
              f"{checked:9.2e}  {in_full:9.2e}  {solving:9.2e}  {peer}", flush=True)

    print("with an unknown: by instants; with every thousandth in full; rows that went another way, of a thousand")
    for item in SOUGHT:
        problem, names, near = varied(item)
        values = [value * random.uniform(0.95, 1.05, 20_000) for value in near]
        few = [np.ascontiguousarray(column[1:1000]) for column in values]
        sought = compiled(problem, names, False)
        roads = sought.solve(few, 1, _core.StopFlag())[1]
        print(f"{item}  {rate(sought, few, 1):9.2e}  {rate(sought, values, 0):9.2e}  {np.count_nonzero(roads != 1)}", flush=True)

    problem = poinsot.Problem.from_file(TEXTBOOK / "18.005.yaml")
    over = {"W": poinsot.normal("10 lb", "0.1 lb"), "r": poinsot.uniform("5 in", "7 in")}
    print(f"by instants, by the clock: rows a second; as a part of what one does, times their number ({os.cpu_count()} processors)")
    by_one: dict[str, float] = {}
    for threads in (1, 2, 4):
        begin = time.perf_counter()
        poinsot.study(problem, over, rows=SCALED, formulas=False, shard_rows=50_000, threads=threads)
        spent = time.perf_counter() - begin
        print(scaled(f"{threads} threads", spent, by_one.setdefault("threads", spent), threads), flush=True)

    # Their rows go to files, which threads of this process did not write above.
    for workers in (0, 1, 2):
        with tempfile.TemporaryDirectory() as folder:
            spent = on_workers(problem, over, Path(folder) / "rows", workers)
        who = f"{workers} workers of Dask" if workers else "1 thread, with files"
        print(scaled(who, spent, by_one.setdefault("workers", spent), max(workers, 1)), flush=True)


def scaled(who: str, spent: float, alone: float, count: int) -> str:
    return f"{who:20}  {SCALED / spent:9.2e}  {alone / spent / min(count, os.cpu_count() or 1):.2f}"


def on_workers(problem: poinsot.Problem, over: dict[str, Any], folder: Path, workers: int) -> float:
    """The time by the clock, s."""

    def run(where: Path, rows: int, client: Any) -> float:
        begin = time.perf_counter()
        poinsot.study(problem, over, rows=rows, formulas=False, shard_rows=50_000, threads=1, out=where, client=client)
        return time.perf_counter() - begin

    if workers == 0:
        return run(folder, SCALED, None)
    with (
        distributed.LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        # A first study lets each worker load the package.
        run(folder.with_name("first"), 50_000 * workers, client)
        return run(folder, SCALED, client)


if __name__ == "__main__":
    main()
