"""Long calls: their progress, and what ends them."""

from __future__ import annotations

import importlib.util
import operator
import sys
from collections.abc import Callable, Iterable
from typing import Any, TypeAlias

# True and False for a bar or none, None for a bar where a person would see it, or a function that is called with what
# is done, its part from 0 to 1 where that is known, and a count.
Progress: TypeAlias = bool | None | Callable[[str, float | None, int], object]


class _Bar:
    """A bar of tqdm, which appears after a second and is gone in the end."""

    def __init__(self, tqdm: Any) -> None:
        self._tqdm = tqdm
        self._bar: Any = None

    def __call__(self, doing: str, part: float | None, count: int) -> None:
        if self._bar is None:
            self._bar = self._tqdm(desc=doing, leave=False, delay=1, total=1.0)
        self._bar.set_description(doing if part is not None else f"{doing}, {count} so far", refresh=False)
        if part is not None:
            self._bar.n = round(part, 3)
        self._bar.update(0)

    def close(self) -> None:
        if self._bar is not None:
            self._bar.close()


def _in_notebook() -> bool:
    shell = sys.modules.get("IPython")
    return shell is not None and type(shell.get_ipython()).__name__ == "ZMQInteractiveShell"


def seconds(timeout: float | None) -> float | None:
    """The timeout of a call as a number."""
    if timeout is None:
        return None
    try:
        if not isinstance(timeout, str):
            return float(timeout)
    except TypeError:
        pass
    raise TypeError(f"the timeout is a number of seconds, not {timeout!r}")


def whole(value: Any, name: str, least: int = 1) -> int:
    """A whole number that the caller gave for `name`."""
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} is a whole number, not {value!r}") from None
    if isinstance(value, bool) or number < least:
        raise ValueError(f"{name} is a whole number, {least} or more, not {value!r}")
    return number


def texts(value: Any, name: str) -> list[str]:
    """A list of texts, for which one alone may stand."""
    if isinstance(value, Iterable) and not isinstance(value, bytes):
        listed = [value] if isinstance(value, str) else list(value)
        if all(isinstance(one, str) for one in listed):
            return listed
    raise TypeError(f"{name} is a list of texts, not {value!r}")


def listener(progress: Progress) -> Any:
    """What is told of the progress of a call, or None."""
    if callable(progress):
        return progress
    if progress is not None and not isinstance(progress, bool):
        raise TypeError(f"progress is True, False or a function, not {progress!r}")
    if progress is False or (progress is None and not (_in_notebook() or sys.stderr.isatty())):
        return None
    try:
        # The bar of notebooks is one of ipywidgets; without these tqdm would warn at each first call.
        if _in_notebook() and importlib.util.find_spec("ipywidgets"):
            from tqdm.notebook import tqdm
        else:
            from tqdm import tqdm
    except ImportError:
        if progress:
            raise ImportError("progress=True shows a bar of tqdm, which is not installed: pip install tqdm") from None
        return None
    return _Bar(tqdm)


def close(heard: Any) -> None:
    if isinstance(heard, _Bar):
        heard.close()
