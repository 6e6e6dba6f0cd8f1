"""The engine in arrays, against kinematics and Lagrange's equations written down here with NumPy alone."""

import pickle
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
import pytest

from poinsot import _core, engine

Array = engine.Array


def turn(axis: Array, angle: float) -> Array:
    """Rodrigues' formula."""
    k = axis / np.linalg.norm(axis)
    K = np.array([[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]])
    turned: Array = np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K
    return turned


@dataclass
class Link:
    parent: int
    joint: str
    axis: Array
    place: Array
    rotation: Array
    mass: float
    center: Array
    inertia: Array


@dataclass
class Tree:
    """A random tree of hinged and sliding bodies, by the formulas of its kinematics."""

    gravity: Array
    links: list[Link] = field(default_factory=list)

    def poses(self, q: Array) -> list[tuple[Array, Array]]:
        poses: list[tuple[Array, Array]] = []
        for link, x in zip(self.links, q, strict=True):
            R, p = poses[link.parent] if link.parent >= 0 else (np.eye(3), np.zeros(3))
            R, p = R @ link.rotation, p + R @ link.place
            if link.joint == "revolute":
                R = R @ turn(link.axis, x)
            else:
                p = p + R @ link.axis / np.linalg.norm(link.axis) * x
            poses.append((R, p))
        return poses

    def kinetic_energy(self, q: Array, v: Array) -> float:
        """From the poses a little before and after."""
        h, energy = 1e-5, 0.0
        before, now, after = (self.poses(q + s * h * v) for s in (-1, 0, 1))
        for link, (R0, p0), (R, _), (R1, p1) in zip(self.links, before, now, after, strict=True):
            velocity = (p1 + R1 @ link.center - p0 - R0 @ link.center) / (2 * h)
            W = R.T @ (R1 - R0) / (2 * h)
            w = np.array([W[2, 1] - W[1, 2], W[0, 2] - W[2, 0], W[1, 0] - W[0, 1]]) / 2
            energy += float(0.5 * link.mass * velocity @ velocity + 0.5 * w @ link.inertia @ w)
        return energy

    def mass_matrix(self, q: Array) -> Array:
        n = len(self.links)
        unit = np.eye(n)
        T = [self.kinetic_energy(q, unit[i]) for i in range(n)]
        return np.array(
            [[2 * T[i] if i == j else self.kinetic_energy(q, unit[i] + unit[j]) - T[i] - T[j] for j in range(n)] for i in range(n)]
        )

    def potential_energy(self, q: Array) -> float:
        return -sum(
            float(link.mass * self.gravity @ (p + R @ link.center)) for link, (R, p) in zip(self.links, self.poses(q), strict=True)
        )

    def inverse_dynamics(self, q: Array, v: Array, a: Array) -> Array:
        """Lagrange: M a + (dM/dt) v - d(T - V)/dq."""
        h, n = 1e-4, len(self.links)
        M_rate = (self.mass_matrix(q + h * v) - self.mass_matrix(q - h * v)) / (2 * h)
        slope = np.array(
            [
                sum(s * (self.kinetic_energy(q + s * h * e, v) - self.potential_energy(q + s * h * e)) for s in (1, -1)) / (2 * h)
                for e in np.eye(n)
            ]
        )
        forces: Array = self.mass_matrix(q) @ a + M_rate @ v - slope
        return forces

    def model(self) -> engine.Model:
        builder = engine.ModelBuilder()
        builder.set_gravity(self.gravity)
        for i, link in enumerate(self.links):
            parent = "ground" if link.parent < 0 else f"b{link.parent}"
            builder.add_body(
                f"b{i}", parent, link.joint, axis=link.axis, place=link.place, rotation=link.rotation, mass=link.mass,
                center=link.center, inertia=link.inertia,
            )  # fmt: skip
        return builder.build()


