"""Random draws of which each is known by its seed and its number: no draw needs those before it."""

from __future__ import annotations

import functools
import inspect
from typing import Any

import numpy as np

from .axes import Array

SAMPLINGS = ("random", "latin hypercube", "sobol")

# Philox makes four numbers at each count.
_AT_ONCE = 4


def unit_draws(sampling: str, seed: int, variables: int, rows: int, first: int, count: int) -> Array:
    """Draws `first` to `first + count` of `rows`, a row for each variable, between 0 and 1 without the ends."""
    if variables == 0:
        return np.empty((0, count))
    if sampling == "random":
        return np.stack([_random(seed, variable, first, count) for variable in range(variables)])
    if sampling == "sobol":
        return _inside(_sobol(seed, variables, first, count))
    return _inside(_latin(seed, variables, rows)[:, first : first + count])


def _random(seed: int, variable: int, first: int, count: int) -> Array:
    start = first // _AT_ONCE
    stream = np.random.Philox(key=np.array([seed, variable], dtype=np.uint64))
    stream.advance(start)
    skipped = first - start * _AT_ONCE
    raw = stream.random_raw(skipped + count)[skipped:]
    # The middles of 2^52 equal parts.
    return ((raw >> np.uint64(12)).astype(float) + 0.5) * 2.0**-52


def _inside(draws: Array) -> Array:
    return np.clip(draws, 2.0**-53, 1 - 2.0**-53)


def _seeded(kind: Any, variables: int, seed: int) -> Any:
    # SciPy renamed the seed.
    name = "rng" if "rng" in inspect.signature(kind.__init__).parameters else "seed"
    return kind(d=variables, **{name: np.random.default_rng(seed)})


def _sobol(seed: int, variables: int, first: int, count: int) -> Array:
    from scipy.stats import qmc

    engine = _seeded(qmc.Sobol, variables, seed)
    if first:
        engine.fast_forward(first)
    import warnings

    with warnings.catch_warnings():
        # The whole study may have a balanced number of draws where its parts have not.
        warnings.filterwarnings("ignore", message="The balance properties")
        return np.ascontiguousarray(engine.random(count).T)


@functools.lru_cache(maxsize=1)
def _latin(seed: int, variables: int, rows: int) -> Array:
    from scipy.stats import qmc

    return np.ascontiguousarray(_seeded(qmc.LatinHypercube, variables, seed).random(rows).T)
