"""scenes.py: scenes with friction, rolling and blows beside MuJoCo: how exact an answer is, and what it costs.

Each scene has a closed form, from which the error is taken, relative to a length of the scene. poinsot solves the problem
from its text to the answer, with all checks; MuJoCo (Todorov, Erez, Tassa 2012) steps its model at step sizes from large to
small, and is charged for the steps alone: shown are the least error that it reaches at poinsot's cost, and at any cost.
Contacts there are soft: as stiff as the step size bears, and in blows with the damping that gives the stated restitution.
Times are those of the processor, for one thread, the least of three runs.

Chrono (Tasora et al. 2016) has no package for this installer. Two scenes are those of its own tests against closed forms
(src/tests/unit_tests/smc_contact, utest_SMC_sliding_gravity and utest_SMC_cor_normal): beside them stands the error that
these tests allow, and the steps that they take for it.

usage: scenes.py [SECONDS]    (MuJoCo takes no smaller step when one run takes so long, 1 s)
"""

from __future__ import annotations

import importlib
import importlib.util
import math
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

import poinsot

G = 9.80665
STEPS = (1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6)


@dataclass(frozen=True)
class Scene:
    name: str
    text: str  # the problem; it asks for `there`
    exact: list[float]
    length: float  # of which errors are a part
    time: float  # at which it is asked
    bodies: str  # of MuJoCo's model
    start: list[float]  # velocities there
    friction: float
    first: int = 0  # of MuJoCo's three coordinates that are asked about
    restitution: float | None = None
    gravity: tuple[float, float, float] = (0, 0, -G)
    chrono: str = ""  # what Chrono's test of this scene allows


def ball_that_begins_to_roll() -> Scene:
    r, v, spin, mu, end = 0.11, 7.0, 30.0, 0.1, 4.0
    slip = np.array([v, spin * r])
    grips = 2 * np.linalg.norm(slip) / (7 * mu * G)
    friction = -mu * G * slip / np.linalg.norm(slip)
    rolling = np.array([v, 0]) + friction * grips
    exact = np.array([v, 0]) * grips + friction * grips**2 / 2 + rolling * (end - grips)
    text = f"""
points: {{C: [0, 0, 0], G: [0, 0, {r} m]}}
bodies: {{ball: {{sphere: {{center: G, radius: {r} m}}, mass: 6 kg}}}}
contacts: {{lane: {{of: ball, at: C, normal: z, friction: {mu}}}}}
gravity: -z
instants: {{start: {{velocity(ball): ['{v} m/s', 0, 0], angular_velocity(ball): ['{spin} rad/s', 0, 0]}}}}
ask: {{there: position(ball) @ {end} s}}
"""
    bodies = f"""
<geom name="ground" type="plane" size="100 100 1"/>
<body pos="0 0 {r}"><freejoint/><geom name="body" type="sphere" size="{r}" mass="6"/></body>"""
    return Scene("ball that begins to roll", text, [exact[0], exact[1], r], 20, end, bodies, [v, 0, 0, spin, 0, 0], mu)


def puck_across_an_incline() -> Scene:
    slope, k, u, end = math.radians(20), 2.0, 3.0, 5.0
    unit = u**2 / (G * math.sin(slope))
    across, down = unit * 2 * k / (4 * k**2 - 1), unit / (4 * (k**2 - 1))
    mu = k * math.tan(slope)
    text = f"""
points: {{C: [0, 0, 0]}}
directions: {{pull: [sin(20 deg), 0, -cos(20 deg)]}}
bodies: {{puck: {{particle: C, mass: 0.2 kg}}}}
contacts: {{slope: {{of: puck, at: C, normal: z, friction: {k}*tan(20 deg)}}}}
gravity: pull
facts: {{velocity(puck): [0, '{u} m/s', 0]}}
ask: {{there: position(puck) @ {end} s}}
"""
    bodies = f"""
<geom name="ground" type="plane" size="100 100 1"/>
<body><joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 1 0"/><joint type="slide" axis="0 0 1"/>
<geom name="body" type="sphere" size="0.05" pos="0 0 0.05" mass="0.2"/></body>"""
    gravity = (G * math.sin(slope), 0, -G * math.cos(slope))
    return Scene("puck across a rough incline", text, [down, across, 0], 1, end, bodies, [0, u, 0], mu, gravity=gravity)


