"""Motions against closed forms, conservation and SciPy-free integration by hand."""

import numpy as np
import pandas
import pytest
from scipy.spatial.transform import Rotation

import poinsot

PENDULUM = """\
title: A bar that swings
given: {m: 3 kg, l: 2 m, swing: 60 deg}
points: {O: [0, 0, 0], P: [0, -l, 0]}
bodies: {bar: {rod: [O, P], mass: m}}
joints: {pin: {revolute: z, at: O, to: bar, angle: theta}}
gravity: -y
instants:
  start: {theta: swing, theta': 0}
ask: {T: mass(bar)}
"""

FREE = """\
title: A body that turns freely
given: {I: 1 kg*m^2, m: 1 kg}
points: {G: [0, 0, 0]}
bodies:
  b: {mass: m, center: G, inertia: {about: G, x: I, y: 2*I, z: 3*I}}
joints: {free: {ball: G, to: b}}
gravity: none
instants:
  start: {angular_velocity(b): '[0.1 rad/s, 5 rad/s, 0.1 rad/s]'}
ask: {T: kinetic_energy(b)}
"""


PLANAR = """\
title: A bar that swings in a plane
plane: [x, y]
given: {m: 3 kg, l: 2 m}
points: {O: [0, 0], P: [l, 0]}
bodies: {bar: {rod: [O, P], mass: m}}
joints: {pin: {revolute: z, at: O, to: bar, angle: theta}}
gravity: -y
instants: {start: {theta: 0, theta': 1.5 rad/s}}
ask:
  angular_velocity: angular_velocity(bar)
  velocity: velocity(P of bar)
  reaction: reaction(pin)
  angular_momentum: angular_momentum(bar about O)
"""


@pytest.fixture
def pendulum() -> poinsot.Problem:
    return poinsot.Problem.from_text(PENDULUM, "bar.yaml")


def swing(times: np.ndarray, length: float, start: float, g: float = 9.80665) -> np.ndarray:
    """theta'' = -(3 g / 2 l) sin(theta), by a classical Runge-Kutta method with steps of 0.1 ms."""
    step = 1e-4
    state, values, now = np.array([start, 0.0]), [], 0.0

    def rate(s: np.ndarray) -> np.ndarray:
        return np.array([s[1], -1.5 * g / length * np.sin(s[0])])

    for time in times:
        while now < time - step / 2:
            k1 = rate(state)
            k2 = rate(state + step / 2 * k1)
            k3 = rate(state + step / 2 * k2)
            k4 = rate(state + step * k3)
            state, now = state + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4), now + step
        values.append(state)
    return np.array(values)


def test_attitude_of_a_body(pendulum: poinsot.Problem) -> None:
    """By angles about axes that another library turns, with axes of other names."""
    satellite = poinsot.Problem.from_text(
        """\
axes: [A, B, C]
given: {I: 100 kg*m^2, m: 500 kg}
points: {G: [0, 0, 0]}
bodies: {bus: {mass: m, center: G, inertia: {about: G, A: I, B: 1.2*I, C: 0.8*I}}}
joints: {attitude: {ball: G, to: bus, angles: [yaw: C, pitch: B, roll: A]}}
gravity: none
instants: {start: {yaw: 20 deg, pitch: 0, roll: 0, angular_velocity(bus): [0.01 rad/s, 0.2 rad/s, 0.01 rad/s]}}
ask: {T: kinetic_energy(bus)}
"""
    )
    times = np.linspace(0, 6, 4)
    motion = satellite.motion()
    angles = motion(times)
    turned = Rotation.from_euler("ZYX", np.stack([angles[one] for one in ("yaw", "pitch", "roll")], axis=1))
    assert np.abs(angles["pitch"]).max() > 0.9
    np.testing.assert_allclose(motion.attitude(times, "bus"), turned.as_matrix(), atol=1e-12)
    with pytest.raises(poinsot.StatementError, match="no body 'boss'"):
        motion.attitude(times, "boss")
    with pytest.raises(ValueError, match="a body is turned by an angle"):
        poinsot.Problem.from_text(PLANAR).motion().attitude(times, "bar")


def test_times_that_have_their_unit_with_them(pendulum: poinsot.Problem) -> None:
    seconds = pendulum.motion([0.5, 1.0], "theta")
    for times in (np.array([500, 1000], dtype="timedelta64[ms]"), pandas.to_timedelta([0.5, 1], unit="s")):
        np.testing.assert_array_equal(pendulum.motion(times, "theta")["theta"], seconds["theta"])


