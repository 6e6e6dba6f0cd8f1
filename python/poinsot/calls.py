"""Long calls: their progress, and what ends them."""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Callable
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


def listener(progress: Progress) -> Any:
    """What is told of the progress of a call, or None."""
    if callable(progress):
        return progress
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
