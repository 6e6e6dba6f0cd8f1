"""Models of the engine from problem files, and their motion, against what the problems answer and published numbers."""

import pickle
from pathlib import Path

import numpy as np
import pytest

import poinsot
from poinsot import engine

# Bruels, Cardona, Arnold 2012: a fast top on a ball joint.
TOP = """\
given: {m: 15 kg, g: 9.81 m/s^2}
points: {O: [0, 0, 0], G: [0, 1 m, 0]}
bodies:
  top: {mass: m, center: G, inertia: {x: 0.234375 kg*m^2, y: 0.46875 kg*m^2, z: 0.234375 kg*m^2, xy: 0, yz: 0, zx: 0}}
joints:
  tip: {ball: O, to: top}
gravity: -z
instants:
  start: {angular_velocity(top): [0, 150 rad/s, -4.61538 rad/s]}
ask:
  w: angular_velocity(top)
"""

RODS = """\
given: {m: 2 kg, M: 3 kg, a: 0.6 m, b: 0.4 m, n: 3 rad/s, c: 0.1 N*m*s}
points: {O: [0, 0, 0], P: [a, 0, 0], Q: [a, 0, b], S: [a, 0, -b]}
bodies:
  first: {rod: [O, P], mass: m}
  second: {wire: [S, P, Q], mass: M}
joints:
  upper: {revolute: z, at: O, to: first, angle: phi}
  lower: {revolute: x, at: P, from: first, to: second, angle: psi}
gravity: [0, -g, 0]
instants:
  start: {phi': n, psi': 1 rad/s}
ask:
  T: kinetic_energy(system)
"""


def test_a_published_top() -> None:
    start = engine.from_problem(poinsot.Problem.from_text(TOP))
    model = start.model
    assert model.names == ["top"] and start.others == [] and not any(model.prescribed)
    np.testing.assert_array_equal(start.origins["top"], 0)
    q, v = engine.advance(model, start.q, start.v, np.zeros(3), 1e-5, steps=1000)
    # The numbers of the paper's authors at 0.01 s, in quadruple precision.
    assert (engine.rotation(model, q, "top") @ v)[1] == pytest.approx(149.8473939540758, rel=1e-11)
    center = [0.0461135970540, 0.9989350036093, -0.0015474917851]
    np.testing.assert_allclose(engine.position(model, q, "top", [0, 1, 0]), center, atol=1e-10)


def test_the_motion_is_that_of_the_problem() -> None:
    problem = poinsot.Problem.from_text(RODS)
    start = engine.from_problem(problem, m=2.5)
    model = start.model
    np.testing.assert_allclose(start.v, [3, 1], rtol=1e-12)
    followed = problem.motion(m=2.5)([0, 0.5], "phi", "psi", "phi'", "psi'", T="kinetic_energy(system)", P="center(second)")
    assert engine.kinetic_energy(model, start.q, start.v) == pytest.approx(followed["T"][0], rel=1e-12)
    q, v = engine.advance(model, start.q, start.v, np.zeros(2), 1e-3, steps=500)
    np.testing.assert_allclose(q, [followed["phi"][1], followed["psi"][1]], atol=1e-9)
    np.testing.assert_allclose(v, [followed["phi'"][1], followed["psi'"][1]], atol=1e-8)
    center = np.array([0.6, 0, 0]) - start.origins["second"]
    np.testing.assert_allclose(engine.position(model, q, "second", center), followed["P"][1], atol=1e-9)


def test_many_at_once() -> None:
    """A batch is its cases, whatever the threads; half the step leaves a sixteenth of the error."""
    start = engine.from_problem(poinsot.Problem.from_text(TOP))
    model, random = start.model, np.random.default_rng(6)
    v = start.v[:, None] + random.normal(size=(3, 21))
    q = np.repeat(start.q[:, None], 21, axis=1)
    tau = random.normal(size=(3, 21)) * 10

    def at(dt: float, steps: int) -> engine.Array:
        return engine.advance(model, q, v, tau, dt, steps=steps).v

    exact = at(1e-5, 2000)
    errors = [np.abs(at(dt, round(0.02 / dt)) - exact).max() for dt in (2e-4, 1e-4)]
    assert 13 < errors[0] / errors[1] < 19
    both = engine.advance(model, q, v, tau, 1e-4, steps=50, threads=3)
    np.testing.assert_array_equal(both.v, engine.advance(model, q, v, tau, 1e-4, steps=50).v)
    for k in (0, 20):
        one = engine.advance(model, q[:, k], v[:, k], tau[:, k], 1e-4, steps=50)
        np.testing.assert_allclose(both.q[:, k], one.q, rtol=1e-11, atol=1e-12)
        np.testing.assert_allclose(both.v[:, k], one.v, rtol=1e-11)
    assert engine.advance(model, q, v, tau, 1e-4, steps=0).q.tobytes() == q.tobytes()
    with pytest.raises(ValueError, match="steps is a whole number, 0 or more, not -1"):
        engine.advance(model, q, v, tau, 1e-4, steps=-1)


