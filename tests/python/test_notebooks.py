"""The notebooks run, and what they find is what a closed form or conservation says."""

from pathlib import Path
from typing import Any

import nbclient
import nbformat
import pytest

from outputs import wrong_in

# They have no types.
read: Any = nbformat.read
new_code_cell: Any = nbformat.v4.new_code_cell

NOTEBOOKS = Path(__file__).parents[2] / "examples/notebooks"

# A last cell for each.
HOLDS = {
    "first_problem": """
import sympy
m, r, b, n, L = sympy.symbols("m r b n L")
assert sympy.simplify(B[1] - m * r**2 * n**2 * sympy.sin(b) * sympy.cos(b) / (4 * L)) == 0
assert np.allclose(loads, 8 * 0.15**2 * (speeds * np.pi / 30) ** 2 * np.sin(np.radians(40)) / 8 / 0.5)
""",
    "balanced_rotor": "assert np.allclose(found, by_hand, rtol=1e-9)",
    "top": "assert np.allclose(found, by_hand, rtol=1e-9); assert energy_drift < 1e-9",
    "satellite": "assert momentum_drift < 1e-9 and energy_drift < 1e-9; assert w[:, 1].min() < -4.9 and w[0, 1] == 5",
    "study": """
from math import erf, sqrt
assert misfit < 1e-9 and pieces.counts.by_formula == pieces.counts.rows and pieces.counts.refuted == 0
slope = 8 * 0.15**2 * (100 * np.pi) ** 2 / 4 / 0.5  # of the reaction by the angle
assert abs(part_below - erf(limit / slope / np.radians(0.1) / sqrt(2))) < 3e-3
assert max(shares, key=shares.get) == "b"
""",
}


def test_every_notebook_is_held_to_something() -> None:
    assert {path.stem for path in NOTEBOOKS.glob("*.ipynb")} == set(HOLDS)


@pytest.mark.parametrize("name", sorted(HOLDS))
def test_runs_and_holds(name: str, tmp_path: Path) -> None:
    notebook = read(NOTEBOOKS / f"{name}.ipynb", as_version=4)
    assert not any(cell.get("outputs") for cell in notebook.cells), "a notebook is kept without its outputs"
    notebook.cells.append(new_code_cell(HOLDS[name]))
    nbclient.NotebookClient(notebook, timeout=120, resources={"metadata": {"path": str(tmp_path)}}).execute()
    outputs = [one["data"] for cell in notebook.cells for one in cell.get("outputs", []) if "data" in one]
    assert [wrong for one in outputs for wrong in wrong_in(one)] == []
    shown = [kind for one in outputs for kind in one]
    assert "text/html" in shown or "text/latex" in shown
    if name in ("first_problem", "balanced_rotor"):
        assert "image/svg+xml" in shown