def block_that_stays() -> Scene:
    mu, end = 0.4, 20.0
    text = f"""
points: {{C: [0, 0, 0]}}
directions: {{pull: [sin(20 deg), 0, -cos(20 deg)]}}
bodies: {{block: {{particle: C, mass: 5 kg}}}}
contacts: {{slope: {{of: block, at: C, normal: z, friction: {mu}}}}}
gravity: pull
facts: rest
ask: {{there: position(block) @ {end} s}}
"""
    bodies = f"""
<geom name="ground" type="plane" size="100 100 1"/>
<body><joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 1 0"/><joint type="slide" axis="0 0 1"/>
<geom name="body" type="sphere" size="0.05" pos="0 0 0.05" mass="5"/></body>"""
    slope = math.radians(20)
    gravity = (G * math.sin(slope), 0, -G * math.cos(slope))
    return Scene("block that stays on an incline", text, [0, 0, 0], 1, end, bodies, [0, 0, 0], mu, gravity=gravity)


def ball_that_bounces() -> Scene:
    r, h, e, end = 0.03, 1.25, 0.7, 1.6
    fall = math.sqrt(2 * h / G)
    begin, speed = fall, e * G * fall
    while end > begin + 2 * speed / G:
        begin, speed = begin + 2 * speed / G, e * speed
    exact = r + speed * (end - begin) - G * (end - begin) ** 2 / 2
    text = f"""
points: {{C: [0, 0, {h} m], G: [0, 0, {h + r} m], O: [0, 0, 0]}}
bodies: {{ball: {{sphere: {{center: G, radius: {r} m}}, mass: 0.2 kg}}}}
contacts: {{floor: {{of: ball, at: C, normal: z, open: true, surface: O, restitution: {e}}}}}
gravity: -z
instants: {{start: rest}}
ask: {{there: position(ball) @ {end} s}}
"""
    bodies = f"""
<geom name="ground" type="plane" size="100 100 1"/>
<body pos="0 0 {h + r}"><freejoint/><geom name="body" type="sphere" size="{r}" mass="0.2"/></body>"""
    return Scene("ball that bounces", text, [0, 0, exact], h, end, bodies, [0] * 6, 0, restitution=e)


def ball_with_backspin() -> Scene:
    r, h, v, spin, e, mu, end = 0.033, 1.0, 1.0, 120.0, 0.75, 0.6, 1.0
    fall = math.sqrt(2 * h / G)
    begin, speed = fall, e * G * fall
    back = (5 * v - 2 * r * spin) / 7
    exact = [v * fall + back * (end - fall), 0, r + speed * (end - begin) - G * (end - begin) ** 2 / 2]
    text = f"""
points: {{C: [0, 0, {h} m], G: [0, 0, {h + r} m], O: [0, 0, 0]}}
bodies: {{ball: {{sphere: {{center: G, radius: {r} m}}, mass: 0.06 kg}}}}
contacts: {{floor: {{of: ball, at: C, normal: z, open: true, surface: O, restitution: {e}, friction: {mu}}}}}
gravity: -z
instants: {{start: {{velocity(ball): ['{v} m/s', 0, 0], angular_velocity(ball): [0, '{-spin} rad/s', 0]}}}}
ask: {{there: position(ball) @ {end} s}}
"""
    bodies = f"""
<geom name="ground" type="plane" size="100 100 1"/>
<body pos="0 0 {h + r}"><freejoint/><geom name="body" type="sphere" size="{r}" mass="0.06"/></body>"""
    return Scene("ball with backspin", text, exact, h, end, bodies, [v, 0, 0, 0, -spin, 0], mu, restitution=e)


