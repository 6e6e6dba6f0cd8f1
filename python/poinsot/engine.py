"""The engine: models of rigid bodies and their dynamics, for one state or for many at once in arrays of NumPy.

A batch has a row for each coordinate and a column for each case: q of shape (nq, cases), v, a and tau (nv, cases). Arrays of
doubles in that order are read in place. The numbers of a case are the same whatever the number of threads.
"""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from typing import TYPE_CHECKING, Literal, NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from . import _core

if TYPE_CHECKING:
    from . import _engine
    from .problem import Problem
    from .quantities import Value
else:
    # Compiled for the largest set of instructions that this processor has.
    _set = _core.instruction_set()
    _engine = importlib.import_module(f"._engine_{_set}" if _set else "._engine", __package__)

Array: TypeAlias = npt.NDArray[np.float64]

_NO_TURN = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
_NOTHING = ((0.0, 0.0, 0.0),) * 3


def _three(value: npt.ArrayLike, what: str) -> tuple[float, float, float]:
    numbers = np.asarray(value, dtype=float)
    if numbers.shape != (3,):
        raise ValueError(f"{what} is three numbers, not an array of shape {numbers.shape}")
    return (float(numbers[0]), float(numbers[1]), float(numbers[2]))


def _rows(value: npt.ArrayLike, what: str) -> tuple[tuple[float, float, float], ...]:
    numbers = np.asarray(value, dtype=float)
    if numbers.shape != (3, 3):
        raise ValueError(f"{what} is a matrix of three rows and columns, not an array of shape {numbers.shape}")
    return tuple(_three(row, what) for row in numbers)


class ModelBuilder:
    """Builds a model body by body, from the ground up."""

    def __init__(self) -> None:
        self._core = _engine.ModelBuilder()

    def add_body(
        self,
        name: str,
        parent: str = "ground",
        joint: str = "free",
        *,
        axis: npt.ArrayLike = (0.0, 0.0, 1.0),
        pitch: float = 0.0,
        place: npt.ArrayLike = (0.0, 0.0, 0.0),
        rotation: npt.ArrayLike = _NO_TURN,
        mass: float = 0.0,
        center: npt.ArrayLike = (0.0, 0.0, 0.0),
        inertia: npt.ArrayLike = _NOTHING,
        mode: Literal["free", "prescribed", "locked"] = "free",
    ) -> None:
        """Adds a body on a joint: "revolute", "prismatic", "screw", "ball", "free" or "weld".

        place and rotation: the joint's frame in that of the parent; axis: of the joint, in its frame. The body's frame lies on the
        joint's in the neutral position. center: of mass, m; inertia: the tensor about it, kg m^2. mode: what hybrid_dynamics knows of
        the joint: its forces, its accelerations, or that these are zero.
        """
        self._core.add_body(
            name, parent, joint, _three(axis, "axis"), pitch, _three(place, "place"), _rows(rotation, "rotation"), mass,
            _three(center, "center"), _rows(inertia, "inertia"), mode,
        )  # fmt: skip

    def set_gravity(self, gravity: npt.ArrayLike) -> None:
        """The acceleration of free fall, m/s^2; there is none unless it is set."""
        self._core.set_gravity(_three(gravity, "gravity"))

    def build(self) -> Model:
        return Model(self._core.build())


class Model:
    """A tree of bodies. It does not change, and threads may share it."""

    def __init__(self, core: _engine.EngineModel) -> None:
        self._core = core
        self.names: list[str] = list(core.names)
        self.parents: list[int] = list(core.parents)  # -1 is the ground
        self.nq, self.nv = core.nq, core.nv
        self.gravity = np.array(core.gravity)
        self.prescribed: list[bool] = list(core.prescribed)  # of each row of v: whether hybrid_dynamics knows its acceleration

    def body(self, name: str) -> int:
        """The number of a body."""
        try:
            return self.names.index(name)
        except ValueError:
            hint = _core.did_you_mean(name, self.names)
            raise KeyError(f"there is no body '{name}'{f' ({hint})' if hint else ''}") from None

    def first_position(self, body: int | str) -> int:
        """The row of q at which the coordinates of a body's joint begin."""
        return int(self._core.first_position[self._number(body)])

    def first_velocity(self, body: int | str) -> int:
        return int(self._core.first_velocity[self._number(body)])

    def neutral(self) -> Array:
        """The positions in which every body's frame lies on that of its joint."""
        return np.array(self._core.neutral)

    def _number(self, body: int | str) -> int:
        return self.body(body) if isinstance(body, str) else body

    def __repr__(self) -> str:
        return f"<poinsot.engine.Model of {len(self.names)} bodies, nq = {self.nq}, nv = {self.nv}>"