def test_what_moves_as_stated_is_prescribed() -> None:
    """A rod that swings in a frame, which turns evenly: a sphere's pendulum with one angle known."""
    builder = engine.ModelBuilder()
    builder.set_gravity([0, 0, -9.81])
    builder.add_body("frame", "ground", "revolute", axis=[0, 0, 1], mode="prescribed")
    builder.add_body("bob", "frame", "revolute", axis=[0, 1, 0], mass=1.0, center=[0, 0, -0.5])
    model = builder.build()
    assert model.prescribed == [True, False]
    q, v = engine.advance(model, [0, 1.0], [4.0, 0], [0, 0], 1e-3, steps=700)
    assert q[0] == pytest.approx(2.8, rel=1e-12) and v[0] == 4.0
    # y' ^2/2 - (W sin y)^2/2 - (g/l) cos y stays.
    kept = [y_rate**2 / 2 - (4 * np.sin(y)) ** 2 / 2 - 9.81 / 0.5 * np.cos(y) for y, y_rate in ((1.0, 0.0), (q[1], v[1]))]
    assert kept[1] == pytest.approx(kept[0], rel=1e-9) and abs(v[1]) > 0.1


def test_examples_begin_and_go_on_as_they_answer() -> None:
    """Energies and momenta of every example that is a tree, at the start and, where nothing else acts, a little later."""
    begun, gone_on, step = 0, 0, 1e-3
    for path in sorted(Path(__file__).parents[2].glob("examples/[mpt][eu]*/*.yaml")):
        problem = poinsot.Problem.from_file(path)
        try:
            start = engine.from_problem(problem, timeout=5)
            told = problem.motion(timeout=5)([0, step], T="kinetic_energy(system)", p="momentum(system)", timeout=5)
        except (poinsot.NoAnswer, poinsot.TimedOut):
            continue
        model, state = start.model, engine.State(start.q, start.v)
        # Accelerations that are stated and are not zero would have to be given, and so would forces.
        follows = not start.others and "time" not in problem.text and "accel" not in problem.text.replace("accel: 0", "")
        # How a free slender rod turns about its own line nothing tells.
        follows = follows and np.linalg.cond(engine.mass_matrix(model, start.q)) < 1e14
        for instant in (0, 1) if follows else (0,):
            if instant == 1:
                state = engine.advance(model, *state, np.zeros(model.nv), step / 20, steps=20)
                gone_on += 1
            energy = float(engine.kinetic_energy(model, *state))
            momentum = engine.momentum(model, *state)[:3]
            if len(told.axes["p"]) == 2:  # of a planar problem
                momentum = momentum[["xyz".index(axis) for axis in told.axes["p"]]]
            assert energy == pytest.approx(told["T"][instant], rel=1e-8, abs=1e-8), path
            np.testing.assert_allclose(momentum, told["p"][instant], rtol=1e-8, atol=1e-8 * (1 + np.abs(momentum).max()))
        begun += 1
    assert begun > 60 and gone_on > 30


def test_what_acts_beside_weights_is_named() -> None:
    damped = RODS.replace("angle: psi}", "angle: psi, damping: c}")
    assert engine.from_problem(poinsot.Problem.from_text(damped)).others == ["lower"]
    pushed = RODS.replace("angle: psi}", "angle: psi, couple: c*psi'/s}").replace("{m: 2 kg,", "{s: 1 s, m: 2 kg,").replace("N*m*s", "N*m*s^2")
    assert engine.from_problem(poinsot.Problem.from_text(pushed)).others == ["lower"]
    loaded = RODS + "loads:\n  pull: {body: second, at: Q, force: [0, 1 N, 0]}\n"
    assert engine.from_problem(poinsot.Problem.from_text(loaded)).others == ["pull"]


ROLLING = """\
given: {r: 0.2 m, m: 3 kg}
points: {O: [0, 0, r], C: [0, 0, 0]}
bodies:
  ball: {sphere: {center: O, radius: r}, mass: m}
contacts:
  floor: {of: ball, at: C, normal: z, no_slip: true}
instants:
  start: rest
ask:
  T: kinetic_energy(ball)
"""


def test_the_start_is_sent_to_other_processes() -> None:
    start = engine.from_problem(poinsot.Problem.from_text(TOP, "top.yaml"))
    again = pickle.loads(pickle.dumps(start))
    for one in (start, again):
        np.testing.assert_array_equal(engine.mass_matrix(one.model, one.q), engine.mass_matrix(start.model, start.q))


def test_what_is_no_tree_is_refused() -> None:
    problem = poinsot.Problem.from_text(ROLLING)
    with pytest.raises(poinsot.NoAnswer, match="no tree of joints alone"):
        engine.from_problem(problem)
    with pytest.raises(poinsot.NoAnswer):
        engine.from_problem(poinsot.Problem.from_text("letters: {m: kg}\n" + RODS.replace("m: 2 kg, ", "")))
    with pytest.raises(poinsot.StatementError):
        engine.from_problem(poinsot.Problem.from_text(RODS), nothing=3)