def test_frames_in_other_units(pendulum: poinsot.Problem) -> None:
    values = pendulum.motion()([0.0, 0.3], "theta", w="angular_velocity(bar)")
    frame = values.frame(units={"theta": "deg", "w": "rpm"})
    assert frame["theta"].to_list() == pytest.approx(np.degrees(values["theta"])) and frame["theta"].iloc[0] == pytest.approx(60)
    assert frame["w.z"].to_list() == pytest.approx(values["w"][:, 2] * 30 / np.pi)
    assert frame.attrs["units"] == {"time": "s", "theta": "deg", "w.x": "rpm", "w.y": "rpm", "w.z": "rpm"}
    with pytest.raises(KeyError, match="no column 'phi'"):
        values.frame(units={"phi": "deg"})


def test_a_pendulum_against_integration_by_hand(pendulum: poinsot.Problem) -> None:
    times = np.arange(0, 1.05, 0.05)
    values = pendulum.motion()(times, "theta", "theta'", a="angular_acceleration(bar)")
    by_hand = swing(times, 2.0, np.radians(60))
    np.testing.assert_allclose(values["theta"], by_hand[:, 0], atol=1e-10)
    np.testing.assert_allclose(values["theta'"], by_hand[:, 1], atol=1e-10)
    np.testing.assert_allclose(values["a"][:, 2], -1.5 * 9.80665 / 2 * np.sin(by_hand[:, 0]), atol=1e-9)
    assert values["a"].shape == (len(times), 3)
    assert values.units == {"theta": "rad", "theta'": "rad/s", "a": "rad/s^2"}
    assert values.axes["a"] == ["x", "y", "z"]
    assert max(values.checks.values()) < 1e-5


def test_a_motion_is_asked_at_once(pendulum: poinsot.Problem) -> None:
    times = np.linspace(0, 1, 6)
    whole = pendulum.motion(m=2)(times, "theta", "kinetic_energy(bar)")
    at_once = pendulum.motion(times, "theta", "kinetic_energy(bar)", m=2)
    for name in whole:
        np.testing.assert_array_equal(at_once[name], whole[name])
    np.testing.assert_array_equal(pendulum.motion(times)["theta"], whole["theta"])


def test_planar_motions_are_told_as_planar_answers() -> None:
    problem = poinsot.Problem.from_text(PLANAR)
    quantities = ["angular_velocity(bar)", "velocity(P of bar)", "reaction(pin)", "angular_momentum(bar about O)"]
    values = problem.motion()([0, 0.3], *quantities, power="angular_velocity(bar) * 2 N*m")
    for name in quantities:
        answer = problem.solve()[name.split("(")[0]]
        np.testing.assert_allclose(values[name][0], answer.si, rtol=1e-9, atol=1e-9)
        assert values.axes.get(name, []) == answer.axes and values.units[name] == answer.unit
    assert values["velocity(P of bar)"].shape == (2, 2) and values["power"].shape == (2,)
    np.testing.assert_allclose(values["angular_momentum(bar about O)"], 4 * values["angular_velocity(bar)"], rtol=1e-9)
    assert list(values.frame().columns) == [
        "angular_velocity(bar)", "velocity(P of bar).x", "velocity(P of bar).y", "reaction(pin).x", "reaction(pin).y",
        "angular_momentum(bar about O)", "power",
    ]  # fmt: skip
    # On the axes of the bar, which it turns about the normal.
    turned = problem.motion()([0.3], "velocity(P of bar)", "theta", axes="bar")
    angle = turned["theta"][0]
    x, y = values["velocity(P of bar)"][1]
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    np.testing.assert_allclose(turned["velocity(P of bar)"][0], turn @ [x, y], rtol=1e-8, atol=1e-9)
    with pytest.raises(poinsot.StatementError, match="plane"):
        problem.motion([0], "principal_axes(bar)")


def test_values_that_are_set(pendulum: poinsot.Problem) -> None:
    times = [0.5]
    values = pendulum.motion(l="1 m", swing=0.5)(times)
    np.testing.assert_allclose(values["theta"], swing(np.array(times), 1.0, 0.5)[:, 0], atol=1e-10)


def test_times_in_any_order_and_asked_again(pendulum: poinsot.Problem) -> None:
    motion = pendulum.motion()
    times = np.linspace(0, 3, 31)
    forward = motion(times)["theta"]
    shuffled = np.random.default_rng(1).permutation(31)
    np.testing.assert_array_equal(motion(times[shuffled])["theta"], forward[shuffled])
    np.testing.assert_array_equal(pendulum.motion()(3.0)["theta"], forward[-1:])
    assert motion.coordinates == ["theta"]