class Start(NamedTuple):
    """The bodies of a problem where its motion begins."""

    model: Model
    q: Array
    v: Array
    coordinates: list[str]  # of each row of v, in words
    origins: dict[str, Array]  # of each body's frame, m, on the ground's axes in the figure as drawn, which are its axes then
    others: list[str]  # what acts beside the weights and is not in the model: springs, motors, dampers, loads


def from_problem(
    problem: Problem,
    sets: Mapping[str, Value] | None = None,
    /,
    *,
    timeout: float | None = None,
    **values: Value,
) -> Start:
    """The tree of bodies of a problem, with its state where the motion begins. Values are given as those of Problem.solve().

    A point p of the figure as drawn is p - origins[body] on the axes of a body. What the file moves as stated, such as frames, is
    "prescribed". Loops, rolling, cords and contacts are no joints of a tree: NoAnswer tells where there are some.
    """
    motion = problem.motion(sets, timeout=timeout, **values)
    start = motion._problem._called(motion._core.start, timeout, False)
    model = Model(_engine.model_of_tree(start.names, start.bodies, start.prescribed, start.gravity))
    origins = {name: np.array(origin) for name, origin in zip(start.names, start.origins, strict=True)}
    return Start(model, np.array(start.q), np.array(start.v), list(start.coordinates), origins, list(start.others))


def inverse_dynamics(
    model: Model, q: npt.ArrayLike, v: npt.ArrayLike, a: npt.ArrayLike, *, threads: int = 1
) -> Array:
    """The joint forces that give the accelerations a, by the recursive Newton-Euler algorithm."""
    return _engine.inverse_dynamics(model._core, q, v, a, threads)


def forward_dynamics(
    model: Model, q: npt.ArrayLike, v: npt.ArrayLike, tau: npt.ArrayLike, *, threads: int = 1
) -> Array:
    """The accelerations under the joint forces tau, by the articulated-body algorithm."""
    return _engine.forward_dynamics(model._core, q, v, tau, threads)


class HybridDynamics(NamedTuple):
    """Of each coordinate its acceleration and its force."""

    acceleration: Array
    force: Array


def hybrid_dynamics(
    model: Model, q: npt.ArrayLike, v: npt.ArrayLike, known: npt.ArrayLike, *, threads: int = 1
) -> HybridDynamics:
    """Accelerations and forces, where of each coordinate one is known: the force, or the acceleration of a joint whose
    mode is "prescribed"; that of one that is "locked" is zero, whatever stands there."""
    found = _engine.hybrid_dynamics(model._core, q, v, known, threads)
    return HybridDynamics(found[0], found[1])


class ForceDerivatives(NamedTuple):
    """A row for each joint force, a column for each coordinate; shape (nv, nv) or (nv, nv, cases)."""

    by_position: Array
    by_velocity: Array
    by_acceleration: Array  # the mass matrix


class AccelerationDerivatives(NamedTuple):
    """A row for each acceleration, a column for each coordinate; shape (nv, nv) or (nv, nv, cases)."""

    by_position: Array
    by_velocity: Array
    by_force: Array  # the inverse of the mass matrix


def inverse_dynamics_derivatives(
    model: Model, q: npt.ArrayLike, v: npt.ArrayLike, a: npt.ArrayLike, *, threads: int = 1
) -> ForceDerivatives:
    """How the joint forces of inverse_dynamics change with the state. Positions are displaced as integrate() does it by
    velocities: there are nv directions, turns of ball and free joints on the body's own axes."""
    found = _engine.inverse_dynamics_derivatives(model._core, q, v, a, threads)
    return ForceDerivatives(found[0], found[1], found[2])


def forward_dynamics_derivatives(
    model: Model, q: npt.ArrayLike, v: npt.ArrayLike, tau: npt.ArrayLike, *, threads: int = 1
) -> AccelerationDerivatives:
    """How the accelerations of forward_dynamics change with the state; positions as above."""
    found = _engine.forward_dynamics_derivatives(model._core, q, v, tau, threads)
    return AccelerationDerivatives(found[0], found[1], found[2])