def random_tree(random: np.random.Generator, size: int) -> Tree:
    tree = Tree(random.normal(size=3) * 5)
    for i in range(size):
        A = random.normal(size=(3, 3))
        squares = A @ A.T
        tree.links.append(
            Link(
                int(random.integers(-1, i)) if i else -1,
                str(random.choice(["revolute", "prismatic"])),
                random.normal(size=3),
                random.normal(size=3),
                turn(random.normal(size=3), random.uniform(0, 3)),
                random.uniform(0.5, 3),
                random.normal(size=3) * 0.3,
                np.trace(squares) * np.eye(3) - squares,
            )
        )
    return tree


@pytest.mark.parametrize("seed", range(8))
def test_random_trees(seed: int) -> None:
    random = np.random.default_rng(seed)
    tree = random_tree(random, 1 + seed % 5)
    model, n = tree.model(), len(tree.links)
    assert (model.nq, model.nv) == (n, n)
    q, v, a = random.normal(size=(3, n))
    scale = 1 + np.abs(tree.mass_matrix(q)).max() * (1 + v @ v)
    np.testing.assert_allclose(engine.mass_matrix(model, q), tree.mass_matrix(q), atol=1e-7 * scale)
    tau = engine.inverse_dynamics(model, q, v, a)
    np.testing.assert_allclose(tau, tree.inverse_dynamics(q, v, a), atol=1e-4 * scale)
    np.testing.assert_allclose(engine.forward_dynamics(model, q, v, tau), a, rtol=1e-8, atol=1e-8)
    assert engine.kinetic_energy(model, q, v) == pytest.approx(tree.kinetic_energy(q, v), rel=1e-7)
    assert engine.potential_energy(model, q) == pytest.approx(tree.potential_energy(q), rel=1e-12)
    point = random.normal(size=3)
    R, p = tree.poses(q)[-1]
    name = f"b{n - 1}"
    np.testing.assert_allclose(engine.rotation(model, q, name), R, atol=1e-12)
    np.testing.assert_allclose(engine.position(model, q, name, point), p + R @ point, atol=1e-12)
    h = 1e-6
    J = engine.jacobian(model, q, name, point)
    assert J.shape == (6, n)
    ends = [tree.poses(q + s * h * v)[-1] for s in (1, -1)]
    velocity = (ends[0][1] + ends[0][0] @ point - ends[1][1] - ends[1][0] @ point) / (2 * h)
    W = (ends[0][0] - ends[1][0]) / (2 * h) @ R.T
    np.testing.assert_allclose(J @ v, [*velocity, W[2, 1], W[0, 2], W[1, 0]], atol=1e-7)


def test_momenta_of_a_free_body() -> None:
    """H about a point is I w + r x m v, whatever the attitude."""
    random = np.random.default_rng(5)
    inertia = np.diag([1.0, 2.0, 2.5])
    builder = engine.ModelBuilder()
    builder.add_body("b", mass=3.0, inertia=inertia)
    model = builder.build()
    q = model.neutral()
    assert (model.nq, model.nv) == (7, 6) and q[0] == 1
    q = engine.integrate(model, q, random.normal(size=6))
    v, about = random.normal(size=6), random.normal(size=3)
    R, p = engine.rotation(model, q, "b"), engine.position(model, q, "b")
    linear = 3 * R @ v[3:]
    angular = R @ inertia @ v[:3] + np.cross(p - about, linear)
    np.testing.assert_allclose(engine.momentum(model, q, v, about), [*linear, *angular], rtol=1e-12)
    np.testing.assert_allclose(engine.mass_center(model, q), p, rtol=1e-12)
    # Without forces w changes by Euler's equations, and the velocity keeps its direction in space.
    a = engine.forward_dynamics(model, q, v, np.zeros(6))
    np.testing.assert_allclose(a[:3], -np.cross(v[:3], inertia @ v[:3]) / np.diag(inertia), atol=1e-12)
    np.testing.assert_allclose(a[3:], -np.cross(v[:3], v[3:]), atol=1e-12)


