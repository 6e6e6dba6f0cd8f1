"""Studies: rows against solving each by itself, and against closed forms."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow.parquet
import pytest
from scipy.special import ellipj

import poinsot
from poinsot.studies.plan import Plan

# Above a speed the bar's weight on the cord is not enough to keep it taut.
CORD = """\
title: A ball on a cord at the top of its circle
given: {m: 2 kg, L: 1.2 m, v: 5 m/s}
points: {O: [0, 0, 0], P: [0, L, 0]}
bodies: {ball: {particle: P, mass: m}}
cords: {c: {from: ground, at: O, to: ball, end: P}}
gravity: -y
instants: {top: {velocity(ball): [v, 0, 0]}}
ask: {S: tension(c)}
"""

PENDULUM = """\
title: A pendulum let go
given: {L: 1 m, a: 30 deg}
points: {O: [0, 0, 0], P: [0, -L, 0]}
bodies: {bob: {particle: P, mass: 1 kg}}
joints: {pin: {revolute: z, at: O, to: bob, angle: q}}
gravity: -y
instants: {start: {q: a, q': 0}}
ask: {q: q @ 0.4 s}
"""


# While it spins fast enough there are two rates of precession, and else none.
TOP = """\
title: A top in steady precession
given: {m: 0.5 kg, h: 120 mm, r: 40 mm, b: 40 deg, S: 400 rad/s, I: 3*m*r^2/10, J: 3*m*(r^2/4 + h^2)/5}
find: {P: rad/s}
points: {O: [0, 0, 0], T: [h*sin(b), 0, h*cos(b)]}
frames: {figure: {turns: z, rate: P}}
bodies: {top: {cone: {apex: O, base: T, radius: r}, mass: m}}
joints: {tip: {ball: O, to: top}}
steady: {frame: figure, spins: {top: {about: O->T, rate: S}}}
gravity: -z
ask: {P: angular_velocity(figure).z}
"""


def by_solving(problem: poinsot.Problem, study: poinsot.Study, row: int, answer: str) -> Any:
    return problem.solve(study.case(row))[answer].si


def test_letters_without_value_are_named_once(bent: poinsot.Problem) -> None:
    with pytest.raises(ValueError, match=r"^w needs values for m, a: sets=\{'m': '\.\.\. kg', 'a': '\.\.\. m'\} gives"):
        poinsot.study(bent, {"J": [1.0, 2.0]})
    study = poinsot.study(bent, {"J": [1.0, 2.0]}, sets={"m": "2 kg"} | {"a": "1 m"})
    np.testing.assert_allclose(study["w.z"], [30 / 7, 60 / 7])
    # What does not hang on them has its answers.
    text = """\
letters: {m: kg}
given: {u: 2 m/s}
points: {A: [0, 0, 0]}
bodies: {p: {particle: A, mass: m}}
gravity: none
instants: {now: {velocity(p): '[u, 0, 0]'}}
ask: {v: velocity(p).x, u: velocity(p).y, T: kinetic_energy(p)}
"""
    moving = poinsot.Problem.from_text(text)
    np.testing.assert_allclose(poinsot.study(moving, {"u": [1.0, 2.0]}, "v")["v"], [1, 2])
    with pytest.raises(ValueError, match="u is the name of what is varied and of what is asked"):
        poinsot.study(moving, {"u": [1.0, 2.0]}, "u")


def test_what_is_true_or_false_is_no_column() -> None:
    problem = poinsot.Problem.from_file(Path(__file__).parents[2] / "examples/mechanisms/atwood-with-a-heavy-wheel.yaml")
    for formulas in (True, False):
        with pytest.raises(poinsot.StatementError, match="'taut' is no number.*leave it out by asks"):
            poinsot.study(problem, {"m": [3.0, 3.1]}, formulas=formulas)
        study = poinsot.study(problem, {"m": [3.0, 3.1]}, ["a", "T"], formulas=formulas)
        assert study["a"] == pytest.approx([(5 - m) * 9.80665 / (5 + m + 2 / 2) for m in (3.0, 3.1)], rel=1e-9)


def test_grid_by_formula(askew: poinsot.Problem) -> None:
    speeds = [f"{speed} rpm" for speed in range(1000, 3001, 250)]
    study = poinsot.study(askew, {"n": speeds, "b": ["10 deg", "20 deg"]}, ["B", "T"])
    assert study.no_formulas == "" and study.counts.by_formula == len(study["n"]) == 18
    assert study.answers == ["B.x", "B.y", "B.z", "T"]
    assert study.units["B.y"] == "N" and study.units["n"] == "rad/s"
    n, b = study["n"], study["b"]
    assert np.allclose(n[:4] * 30 / np.pi, [1000, 1000, 1250, 1250])
    by_hand = 8 * 0.15**2 * n**2 * np.sin(b) * np.cos(b) / (4 * 0.5)
    assert np.allclose(study["B.y"], by_hand, rtol=1e-13)
    assert np.allclose(study["T"], 8 * 0.15**2 * n**2 * (1 + np.cos(b) ** 2) / 8, rtol=1e-13)
    for row in (0, 7, 17):
        assert np.allclose(study["T"][row], by_solving(askew, study, row, "T"), rtol=1e-12)


def test_negative_and_reversed_values_leave_the_formulas(askew: poinsot.Problem) -> None:
    study = poinsot.study(askew, {"n": ["-100 rpm", "100 rpm"], "L": ["-1 m", "1 m"]}, ["B", "T"])
    for row in range(4):
        if row in study.reasons:
            with pytest.raises((poinsot.StatementError, poinsot.NoAnswer)):
                askew.solve(study.case(row))["B"].si
        else:
            assert np.allclose([study[f"B.{axis}"][row] for axis in "xyz"], by_solving(askew, study, row, "B"), rtol=1e-12)


def test_rows_that_have_no_answer_say_why(askew: poinsot.Problem) -> None:
    study = poinsot.study(askew, {"m": [8.0, -1.0, 9.0]}, ["T"])
    assert set(study.reasons) == {1} and study.counts.answered == 2
    assert "mass" in study.reasons[1]
    assert np.isnan(study["T"][1]) and (study["T"][[0, 2]] > 0).all()
    frame = study.frame()
    assert frame["reason"][1] == study.reasons[1] and frame.attrs["units"]["T"] == "J"


def test_where_there_is_no_formula_each_row_is_solved() -> None:
    problem = poinsot.Problem.from_text(PENDULUM, "pendulum.yaml")
    study = poinsot.study(problem, {"a": ["20 deg", "60 deg", "90 deg"]}, ["q"])
    assert study.no_formulas and study.counts.by_formula == 0
    k = np.sin(study["a"] / 2)
    _, cn, dn, _ = ellipj(np.sqrt(9.80665) * 0.4, k**2)
    assert np.allclose(study["q"], 2 * np.arcsin(k * cn / dn), rtol=1e-8)


def test_rows_where_a_formula_does_not_hold_are_solved() -> None:
    problem = poinsot.Problem.from_text(CORD, "cord.yaml")
    study = poinsot.study(problem, {"v": poinsot.uniform(1, 6), "L": poinsot.uniform(0.5, 2)}, rows=400)
    v, L = study["v"], study["L"]
    tension = 2 * (v**2 / L - 9.80665)
    assert study.no_formulas == ""
    slack = tension < 0
    assert 50 < slack.sum() < 350 and study.counts.by_formula == 400 - slack.sum()
    assert set(study.reasons) == set(np.flatnonzero(slack))
    assert np.allclose(study["S"][~slack], tension[~slack], rtol=1e-12) and np.isnan(study["S"][slack]).all()


def test_three_roads_to_the_same_rows(askew: poinsot.Problem, tmp_path: Path) -> None:
    over = {"n": poinsot.uniform(50, 300), "b": poinsot.uniform(-0.5, 0.5), "m": poinsot.normal(8, 0.1)}
    by_formula = poinsot.study(askew, over, rows=1500)
    by_instant = poinsot.study(askew, over, rows=1500, formulas=False, out=tmp_path / "rows")
    assert by_formula.counts.by_formula == by_instant.counts.by_instant == 1500
    assert by_instant.counts.checked == 2 and by_instant.counts.refuted == 0
    for name in by_formula:
        np.testing.assert_allclose(by_instant[name], by_formula[name], rtol=1e-11)
    for row in (3, 700):
        assert np.isclose(by_solving(askew, by_instant, row, "T"), by_instant["T"][row], rtol=1e-12)
    road = pyarrow.parquet.read_table(tmp_path / "rows" / "rows-000000.parquet").column("road")
    assert set(road.to_pylist()) == {"instant"}


def test_several_solutions_are_no_answer() -> None:
    study = poinsot.study(poinsot.Problem.from_text(TOP, "top.yaml"), {"S": [400.0, 20.0]})
    assert study.counts.answered == 0 and "2 solutions" in study.reasons[0] and set(study.reasons) == {0, 1}
    # At a right angle the quadratic term is gone, and with it the second root.
    problem = poinsot.Problem.from_text(TOP.replace("b: 40 deg", "b: 90 deg"), "top.yaml")
    study = poinsot.study(problem, {"S": [400.0, 300.0]})
    spin = 0.3 * 0.5 * 0.04**2
    assert np.allclose(study["P"], 0.5 * 9.80665 * 0.75 * 0.12 / (spin * study["S"]), rtol=1e-9)


def test_draws_have_their_distributions(askew: poinsot.Problem) -> None:
    for sampling in ("random", "latin hypercube", "sobol"):
        study = poinsot.study(
            askew,
            {"m": poinsot.normal("8 kg", "0.2 kg"), "r": poinsot.uniform(0.14, 0.16), "b": poinsot.tolerance("20 deg", "0.6 deg")},
            ["T"],
            rows=4096,
            seed=3,
            sampling=sampling,
        )
        m, r, b = study["m"], study["r"], study["b"]
        # Five standard errors of the mean and of the deviation.
        assert abs(m.mean() - 8) < 5 * 0.2 / 64 and abs(m.std() - 0.2) < 5 * 0.2 / 64 / np.sqrt(2)
        assert 0.14 <= r.min() < 0.1402 and 0.1598 < r.max() <= 0.16
        assert np.abs(b - np.radians(20)).max() <= np.radians(0.6) * (1 + 1e-15)
        assert abs(b.std() - np.radians(0.2) * 0.98658) < np.radians(0.2) * 5 / 64
        assert np.abs(np.corrcoef([m, r, b]) - np.eye(3)).max() < 5 / 64
        assert np.allclose(study["T"], m * r**2 * (40 * np.pi) ** 2 * (1 + np.cos(b) ** 2) / 8, rtol=1e-13)


def test_a_row_follows_from_its_seed_and_number(askew: poinsot.Problem) -> None:
    over = {"m": poinsot.normal(8, 0.2), "n": ["1000 rpm", "2000 rpm"], "b": poinsot.uniform(0.1, 0.2)}
    for sampling in ("random", "latin hypercube", "sobol"):
        whole = poinsot.study(askew, over, ["T"], rows=100, seed=5, sampling=sampling)
        parts = poinsot.study(askew, over, ["T"], rows=100, seed=5, sampling=sampling, shard_rows=7, threads=3)
        assert all((whole[name] == parts[name]).all() for name in whole)
        for row in (0, 41, 199):
            assert whole.case(row) == parts.case(row)
            assert np.isclose(by_solving(askew, whole, row, "T"), whole["T"][row], rtol=1e-12)
        assert (whole["m"][:100] == whole["m"][100:]).all()
        other = poinsot.study(askew, over, ["T"], rows=100, seed=6, sampling=sampling)
        assert (whole["m"] != other["m"]).all()


def contents(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in sorted(folder.iterdir())}


def test_draws_are_made_once_for_all_points_of_a_grid(askew: poinsot.Problem, monkeypatch: pytest.MonkeyPatch) -> None:
    from poinsot.studies import draws, plan

    asked: list[int] = []

    def counted(*arguments: Any) -> Any:
        asked.append(arguments[-1])
        return draws.unit_draws(*arguments)

    monkeypatch.setattr(plan, "unit_draws", counted)
    speeds = np.linspace(100, 300, 2000)
    poinsot.study(askew, {"n": speeds}, "T", shard_rows=500)
    assert not asked
    whole = poinsot.study(askew, {"n": speeds, "m": poinsot.normal(8, 1)}, "T", rows=7, shard_rows=5000)
    assert len(asked) < 10
    np.testing.assert_array_equal(whole["m"][7 * 1234 : 7 * 1235], whole["m"][:7])
    for row in (0, 5001, 13_999):
        assert askew.solve(whole.case(row))["T"].si == pytest.approx(whole["T"][row], rel=1e-9)
        assert [column[0] for column in whole.plan.values(row, 1)] == [whole["n"][row], whole["m"][row]]


def test_files_have_the_same_bytes_for_any_number_of_threads(askew: poinsot.Problem, tmp_path: Path) -> None:
    over = {"m": poinsot.normal(8, 3), "b": poinsot.uniform(-0.5, 0.5)}
    made = []
    for threads in (1, 2, 5):
        study = poinsot.study(
            askew, over, rows=3000, seed=1, out=tmp_path / str(threads), shard_rows=500, threads=threads
        )
        made.append(contents(tmp_path / str(threads)))
    assert len(made[0]) == 8 and made[0] == made[1] == made[2]
    manifest = json.loads(made[0]["_manifest.json"])
    assert manifest["rows"] == 3000 and manifest["by_formula"] > 2900
    assert manifest["answered"] == 3000 - len(study.reasons) < 3000
    kept = poinsot.study(askew, over, rows=3000, seed=1)
    opened = poinsot.Study.open(tmp_path / "2")
    for name in kept:
        assert np.array_equal(kept[name], opened[name], equal_nan=True)
    assert kept.reasons == opened.reasons


def test_another_study_is_not_overwritten(askew: poinsot.Problem, tmp_path: Path) -> None:
    poinsot.study(askew, {"m": [1.0, 2.0]}, ["T"], out=tmp_path / "a")
    with pytest.raises(poinsot.StudyError, match="differs in: over"):
        poinsot.study(askew, {"m": [1.0, 3.0]}, ["T"], out=tmp_path / "a")
    (tmp_path / "b").mkdir()
    (tmp_path / "b" / "mine").write_text("dear")
    with pytest.raises(poinsot.StudyError, match="other files"):
        poinsot.study(askew, {"m": [1.0, 3.0]}, ["T"], out=tmp_path / "b")
    assert [path.name for path in (tmp_path / "b").iterdir()] == ["mine"]


@pytest.mark.parametrize(
    ("over", "arguments", "message"),
    [
        ({"mm": [1.0]}, {}, "did you mean 'm'"),
        ({"m": [1.0]}, {"asks": ["TT"]}, "did you mean 'T'"),
        ({"m": ["1 m"]}, {}, "mass"),
        ({"m": []}, {}, "empty"),
        ({"m": "8 kg"}, {}, "expected a list"),
        ({}, {}, "nothing differs"),
        ({"m": poinsot.normal(8, 1)}, {}, "how many draws"),
        ({"m": poinsot.normal(8, 0)}, {"rows": 3}, "more than zero"),
        ({"m": poinsot.uniform(8, 7)}, {"rows": 3}, "smaller to the larger"),
        ({"m": [1.0]}, {"rows": 3}, "there are none"),
        ({"m": [1.0]}, {"sampling": "sobel"}, "did you mean 'sobol'"),
        ({"m": [1.0]}, {"sets": {"m": 2.0}}, "cannot both"),
        ({"m": [float("nan")]}, {}, "no value"),
        ({"m": [1.0]}, {"sensitivities": ["n"]}, "does not differ from row to row"),
    ],
)
def test_mistakes(askew: poinsot.Problem, over: dict[str, object], arguments: dict[str, object], message: str) -> None:
    with pytest.raises((ValueError, TypeError), match=message):
        poinsot.study(askew, over, **arguments)  # type: ignore[arg-type]


def test_what_a_study_tells(askew: poinsot.Problem) -> None:
    over = {"n": poinsot.normal("1200 rpm", "12 rpm"), "m": poinsot.normal(8, 0.01), "b": poinsot.tolerance("20 deg", "3 deg")}
    study = poinsot.study(askew, over, ["B"], rows=2000)
    b = study["B.y"]
    assert study.summary().loc["B.y", "mean"] == pytest.approx(b.mean())
    limit = float(np.median(b))
    assert study.yield_of(lambda rows: rows["B.y"] <= limit) == pytest.approx(0.5, abs=1e-3)
    assert b[study.worst("B.y")] == b.max() and b[study.worst("B.y", least=True)] == b.min()
    assert list(study.tornado("B.y").index) == ["b", "n", "m"]
    assert "B.y / N" in study._repr_html_()


def test_a_plan_is_plain_data(askew: poinsot.Problem) -> None:
    plan = poinsot.study(askew, {"n": poinsot.span(1, 2, 3), "m": poinsot.normal(8, 1)}, ["T"], rows=5).plan
    assert Plan.from_json(plan.to_json()) == plan and list(Plan.from_json(plan.to_json()).over) == ["n", "m"]
    assert plan.total == 15 and plan.grid == (3,)


def test_sensitivities_are_differences_of_rows(askew: poinsot.Problem) -> None:
    step = 1e-4
    speeds = [125.0 + step * k for k in (-1, 0, 1)]
    for formulas in (True, False):
        study = poinsot.study(
            askew, {"n": speeds, "b": ["10 deg", "20 deg"]}, ["B"], formulas=formulas, sensitivities=["n", "b"]
        )
        assert study.answers == ["B.x", "B.y", "B.z"] and len(study.sensitivities) == 6 and not study.reasons
        b, by_n = study["B.y"].reshape(3, 2), study["B.y by n"].reshape(3, 2)
        assert by_n[1] == pytest.approx((b[2] - b[0]) / (2 * step), rel=1e-6)
        assert study.units["B.y by n"] == "kg*m/rad/s"
        assert study.counts.refuted == 0
        assert "B.y by b" in study.frame().columns


def test_frames_in_other_units(askew: poinsot.Problem) -> None:
    study = poinsot.study(askew, {"n": ["1200 rpm", "2400 rpm"]}, ["B", "T"], sensitivities=["n"])
    frame = study.frame(units={"n": "rpm", "B": "kN", "T": "kJ"})
    assert frame["n"].to_list() == pytest.approx([1200, 2400]) and frame["B.y"].to_list() == pytest.approx(study["B.y"] / 1000)
    assert frame["B.y by n"].to_list() == study["B.y by n"].tolist()
    assert frame.attrs["units"] == {**study.units, "n": "rpm", "B.x": "kN", "B.y": "kN", "B.z": "kN", "T": "kJ"}
    assert study.frame().attrs["units"] == study.units
    summary = study.summary(units={"B.y": "kN"})
    assert summary.loc["B.y", "max"] == pytest.approx(study["B.y"].max() / 1000) and summary.attrs["units"]["B.y"] == "kN"


def test_sensitivities_of_a_span_that_begins_at_zero() -> None:
    """No formula holds at e = 0, where the change of |B| changes its sign: B = m g a/L and m e n^2 a/L, at right angles."""
    text = """\
given: {m: 12 kg, e: 0.05 mm, n: 2950 rpm, a: 180 mm, L: 420 mm, g: 9.81 m/s^2}
points: {A: [0, 0, 0], B: [L, 0, 0], G: [a, e, 0]}
bodies: {fan: {mass: m, center: G, inertia: {about: G, x: 0.12 kg*m^2, y: 0.08 kg*m^2, z: 0.08 kg*m^2}}}
joints: {shaft: {revolute: A->B, at: A, to: fan, rate: n, accel: 0, supports: {A: [x, y, z], B: [y, z]}}}
gravity: -z
ask: {peak: norm(reaction(B))}
"""
    over = {"e": poinsot.span("0 mm", "0.1 mm", 3)}
    study = poinsot.study(poinsot.Problem.from_text(text), over, "peak", sensitivities=["e"])
    assert study.reasons == {}
    e, n = study["e"], 2950 * np.pi / 30
    assert study["peak"] == pytest.approx(12 * 180 / 420 * np.hypot(9.81, e * n**2), rel=1e-12)
    assert study["peak by e"] == pytest.approx(12 * 180 / 420 * e * n**4 / np.hypot(9.81, e * n**2), rel=1e-6, abs=1)


def test_a_vector_is_its_components_side_by_side(askew: poinsot.Problem) -> None:
    study = poinsot.study(askew, {"n": [1.0, 2.0, 3.0]}, "B", sensitivities=["n"])
    assert study["B"].shape == (3, 3)
    np.testing.assert_array_equal(study["B"][:, 1], study["B.y"])
    with pytest.raises(KeyError, match="no column of the study 'A'"):
        study["A"]
    with pytest.raises(TypeError, match="from_file"):
        poinsot.study("askew.yaml", {"n": [1.0]})  # type: ignore[arg-type]


# Laid on it at rest, it stays while tan(b) < 1/2, and else slides; a planar problem, whose vectors have two components.
INCLINE = """\
title: A block laid on an incline
plane: [x, y]
given: {m: 5 kg, b: 25 deg, mu: 0.5, k: 0.4}
points: {C: [0, 0]}
directions: {down: [cos(b), -sin(b)], out: [sin(b), cos(b)]}
bodies: {block: {particle: C, mass: m}}
contacts: {slope: {of: block, at: C, normal: out, friction: {static: mu, kinetic: k}}}
gravity: -y
facts: rest
ask: {F: component(friction(slope on block) along down), a: acceleration(block)}
"""


def test_friction_finds_its_state_in_each_row() -> None:
    problem = poinsot.Problem.from_text(INCLINE, "incline.yaml")
    study = poinsot.study(problem, {"b": poinsot.span("5 deg", "60 deg", 12)})
    assert "sticks" in study.no_formulas
    assert study.counts.answered == 12 and study.counts.by_formula == study.counts.by_instant == 0
    b, g = study["b"], 9.80665
    slides = np.tan(b) > 0.5
    assert 3 < np.count_nonzero(slides) < 9
    assert np.allclose(study["F"], -5 * g * np.where(slides, 0.4 * np.cos(b), np.sin(b)), rtol=1e-9)
    along = np.where(slides, g * (np.sin(b) - 0.4 * np.cos(b)), 0)
    assert study.answers == ["F", "a.x", "a.y"] and study.units["a.x"] == "m/s^2"
    assert np.allclose(study["a"], np.stack([along * np.cos(b), -along * np.sin(b)], axis=1), rtol=1e-9, atol=1e-9)


# The same, smooth: each row by its formula.
def test_lists_are_columns() -> None:
    text = INCLINE.replace(", friction: {static: mu, kinetic: k}", "").replace(", mu: 0.5, k: 0.4", "")
    text = text.replace("F: component(friction(slope on block) along down), ", "N: [normal_force(slope), 2*normal_force(slope)], ")
    problem = poinsot.Problem.from_text(text, "smooth.yaml")
    for formulas in (True, False):
        study = poinsot.study(problem, {"b": poinsot.span("5 deg", "60 deg", 12)}, formulas=formulas)
        assert study.answers == ["N.1", "N.2", "a.x", "a.y"] and study.counts.answered == 12
        assert (study.counts.by_formula == 12) == formulas
        b, g = study["b"], 9.80665
        assert np.allclose(study["N"], 5 * g * np.cos(b)[:, None] * [1, 2], rtol=1e-9)
        assert np.allclose(study["a"], g * np.stack([np.sin(b) * np.cos(b), -np.sin(b) ** 2], axis=1), rtol=1e-9)


def test_what_is_asked_of_a_study(askew: poinsot.Problem, tmp_path: Path) -> None:
    import pandas

    over = {"b": poinsot.tolerance("20 deg", "0.3 deg")}
    study = poinsot.study(askew, over, ["B"], rows=50, out=tmp_path / "rows")
    # Readers of folders take the rows and leave the plan and the manifest.
    frame = pandas.read_parquet(tmp_path / "rows")
    assert len(frame) == 50 and np.array_equal(frame["B.y"], study["B.y"])
    part = float((study["B.y"] < 457).mean())
    assert 0 < part < 1 and study.yield_of(study["B.y"] < 457) == study.yield_of(lambda s: s["B.y"] < 457) == part
    # A place in three columns together would be that of no row.
    for call in (study.worst, study.tornado):
        with pytest.raises(ValueError, match="expected B.x, B.y, B.z"):
            call("B")
    with pytest.raises(TypeError, match="truth value for each row"):
        study.yield_of("B.y < 457")  # type: ignore[arg-type]
    with pytest.raises(poinsot.StudyError, match="compares random values"):
        poinsot.study(askew, {"n": [100, 200]}).tornado("T")