def inertia_regressor(
    model: Model, q: npt.ArrayLike, v: npt.ArrayLike, a: npt.ArrayLike, *, threads: int = 1
) -> Array:
    """Y of shape (nv, 10 bodies[, cases]) with inverse_dynamics = Y pi, pi = inertia_numbers(model).ravel(): the derivative of the
    joint forces by the inertias."""
    return _engine.inertia_regressor(model._core, q, v, a, threads)


def inertia_numbers(model: Model) -> Array:
    """Ten numbers for each body, about its origin on its axes: mass, mass times the place of its mass center (3), and the
    tensor of inertia as xx, yy, zz, xy, yz, zx."""
    return _engine.inertia_numbers(model._core)


def mass_matrix(model: Model, q: npt.ArrayLike, *, threads: int = 1) -> Array:
    """The mass matrix, of shape (nv, nv) or (nv, nv, cases)."""
    return _engine.mass_matrix(model._core, q, threads)


def integrate(model: Model, q: npt.ArrayLike, v: npt.ArrayLike, dt: float = 1.0, *, threads: int = 1) -> Array:
    """The positions after the velocities have held for the time dt."""
    return _engine.integrate(model._core, q, v, dt, threads)


class State(NamedTuple):
    """Positions and velocities."""

    q: Array
    v: Array


def advance(
    model: Model, q: npt.ArrayLike, v: npt.ArrayLike, tau: npt.ArrayLike, dt: float, *, steps: int = 1, threads: int = 1
) -> State:
    """The states after a number of steps of dt seconds, in which the joint forces tau stay as they are (of a "prescribed" joint
    the acceleration). By the classical method of Runge and Kutta: half of dt leaves a sixteenth of the error."""
    if steps < 0:
        raise ValueError(f"there are no {steps} steps")
    found = _engine.advance(model._core, q, v, tau, dt, steps, threads)
    return State(found[: model.nq], found[model.nq :])


def rotation(model: Model, q: npt.ArrayLike, body: int | str, *, threads: int = 1) -> Array:
    """The matrix that takes components on the body's axes to those on the ground's."""
    return _engine.body_rotation(model._core, q, model._number(body), threads)


def position(
    model: Model, q: npt.ArrayLike, body: int | str, point: npt.ArrayLike = (0.0, 0.0, 0.0), *, threads: int = 1
) -> Array:
    """Where a point of the body is; the point is given on the body's axes."""
    return _engine.point_position(model._core, q, model._number(body), _three(point, "point"), threads)


def jacobian(
    model: Model, q: npt.ArrayLike, body: int | str, point: npt.ArrayLike = (0.0, 0.0, 0.0), *, threads: int = 1
) -> Array:
    """J with (velocity of the point, angular velocity of the body) = J v, on the ground's axes: six rows."""
    return _engine.jacobian(model._core, q, model._number(body), _three(point, "point"), threads)


def mass_center(model: Model, q: npt.ArrayLike, *, threads: int = 1) -> Array:
    return _engine.mass_center(model._core, q, threads)


def momentum(
    model: Model, q: npt.ArrayLike, v: npt.ArrayLike, about: npt.ArrayLike = (0.0, 0.0, 0.0), *, threads: int = 1
) -> Array:
    """Linear momentum, then angular momentum about a point of the ground: six rows."""
    return _engine.momentum(model._core, q, v, _three(about, "about"), threads)


def kinetic_energy(model: Model, q: npt.ArrayLike, v: npt.ArrayLike, *, threads: int = 1) -> Array:
    energy: Array = _engine.kinetic_energy(model._core, q, v, threads)[0]
    return energy


def potential_energy(model: Model, q: npt.ArrayLike, *, threads: int = 1) -> Array:
    """Of the weights, zero with all mass at the ground's origin."""
    energy: Array = _engine.potential_energy(model._core, q, threads)[0]
    return energy


# As users of Pinocchio look for them.
rnea, aba, crba, center_of_mass = inverse_dynamics, forward_dynamics, mass_matrix, mass_center
rnea_derivatives, aba_derivatives = inverse_dynamics_derivatives, forward_dynamics_derivatives
joint_torque_regressor = inertia_regressor