def free_tree(random: np.random.Generator) -> engine.Model:
    """A free body that carries a ball joint, a hinge and a slide."""
    builder = engine.ModelBuilder()
    builder.set_gravity(random.normal(size=3))
    parent = "ground"
    for i, joint in enumerate(["free", "ball", "revolute", "prismatic"]):
        A = random.normal(size=(3, 3))
        builder.add_body(
            f"b{i}", parent, joint, axis=random.normal(size=3), place=random.normal(size=3), mass=random.uniform(1, 2),
            center=random.normal(size=3), inertia=np.trace(A @ A.T) * np.eye(3) - A @ A.T,
        )  # fmt: skip
        parent = f"b{i}"
    return builder.build()


@pytest.mark.parametrize("seed", range(4))
def test_derivatives_are_differences(seed: int) -> None:
    random = np.random.default_rng(seed)
    model = free_tree(random)
    n, h = model.nv, 1e-6
    q = engine.integrate(model, model.neutral(), random.normal(size=n))
    v, third = random.normal(size=(2, n))
    for function, derivatives in [
        (engine.inverse_dynamics, engine.inverse_dynamics_derivatives),
        (engine.forward_dynamics, engine.forward_dynamics_derivatives),
    ]:
        found = derivatives(model, q, v, third)
        steps = np.eye(n) * h

        def ends(at: Callable[[Array], Array], steps: Array = steps) -> Array:
            return np.array([(at(step) - at(-step)) / (2 * h) for step in steps]).T

        of = function
        size = np.abs(found[0]).max() + np.abs(found[1]).max() + np.abs(found[2]).max()
        expected = (
            ends(lambda step, of=of: of(model, engine.integrate(model, q, step), v, third)),  # type: ignore[misc]
            ends(lambda step, of=of: of(model, q, v + step, third)),  # type: ignore[misc]
            ends(lambda step, of=of: of(model, q, v, third + step)),  # type: ignore[misc]
        )
        for one, other in zip(found, expected, strict=True):
            np.testing.assert_allclose(one, other, atol=1e-7 * size)


def test_regressor_is_linear_in_the_inertias() -> None:
    random = np.random.default_rng(9)
    model = free_tree(random)
    q = engine.integrate(model, model.neutral(), random.normal(size=model.nv))
    v, a = random.normal(size=(2, model.nv))
    Y = engine.inertia_regressor(model, q, v, a)
    numbers = engine.inertia_numbers(model)
    assert Y.shape == (model.nv, 40) and numbers.shape == (4, 10)
    np.testing.assert_allclose(Y @ numbers.ravel(), engine.inverse_dynamics(model, q, v, a), rtol=1e-11, atol=1e-11)


def test_accelerations_change_with_the_inertias_as_differences_say() -> None:
    random = np.random.default_rng(11)
    masses, centers, tensors = random.uniform(1, 2, 4), random.normal(size=(4, 3)), random.normal(size=(4, 3, 3))

    def model(part: float) -> engine.Model:
        builder = engine.ModelBuilder()
        builder.set_gravity([0.3, -9.0, 2.0])
        for i, joint in enumerate(["free", "ball", "revolute", "prismatic"]):
            A = tensors[i] + part * np.eye(3)
            builder.add_body(
                f"b{i}", f"b{i - 1}" if i else "ground", joint, axis=[1, 2, 3], place=[0.1 * i, 0.3, -0.2],
                mass=masses[i] * (1 + part), center=centers[i] * (1 - 2 * part), inertia=np.trace(A @ A.T) * np.eye(3) - A @ A.T,
            )  # fmt: skip
        return builder.build()

    here, h = model(0), 1e-6
    q = engine.integrate(here, np.repeat(here.neutral()[:, None], 5, axis=1), random.normal(size=(here.nv, 5)))
    v, tau = random.normal(size=(2, here.nv, 5))
    found = engine.forward_dynamics_by_inertia(here, q, v, tau)
    assert found.shape == (here.nv, 40, 5) and found.flags.c_contiguous
    ends = [(engine.forward_dynamics(one, q, v, tau), engine.inertia_numbers(one).ravel()) for one in (model(h), model(-h))]
    slope, numbers = ((ends[0][k] - ends[1][k]) / (2 * h) for k in (0, 1))
    np.testing.assert_allclose(np.einsum("ijk,j->ik", found, numbers), slope, rtol=1e-6, atol=1e-6 * np.abs(slope).max())
    one = engine.forward_dynamics_by_inertia(here, q[:, 2], v[:, 2], tau[:, 2])
    np.testing.assert_allclose(one, found[:, :, 2], rtol=1e-9, atol=1e-9 * np.abs(one).max())