def ball_on_a_turntable() -> Scene:
    """A ball that rolls on a table turning at n goes round a circle at 2/7 n (Milne 1948)."""
    r, n, v, out, end = 0.05, 4.0, 0.5, 0.3, 5.0
    turn = 2 * n / 7
    # d velocity/dt = turn k x velocity.
    exact = [out + v / turn * (math.cos(turn * end) - 1), v / turn * math.sin(turn * end), r]
    # Its lowest point moves with the table: v + r w_x = n out.
    wx = (n * out - v) / r
    text = f"""
points: {{O: [0, 0, '-0.1 m'], C: ['{out} m', 0, 0], G: ['{out} m', 0, '{r} m']}}
bodies:
  table: {{cylinder: {{center: O, axis: z, radius: 3 m, length: 0.2 m}}, mass: 1000 kg}}
  ball: {{sphere: {{center: G, radius: {r} m}}, mass: 1 kg}}
joints: {{axle: {{revolute: z, at: O, to: table, rate: {n} rad/s, accel: 0}}}}
contacts: {{top: {{of: ball, against: table, at: C, normal: z, no_slip: true}}}}
gravity: -z
instants: {{start: {{velocity(ball): [0, '{v} m/s', 0], component(angular_velocity(ball) along z): 0}}}}
ask: {{there: position(ball) @ {end} s}}
"""
    bodies = f"""
<body pos="0 0 -0.1"><joint type="hinge" axis="0 0 1"/><geom name="ground" type="cylinder" size="3 0.1" mass="100000"/></body>
<body pos="{out} 0 {r}"><freejoint/><geom name="body" type="sphere" size="{r}" mass="1"/></body>"""
    return Scene("ball on a turntable", text, exact, 0.5, end, bodies, [n, 0, v, 0, wx, 0, 0], 1, first=1)


def block_that_slides_to_rest() -> Scene:
    mu, v, end = 0.5, 5.0, 2.0
    way = v**2 / (2 * mu * G)
    text = f"""
points: {{C: [0, 0, 0]}}
bodies: {{block: {{particle: C, mass: 1 kg}}}}
contacts: {{plate: {{of: block, at: C, normal: z, friction: {mu}}}}}
gravity: -z
facts: {{velocity(block): ['{v} m/s', 0, 0]}}
ask: {{there: position(block) @ {end} s}}
"""
    bodies = """
<geom name="ground" type="plane" size="100 100 1"/>
<body><joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 1 0"/><joint type="slide" axis="0 0 1"/>
<geom name="body" type="sphere" size="0.05" pos="0 0 0.05" mass="1"/></body>"""
    chrono = "5e-03 in 51,000 steps"
    return Scene(
        "block that slides to rest", text, [way, 0, 0], way, end, bodies, [v, 0, 0], mu, chrono=chrono
    )


def balls_that_meet() -> Scene:
    r, v, e, end = 0.5, 1.0, 0.5, 0.5
    apart = 1.25 * r
    meet = (apart - r) / v
    exact = r + e * v * (end - meet)
    text = f"""
points: {{L: ['{-apart} m', 0, 0], R: ['{apart} m', 0, 0]}}
bodies:
  left: {{sphere: {{center: L, radius: {r} m}}, mass: 1 kg}}
  right: {{sphere: {{center: R, radius: {r} m}}, mass: 1 kg}}
contacts:
  hit: {{of: right, against: left, at: R - {r} m * x, surface: L + {r} m * x, normal: x, open: true, restitution: {e}}}
gravity: none
instants:
  start:
    velocity(left): ['{v} m/s', 0, 0]
    velocity(right): ['{-v} m/s', 0, 0]
    angular_velocity(left): [0, 0, 0]
    angular_velocity(right): [0, 0, 0]
ask: {{there: position(right).x @ {end} s}}
"""
    bodies = f"""
<body pos="{-apart} 0 0"><joint type="slide" axis="1 0 0"/><geom name="ground" type="sphere" size="{r}" mass="1"/></body>
<body pos="{apart} 0 0"><joint type="slide" axis="1 0 0" ref="{apart}"/><geom name="body" type="sphere" size="{r}" mass="1"/></body>"""
    # A part of the speed given back changes the way after the blow as much.
    chrono = "4e-04 in 16,700 steps"
    return Scene(
        "balls that meet", text, [exact], 1, end, bodies, [v, -v], 0, first=1, restitution=e, gravity=(0, 0, 0), chrono=chrono
    )


