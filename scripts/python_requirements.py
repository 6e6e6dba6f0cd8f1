#!/usr/bin/env python3
"""What pyproject.toml asks of the Python package index, one requirement a line: to build, to run, and for its extras.

usage: python_requirements.py [EXTRA...]      test brings what tests and measurements take
"""

import re
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any


def requirements(stated: dict[str, Any], extras: list[str]) -> list[str]:
    """Each once. An extra may name others of this package, as poinsot[study]."""
    project = stated["project"]
    own = re.compile(rf"{re.escape(project['name'])}\[(?P<extras>[^]]*)\]")

    def of_extra(extra: str) -> Iterator[str]:
        for one in project["optional-dependencies"][extra]:
            if others := own.fullmatch(one):
                for other in others["extras"].split(","):
                    yield from of_extra(other.strip())
            else:
                yield one

    found = [*stated["build-system"]["requires"], *project["dependencies"]]
    for extra in extras:
        found += of_extra(extra)
    return list(dict.fromkeys(found))


def main() -> int:
    stated = tomllib.loads((Path(__file__).parents[1] / "pyproject.toml").read_text(encoding="utf-8"))
    unknown = [extra for extra in sys.argv[1:] if extra not in stated["project"]["optional-dependencies"]]
    if unknown:
        known = ", ".join(stated["project"]["optional-dependencies"])
        print(f"python_requirements: there is no extra '{unknown[0]}': expected {known}", file=sys.stderr)
        return 2
    print("\n".join(requirements(stated, sys.argv[1:])))
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
