"""poinsot.engine beside Pinocchio's and MuJoCo's Python: an arm and a humanoid of random bodies.

One call at a time with Pinocchio; batches of states on one thread beside Pinocchio called for each, and beside the
accelerations that MuJoCo's rollout finds (a step of Euler's method for each state, contacts and sensors off). Microseconds per
state and thread, by the processor's clock, medians; the contestants take turns. A peer that is not installed is left out.

usage: python_engine.py [STATES]
"""

from __future__ import annotations

import importlib.util
import statistics
import sys
import time
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from poinsot import _core, engine

REPEATS = 15


class Stated:
    """A tree of bodies stated plainly: parent, joint, axis, place, mass, center, inertia."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.random = np.random.default_rng(7)
        self.bodies: list[dict[str, Any]] = []

    def add(self, parent: int, joint: str, axis: list[float]) -> int:
        moments = self.random.uniform(0.02, 0.03, 3)
        self.bodies.append(
            {
                "parent": parent,
                "joint": joint,
                "axis": np.array(axis, dtype=float),
                "place": np.array([0.05, 0.1, 0.28]) if parent >= 0 else np.zeros(3),
                "mass": float(self.random.uniform(0.5, 3)),
                "center": self.random.uniform(-0.1, 0.1, 3),
                "inertia": np.diag(moments),
            }
        )
        return len(self.bodies) - 1


def arm() -> Stated:
    model = Stated("arm of 7")
    parent = -1
    for i in range(7):
        parent = model.add(parent, "revolute", [0, 0, 1] if i % 2 == 0 else [0, 1, 0])
    return model


def humanoid() -> Stated:
    model = Stated("humanoid, 32 dof")
    x, y, z = [1.0, 0, 0], [0, 1.0, 0], [0, 0, 1.0]

    def limb(parent: int, axes: list[list[float]]) -> int:
        for axis in axes:
            parent = model.add(parent, "revolute", axis)
        return parent

    base = model.add(-1, "free", z)
    leg = [x, y, z, y, y, x]
    limb(base, leg)
    limb(base, leg)
    chest = limb(base, [y, z])
    limb(chest, leg)
    limb(chest, leg)
    return model


def of_poinsot(stated: Stated) -> engine.Model:
    builder = engine.ModelBuilder()
    builder.set_gravity([0, 0, -9.81])
    for i, body in enumerate(stated.bodies):
        parent = "ground" if body["parent"] < 0 else f"b{body['parent']}"
        builder.add_body(
            f"b{i}", parent, body["joint"], axis=body["axis"], place=body["place"], mass=body["mass"],
            center=body["center"], inertia=body["inertia"],
        )  # fmt: skip
    return builder.build()


def of_pinocchio(stated: Stated) -> Any:
    import pinocchio as pin

    model = pin.Model()
    model.gravity.linear = np.array([0, 0, -9.81])
    for i, body in enumerate(stated.bodies):
        axis = body["axis"]
        joint = pin.JointModelFreeFlyer() if body["joint"] == "free" else (
            pin.JointModelRX() if axis[0] else pin.JointModelRY() if axis[1] else pin.JointModelRZ()
        )
        number = model.addJoint(body["parent"] + 1, joint, pin.SE3(np.eye(3), body["place"]), f"b{i}")
        model.appendBodyToJoint(number, pin.Inertia(body["mass"], body["center"], body["inertia"]), pin.SE3.Identity())
    return model


def of_mujoco(stated: Stated, options: str = 'timestep="1e-6"') -> Any:
    import mujoco

    def text(numbers: Any) -> str:
        return " ".join(repr(float(x)) for x in numbers)

    children: dict[int, list[int]] = {}
    for i, body in enumerate(stated.bodies):
        children.setdefault(body["parent"], []).append(i)

    def xml(i: int) -> str:
        body = stated.bodies[i]
        joint = "<freejoint/>" if body["joint"] == "free" else f'<joint type="hinge" axis="{text(body["axis"])}"/>'
        inertia = f'<inertial pos="{text(body["center"])}" mass="{body["mass"]!r}" diaginertia="{text(np.diag(body["inertia"]))}"/>'
        inner = "".join(xml(k) for k in children.get(i, []))
        return f'<body name="b{i}" pos="{text(body["place"])}">{inertia}{joint}{inner}</body>'

    bodies = "".join(xml(i) for i in children[-1])
    return mujoco.MjModel.from_xml_string(
        f'<mujoco><option gravity="0 0 -9.81" {options}><flag contact="disable" eulerdamp="disable"/></option>'
        f"<worldbody>{bodies}</worldbody></mujoco>"
    )


def medians(runs: dict[str, Callable[[], object]], states: int) -> dict[str, float]:
    """Microseconds per state."""
    for run in runs.values():
        run()
    times: dict[str, list[float]] = {name: [] for name in runs}
    for _ in range(REPEATS):
        for name, run in runs.items():
            # The one before has left the caches and the heap as it needed them.
            run()
            start = time.process_time()
            run()
            times[name].append((time.process_time() - start) / states * 1e6)
    return {name: statistics.median(each) for name, each in times.items()}


def wall(run: Callable[[], object]) -> float:
    """The least time by the clock, s."""
    times = []
    for _ in range(REPEATS):
        start = time.perf_counter()
        run()
        times.append(time.perf_counter() - start)
    return min(times)


def apart(ours: Any, theirs: Any) -> float:
    return float(np.abs(ours - theirs).max() / np.abs(theirs).max())


def measure(stated: Stated, states: int) -> bool:
    model = of_poinsot(stated)
    random = np.random.default_rng(3)
    free = stated.bodies[0]["joint"] == "free"
    n = model.nv
    v, given = random.normal(size=(2, n, states))
    q = np.repeat(model.neutral()[:, None], states, axis=1)
    q = engine.integrate(model, q, random.normal(size=(n, states)))
    # The positions alone in the order of the peers: place first, and the scalar of a quaternion last or first.
    joints = range(7 if free else 0, model.nq)
    rows = ([4, 5, 6, 1, 2, 3, 0] if free else []) + list(joints)
    of_velocity = ([3, 4, 5, 0, 1, 2] if free else []) + list(range(6 if free else 0, n))
    columns = [np.ascontiguousarray(part.T) for part in (q[rows], v[of_velocity], given[of_velocity])]
    our_columns = [np.ascontiguousarray(part.T) for part in (q, v, given)]
    agree = True

    def table(what: str, runs: dict[str, Callable[[], object]], count: int) -> None:
        found = medians(runs, count)
        ours = found["poinsot"]
        cells = "  ".join(f"{name} {value:9.3f}" + ("" if name == "poinsot" else f" ({value / ours:5.1f} x)") for name, value in found.items())
        print(f"{stated.name:18} {what:34} {cells}", flush=True)

    pin: Any = None
    pin_model: Any = None
    if importlib.util.find_spec("pinocchio"):
        pin = importlib.import_module("pinocchio")
        pin_model = of_pinocchio(stated)
        data = pin_model.createData()
        back = np.argsort(of_velocity)

    calls: list[tuple[str, str, Callable[[int], Any]]] = [
        ("inverse dynamics", "inverse_dynamics", lambda i: pin.rnea(pin_model, data, columns[0][i], columns[1][i], columns[2][i])),
        ("forward dynamics", "forward_dynamics", lambda i: pin.aba(pin_model, data, columns[0][i], columns[1][i], columns[2][i])),
        (
            "derivatives of inverse dynamics", "inverse_dynamics_derivatives",
            lambda i: pin.computeRNEADerivatives(pin_model, data, columns[0][i], columns[1][i], columns[2][i]),
        ),
        (
            "derivatives of forward dynamics", "forward_dynamics_derivatives",
            lambda i: pin.computeABADerivatives(pin_model, data, columns[0][i], columns[1][i], columns[2][i]),
        ),
    ]  # fmt: skip
    some = min(states, 400)
    for what, name, peer in calls:
        function = getattr(engine, name)
        single: dict[str, Callable[[], object]] = {
            "poinsot": partial(lambda of: [of(model, *(c[i] for c in our_columns)) for i in range(some)], function)
        }
        batch: dict[str, Callable[[], object]] = {"poinsot": partial(function, model, q, v, given)}
        if pin_model is not None:
            single["Pinocchio"] = partial(lambda of: [of(i) for i in range(some)], peer)
            batch["Pinocchio"] = partial(lambda of: [of(i) for i in range(states)], peer)
            theirs, ours = peer(0), function(model, *(c[0] for c in our_columns))
            if name.endswith("derivatives"):
                for a, b in zip(peer(0), ours, strict=False):
                    whole = np.triu(a) + np.triu(a, 1).T if b is ours[2] else np.asarray(a)
                    agree &= apart(b, whole[np.ix_(back, back)]) < 1e-9
            else:
                agree &= apart(ours, np.asarray(theirs)[back]) < 1e-9
        table(what + ", one call", single, some)
        if name == "forward_dynamics" and importlib.util.find_spec("mujoco"):
            import mujoco
            from mujoco import rollout

            peer_model = of_mujoco(stated)
            # Its free bodies: place, quaternion with the scalar first; velocity on the ground's axes, turn on its own.
            place = ([4, 5, 6, 0, 1, 2, 3] if free else []) + list(joints)
            turned = our_columns[1][:, of_velocity].copy()
            forces = np.zeros((states, n))
            forces[:] = our_columns[2][:, of_velocity]
            if free:
                R = engine.rotation(model, q, 0)
                turned[:, :3] = np.einsum("ijk,jk->ki", R, v[3:6])
                forces[:, :3] = np.einsum("ijk,jk->ki", R, given[3:6])
            size = mujoco.mj_stateSize(peer_model, mujoco.mjtState.mjSTATE_FULLPHYSICS)
            start = np.zeros((states, size))
            start[:, 1:] = np.hstack([our_columns[0][:, place], turned])
            signature = int(mujoco.mjtState.mjSTATE_QFRC_APPLIED)
            one = mujoco.MjData(peer_model)

            def run(start: Any = start, forces: Any = forces) -> Any:
                return rollout.rollout(peer_model, [one], start, forces[:, None, :], control_spec=signature, skip_checks=False)

            after = run()[0][:, 0, :]
            a = (after[:, 1 + model.nq :] - turned) / 1e-6
            ours = function(model, q, v, given).T[:, of_velocity]
            print(f"{'':18} accelerations of MuJoCo's joints differ by {apart(a[:, 6 if free else 0 :], ours[:, 6 if free else 0 :]):.0e}")
            batch["MuJoCo rollout"] = run

            # Ten steps of Runge and Kutta, the forces as they are; none on a free base, whose axes would count.
            stepped_model = of_mujoco(stated, 'timestep="1e-3" integrator="RK4"')
            tau = given.copy()
            if free:
                tau[:6] = 0
            held = np.ascontiguousarray(np.repeat(tau.T[:, None, of_velocity], 10, axis=1))
            other = mujoco.MjData(stepped_model)

            def steps(start: Any = start, held: Any = held) -> Any:
                return rollout.rollout(stepped_model, [other], start, held, control_spec=signature)

            stepped: dict[str, Callable[[], object]] = {
                "poinsot": lambda: engine.advance(model, q, v, tau, 1e-3, steps=10),
                "MuJoCo rollout": steps,
            }
            after, ours = steps()[0][:, -1, 1 + model.nq :], engine.advance(model, q, v, tau, 1e-3, steps=10).v.T[:, of_velocity]
            print(f"{'':18} velocities of MuJoCo's joints differ by {apart(after[:, 6 if free else 0 :], ours[:, 6 if free else 0 :]):.0e}")
            table("ten steps of Runge-Kutta, batch", stepped, states)
        table(what + ", batch", batch, states)
    several = [wall(partial(engine.forward_dynamics, model, q, v, given, threads=threads)) for threads in (1, 2)]
    print(f"{stated.name:18} forward dynamics on two threads    {several[0] / several[1]:.2f} times as many states a second")
    return agree


def main() -> int:
    states = int(sys.argv[1]) if len(sys.argv) > 1 else 4096
    print(f"{states} states, instructions: {_core.instruction_set() or 'baseline'}; microseconds per state, (peer / poinsot)")
    agree = all([measure(arm(), states), measure(humanoid(), states)])
    if not agree:
        print("python_engine: the results differ from Pinocchio's by more than 1e-9 of their largest", file=sys.stderr)
    return 0 if agree else 1


if __name__ == "__main__":
    raise SystemExit(main())