def damping_ratio(restitution: float) -> float:
    """Of a spring and damper that push alone, let go where their force ends, which give back this part of the speed."""

    def given_back(ratio: float) -> float:
        w = math.sqrt(1 - ratio**2)
        # x = -exp(-ratio t) sin(w t)/w; the force ends where x + 2 ratio x' = 0.
        t = math.atan2(2 * ratio * w, 2 * ratio**2 - 1) / w
        return math.exp(-ratio * t) * (ratio * math.sin(w * t) / w - math.cos(w * t))

    low, high = 0.0, 0.999
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if given_back(middle) > restitution else (low, middle)
    return low


def least(run: Callable[[], Any], times: int = 3) -> tuple[float, Any]:
    spent, found = math.inf, None
    for _ in range(times):
        begin = time.process_time()
        found = run()
        spent = min(spent, time.process_time() - begin)
    return spent, found


def by_poinsot(scene: Scene) -> tuple[float, float]:
    spent, there = least(lambda: poinsot.Problem.from_text(scene.text, scene.name).solve()["there"].si)
    return spent, float(np.linalg.norm(np.array(there) - scene.exact)) / scene.length


def by_mujoco(scene: Scene, step: float) -> tuple[float, float]:
    """Of three speeds at which friction may act, the one with the least error."""
    mujoco: Any = importlib.import_module("mujoco")
    # As stiff as the step size bears: within two steps.
    solref = f"{2 * step} 1"
    if scene.restitution is not None:
        # A blow takes ever more steps, and ever less time.
        frequency = 3 / math.sqrt(step)
        solref = f"{-(frequency**2)} {-2 * damping_ratio(scene.restitution) * frequency}"
    x, y, z = scene.gravity

    def once(friction: str) -> tuple[float, float]:
        model = mujoco.MjModel.from_xml_string(f"""<mujoco>
<option timestep="{step}" gravity="{x} {y} {z}" cone="elliptic" noslip_iterations="10" tolerance="1e-12" noslip_tolerance="1e-12"/>
<worldbody>{scene.bodies}</worldbody>
<contact><pair geom1="ground" geom2="body" condim="{3 if scene.friction > 0 else 1}" solref="{solref}" {friction}
  friction="{scene.friction} {scene.friction} 0 0 0" solimp="0.9999 0.9999 0.001"/></contact></mujoco>""")

        def run() -> list[float]:
            data = mujoco.MjData(model)
            data.qvel[:] = scene.start
            mujoco.mj_step(model, data, round(scene.time / step))
            return [float(one) for one in data.qpos[scene.first : scene.first + 3]]

        spent, there = least(run)
        return spent, float(np.linalg.norm(np.array(there) - scene.exact)) / scene.length

    settings = ["", f'solreffriction="{2 * step} 1"', 'solreffriction="0.02 1"'] if scene.friction > 0 else [""]
    return min((once(one) for one in settings), key=lambda tried: tried[1])


def beside(scene: Scene, cost: float, longest: float) -> str:
    tried: list[tuple[float, float]] = []
    for step in STEPS:
        tried.append(by_mujoco(scene, step))
        if tried[-1][0] > longest:
            break
    affordable = [one for one in tried if one[0] <= cost] or tried[:1]
    spent, error = min(affordable, key=lambda one: one[1])
    best_spent, best = min(tried, key=lambda one: one[1])
    return f"{spent * 1e3:9.1f} {error:9.1e} {best_spent * 1e3:11.1f} {best:9.1e}"


def main() -> None:
    longest = float(sys.argv[1]) if len(sys.argv) > 1 else 1.0
    peer = importlib.util.find_spec("mujoco") is not None
    print("Scenes: cost (ms of processor time) and error (part of a length of the scene)")
    print(f"{'':32} {'poinsot':>19}" + (f" {'MuJoCo, equal cost':>19} {'MuJoCo, least error':>21}" if peer else "") + "  Chrono's test allows")
    for make in SCENES:
        scene = make()
        cost, error = by_poinsot(scene)
        row = f"{scene.name:32} {cost * 1e3:9.1f} {error:9.1e} {beside(scene, cost, longest) if peer else ''}"
        print(f"{row}  {scene.chrono}".rstrip(), flush=True)
    if not peer:
        print("MuJoCo is not installed: it is left out")


SCENES = (
    ball_that_begins_to_roll,
    puck_across_an_incline,
    block_that_stays,
    ball_that_bounces,
    ball_with_backspin,
    ball_on_a_turntable,
    block_that_slides_to_rest,
    balls_that_meet,
)

main()