def test_energy_is_kept_where_forces_are_asked(pendulum: poinsot.Problem) -> None:
    times = np.linspace(0, 2, 50)
    values = pendulum.motion()(times, "theta", "reaction(pin)", T="kinetic_energy(bar)")
    height = -np.cos(values["theta"])  # of the center of the bar, 1 m from the pin
    energy = values["T"] + 3 * 9.80665 * height
    np.testing.assert_allclose(energy, energy[0], rtol=1e-9)
    # m a_G = R - m g y, with a_G from the angle.
    rate = np.sqrt(2 * values["T"] / (3 * 4 / 3))
    alpha = -1.5 * 9.80665 / 2 * np.sin(values["theta"])
    radial = np.stack([np.sin(values["theta"]), -np.cos(values["theta"])], axis=1)
    tangent = np.stack([np.cos(values["theta"]), np.sin(values["theta"])], axis=1)
    force = 3 * (alpha[:, None] * tangent - (rate**2)[:, None] * radial) + [0, 3 * 9.80665]
    np.testing.assert_allclose(values["reaction(pin)"][:, :2], force, atol=1e-7)


def test_a_body_that_turns_freely_against_many_digits() -> None:
    """Torque-free motion after 100 s, computed once with 25 digits."""
    values = poinsot.Problem.from_text(FREE).motion()([100.0], "angular_velocity(b)", axes="b")
    wanted = [0.146653502117685105, -4.998849142584382705, 0.117625464481380999969]
    np.testing.assert_allclose(values["angular_velocity(b)"][0], wanted, atol=1e-9)


def test_frames_have_units(pendulum: poinsot.Problem) -> None:
    frame = pendulum.motion()([0.0, 0.5], "theta", v="velocity(P of bar)").frame()
    assert frame.columns.to_list() == ["theta", "v.x", "v.y", "v.z"]
    assert frame.attrs["units"]["v.x"] == "m/s"
    assert frame.index.to_list() == [0.0, 0.5]


@pytest.mark.parametrize(
    "quantity, message",
    [("thetta", "theta"), ("kinetik_energy(bar)", "kinetic_energy"), ("theta +", "ends too early"), ("theta == 0", "no number")],
)
def test_wrong_quantities(pendulum: poinsot.Problem, quantity: str, message: str) -> None:
    with pytest.raises(poinsot.StatementError, match=message):
        pendulum.motion()([0.0, 1.0], quantity)


def test_wrong_times(pendulum: poinsot.Problem) -> None:
    motion = pendulum.motion()
    for times in ([-1.0], [float("nan")], [float("inf")]):
        with pytest.raises(poinsot.StatementError, match="not negative"):
            motion(times)
    with pytest.raises(ValueError, match="2 dimensions"):
        motion([[0.0]])
    assert len(motion([])["theta"]) == 0


def test_open_letters_are_named() -> None:
    text = PENDULUM.replace("l: 2 m, ", "").replace("points:", "letters: {l: m}\npoints:")
    with pytest.raises(poinsot.NoAnswer, match="needs values for l"):
        poinsot.Problem.from_text(text).motion()


def test_what_is_not_determined_is_refused() -> None:
    problem = poinsot.Problem.from_text(
        """\
title: A bar on two hinges along one line
given: {m: 2 kg}
points: {O: [0, 0, 0], P: [1 m, 0, 0], A: [0, 0, 0], B: [0, 0, 1 m]}
bodies: {bar: {rod: [O, P], mass: m}}
joints: {pin: {revolute: A->B, at: A, to: bar, angle: theta, supports: {A: [x, y, z], B: [x, y, z]}}}
gravity: -y
instants: {start: {theta: 0, theta': 0}}
ask: {T: mass(bar)}
"""
    )
    with pytest.raises(poinsot.NoAnswer):
        problem.motion()([0.0, 1.0], "reaction(A)")


def test_a_motion_can_be_asked_after_a_deadline(pendulum: poinsot.Problem) -> None:
    motion = pendulum.motion()
    with pytest.raises(poinsot.TimedOut):
        motion(np.linspace(0, 1000, 100_000), "reaction(pin)", timeout=0.2)
    assert motion(0.0)["theta"] == pytest.approx([np.radians(60)])


def test_without_names_of_coordinates_it_is_said_what_to_ask(askew: poinsot.Problem) -> None:
    with pytest.raises(ValueError, match="say which quantities"):
        askew.motion()([0, 1])