def test_quaternions_are_of_length_one() -> None:
    model = free_tree(np.random.default_rng(5))
    q = np.repeat(model.neutral()[:, None], 6, axis=1)
    v = np.zeros((model.nv, 6))
    engine.forward_dynamics(model, q * (1 + 1e-8), v, v)
    ball = model.first_position("b1")
    q[ball : ball + 4, 3] = [1, 0, 2, 2]
    with pytest.raises(ValueError, match=r"quaternion of 'b1', q\[7\] to q\[10\], has the length 3.0+ in case 3 and not 1"):
        engine.forward_dynamics(model, q, v, v)
    with pytest.raises(ValueError, match="length 3.0+ and not 1"):
        engine.rotation(model, q[:, 3], "b2")
    # What is no number stays none.
    q[ball, 3] = np.nan
    assert np.isnan(engine.mass_matrix(model, q)[:, :, 3]).any()


def test_hybrid_dynamics_finds_what_is_not_known() -> None:
    random = np.random.default_rng(4)
    builder = engine.ModelBuilder()
    builder.set_gravity([0, -9.81, 0])
    parent = "ground"
    modes: list[Literal["free", "prescribed", "locked"]] = ["free", "prescribed", "locked", "free"]
    for i, mode in enumerate(modes):
        builder.add_body(f"b{i}", parent, "revolute", axis=random.normal(size=3), place=[0, 1, 0], mass=1.5,
                         center=[0, 0.5, 0.1], inertia=np.diag([0.3, 0.2, 0.2]), mode=mode)  # fmt: skip
        parent = f"b{i}"
    model = builder.build()
    q, v, known = random.normal(size=(3, 4, 6))
    acceleration, force = engine.hybrid_dynamics(model, q, v, known)
    np.testing.assert_array_equal(acceleration[1], known[1])
    np.testing.assert_array_equal(acceleration[2], 0)
    np.testing.assert_array_equal(force[[0, 3]], known[[0, 3]])
    np.testing.assert_allclose(engine.inverse_dynamics(model, q, v, acceleration), force, rtol=1e-9, atol=1e-9)
    with pytest.raises(ValueError, match="there is no mode 'held'"):
        builder.add_body("b", mode="held")  # type: ignore[arg-type]


CHILD = """
import sys
import numpy as np
from poinsot import _core
_core.instruction_set = lambda: sys.argv[1]
from poinsot import engine
builder = engine.ModelBuilder()
builder.set_gravity([0, 1, -9.81])
for i, joint in enumerate(["free", "ball", "revolute", "prismatic", "screw"]):
    builder.add_body(f"b{i}", f"b{i - 1}" if i else "ground", joint, axis=[0.1, 0.2, 1], pitch=0.3, place=[0.1, 0.2, 0.3],
                     mass=1 + i, center=[0.1, 0, 0.2], inertia=np.diag([0.3, 0.2, 0.25]))
model = builder.build()
random = np.random.default_rng(1)
v, third, turn = random.normal(size=(3, model.nv, 21))
q = engine.integrate(model, np.repeat(model.neutral()[:, None], 21, axis=1), turn)
for function in (engine.inverse_dynamics, engine.forward_dynamics, engine.inverse_dynamics_derivatives,
                 engine.forward_dynamics_derivatives):
    sys.stdout.buffer.write(np.array(function(model, q, v, third)).tobytes())
"""


def test_all_compiled_engines_agree() -> None:
    """Those for the sets of instructions that this processor has; each in a process of its own, as only one is ever loaded."""
    sets = ["", "x86_64_v3", "x86_64_v4"]
    here = sets[: sets.index(_core.instruction_set()) + 1]
    numbers = []
    for one in here:
        child = subprocess.run([sys.executable, "-c", CHILD, one], capture_output=True, check=True)
        numbers.append(np.frombuffer(child.stdout))
    assert numbers[0].size == 21 * (2 * 12 + 2 * 3 * 144)
    for other in numbers[1:]:
        np.testing.assert_allclose(other, numbers[0], rtol=1e-8, atol=1e-8)


@pytest.fixture(scope="module")
def arm() -> engine.Model:
    return random_tree(np.random.default_rng(11), 7).model()


@pytest.mark.parametrize("count", [1, 2, 3, 4, 5, 17, 1000])
def test_batches_are_their_cases(arm: engine.Model, count: int) -> None:
    random = np.random.default_rng(count)
    q, v, a = random.normal(size=(3, 7, count))
    compared: list[tuple[Array, Callable[[int], Array]]] = [
        (engine.inverse_dynamics(arm, q, v, a), lambda k: engine.inverse_dynamics(arm, q[:, k], v[:, k], a[:, k])),
        (engine.forward_dynamics(arm, q, v, a), lambda k: engine.forward_dynamics(arm, q[:, k], v[:, k], a[:, k])),
        (engine.mass_matrix(arm, q), lambda k: engine.mass_matrix(arm, q[:, k])),
        (engine.jacobian(arm, q, "b6"), lambda k: engine.jacobian(arm, q[:, k], "b6")),
        (engine.momentum(arm, q, v), lambda k: engine.momentum(arm, q[:, k], v[:, k])),
        (engine.forward_dynamics_derivatives(arm, q, v, a)[0], lambda k: engine.forward_dynamics_derivatives(arm, q[:, k], v[:, k], a[:, k])[0]),
        (engine.integrate(arm, q, v, 0.1), lambda k: engine.integrate(arm, q[:, k], v[:, k], 0.1)),
    ]
    for found, single in compared:
        assert found.shape[-1] == count
        for k in {0, count // 2, count - 1}:
            np.testing.assert_allclose(found[..., k], single(k), rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("seed", range(4))
def test_batches_of_all_joints_are_their_cases(seed: int) -> None:
    """Packs of cases have a memory and sums of inertias of their own, single states those of the library."""
    random = np.random.default_rng(seed)
    builder = engine.ModelBuilder()
    builder.set_gravity(random.normal(size=3))
    kinds: list[str] = ["revolute", "prismatic", "screw", "ball", "free", "weld"]
    for i in range(14):
        A = random.normal(size=(3, 3))
        builder.add_body(
            f"b{i}", "ground" if i in (0, 9) else f"b{random.integers(9 if i > 9 else 0, i)}",
            kinds[i % 6] if i % 2 else str(random.choice(kinds[:4])), axis=random.normal(size=3), pitch=0.1,
            place=random.normal(size=3), rotation=turn(random.normal(size=3), 1.0), mass=1 + random.random(),
            center=random.normal(size=3) / 5, inertia=np.trace(A @ A.T) * np.eye(3) - A @ A.T,
        )  # fmt: skip
    model = builder.build()
    for count in (1, 9, 300):
        q = engine.integrate(model, np.repeat(model.neutral()[:, None], count, axis=1), random.normal(size=(model.nv, count)))
        v, tau = random.normal(size=(2, model.nv, count))
        both = engine.forward_dynamics(model, q, v, tau)
        assert engine.forward_dynamics(model, q, v, tau, threads=3).tobytes() == both.tobytes()
        # What other algorithms leave in the memory of packs changes nothing.
        assert engine.mass_matrix(model, q).shape == (model.nv, model.nv, count)
        assert engine.forward_dynamics(model, q, v, tau).tobytes() == both.tobytes()
        for k in {0, count // 2, count - 1}:
            one = engine.forward_dynamics(model, q[:, k], v[:, k], tau[:, k])
            np.testing.assert_allclose(both[:, k], one, rtol=1e-9, atol=1e-9 * np.abs(one).max())
        found = engine.inverse_dynamics(model, q, v, both)
        np.testing.assert_allclose(found, tau, rtol=1e-8, atol=1e-8)


def test_threads_change_no_bit(arm: engine.Model) -> None:
    q, v, a = np.random.default_rng(3).normal(size=(3, 7, 1003))
    one = engine.forward_dynamics(arm, q, v, a)
    for threads in (2, 3, 8, 2000):
        np.testing.assert_array_equal(engine.forward_dynamics(arm, q, v, a, threads=threads), one)


def test_models_are_sent_to_other_processes(arm: engine.Model) -> None:
    again = pickle.loads(pickle.dumps(arm))
    q, v, tau = np.random.default_rng(8).normal(size=(3, arm.nv, 7))
    np.testing.assert_array_equal(engine.forward_dynamics(again, q, v, tau), engine.forward_dynamics(arm, q, v, tau))
    assert again.names == arm.names


def test_other_orders_and_types_are_understood(arm: engine.Model) -> None:
    q, v, a = np.random.default_rng(3).normal(size=(3, 7, 10))
    wanted = engine.inverse_dynamics(arm, q, v, a)
    np.testing.assert_array_equal(engine.inverse_dynamics(arm, np.asfortranarray(q), v[:, :], a.tolist()), wanted)
    assert engine.rnea(arm, q, v, a).tobytes() == wanted.tobytes()
    assert engine.inverse_dynamics(arm, q[:, :0], v[:, :0], a[:, :0]).shape == (7, 0)


def test_wrong_shapes_and_names(arm: engine.Model) -> None:
    q, v, a = np.zeros((3, 7, 4))
    with pytest.raises(ValueError, match="q has 6 rows, the model needs 7"):
        engine.inverse_dynamics(arm, q[:6], v, a)
    with pytest.raises(ValueError, match="v is of 3 cases, q of 4"):
        engine.inverse_dynamics(arm, q, v[:, :3], a)
    with pytest.raises(ValueError, match="a is of 1 cases, q of 4"):
        engine.inverse_dynamics(arm, q, v, a[:, 0])
    with pytest.raises(ValueError, match="3 dimensions"):
        engine.mass_matrix(arm, np.zeros((7, 2, 2)))
    with pytest.raises(KeyError, match="no body 'b66'"):
        engine.position(arm, q, "b66")
    with pytest.raises(IndexError, match="no body 7: the model has 7"):
        engine.position(arm, q, 7)
    builder = engine.ModelBuilder()
    with pytest.raises(ValueError, match="'b': the mass is -1 kg"):
        builder.add_body("b", mass=-1)
    with pytest.raises(ValueError, match="there is no joint 'hinge'"):
        builder.add_body("b", joint="hinge")
    with pytest.raises(ValueError, match="is symmetric, but its entry xy is 0.1 and yx is 0 "):
        builder.add_body("b", inertia=np.array([[1, 0.1, 0], [0, 1, 0], [0, 0, 1]]))
    with pytest.raises(ValueError, match="parent 'c' is unknown"):
        builder.add_body("b", "c")
