"""The engine: models of rigid bodies and their dynamics, for one state or for many at once in arrays of NumPy.

A batch has a row for each coordinate and a column for each case: q of shape (nq, cases), v, a and tau (nv, cases). Arrays of
doubles in that order are read in place. The numbers of a case are the same whatever the number of threads.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from . import _core, calls, quantities
from . import problem as problems

if TYPE_CHECKING:
    from . import _engine
    from .problem import Problem
    from .quantities import Value
else:
    # Compiled for the largest set of instructions that this processor has.
    _set = _core.instruction_set()
    _engine = importlib.import_module(f"._engine_{_set}" if _set else "._engine", __package__)

__all__ = [
    "AccelerationDerivatives", "ForceDerivatives", "HybridDynamics", "Model", "ModelBuilder", "Start", "State", "aba",
    "aba_derivatives", "advance", "center_of_mass", "crba", "forward_dynamics", "forward_dynamics_by_inertia",
    "forward_dynamics_derivatives", "from_problem", "hybrid_dynamics", "inertia_numbers", "inertia_regressor", "integrate",
    "inverse_dynamics", "inverse_dynamics_derivatives", "jacobian", "joint_torque_regressor", "kinetic_energy",
    "mass_center", "mass_matrix", "momentum", "position", "potential_energy", "rnea", "rnea_derivatives", "rotation",
]  # fmt: skip

Array: TypeAlias = npt.NDArray[np.float64]

_NO_TURN = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
_NOTHING = ((0.0, 0.0, 0.0),) * 3


def _three(value: npt.ArrayLike, what: str) -> tuple[float, float, float]:
    numbers = quantities.numbers(value, f"{what} as three numbers")
    if numbers.shape != (3,):
        raise ValueError(f"{what} is three numbers, not an array of shape {numbers.shape}")
    return (float(numbers[0]), float(numbers[1]), float(numbers[2]))


def _rows(value: npt.ArrayLike, what: str) -> tuple[tuple[float, float, float], ...]:
    numbers = quantities.numbers(value, f"{what} as a matrix")
    if numbers.shape != (3, 3):
        raise ValueError(f"{what} is a matrix of three rows and columns, not an array of shape {numbers.shape}")
    return tuple(_three(row, what) for row in numbers)


def _one(value: float, what: str) -> float:
    numbers = quantities.numbers(value, f"{what} as a number in SI units")
    if numbers.shape != ():
        raise ValueError(f"{what} is one number, not an array of shape {numbers.shape}")
    return float(numbers)


def _explain(model: Model, arguments: tuple[Any, ...]) -> None:
    """Says what is wrong with the arguments of an algorithm, where the engine found that they are."""
    if not isinstance(model, Model):
        raise TypeError(
            f"expected an engine.Model, not {type(model).__name__}: ModelBuilder.build() and from_problem() make them"
        ) from None
    calls.whole(arguments[-1], "threads")
    if any(one is None for one in arguments):
        raise TypeError("None stands in the place of an array of numbers") from None


def _run(function: Callable[..., Array], model: Model, *arguments: Any) -> Array:
    """Calls an algorithm of the engine; `threads` is the last of its arguments."""
    try:
        return function(model._core, *arguments)
    except (TypeError, AttributeError, ValueError):
        _explain(model, arguments)
        raise


class ModelBuilder:
    """Builds a model body by body, from the ground up."""

    def __init__(self) -> None:
        self._core = _engine.ModelBuilder()
        # What the model is made of, so that another process can make it again.
        self._bodies: list[tuple[Any, ...]] = []
        self._gravity = (0.0, 0.0, 0.0)

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
        for one in (name, parent, joint, mode):
            if not isinstance(one, str):
                raise TypeError(f"a body, its parent, its joint and its mode are told by names, not by {one!r}")
        body = (
            name, parent, joint, _three(axis, "axis"), _one(pitch, "pitch"), _three(place, "place"), _rows(rotation, "rotation"),
            _one(mass, "mass"), _three(center, "center"), _rows(inertia, "inertia"), mode,
        )  # fmt: skip
        if fault := _core.mass_fault(name, body[7], body[8], body[9]):
            raise ValueError(fault)
        self._core.add_body(*body)
        self._bodies.append(body)

    def set_gravity(self, gravity: npt.ArrayLike) -> None:
        """The acceleration of free fall, m/s^2; there is none unless it is set."""
        self._gravity = _three(gravity, "gravity")
        self._core.set_gravity(self._gravity)

    def build(self) -> Model:
        """The model of the bodies that were added so far."""
        return Model(self._core.build(), (_model_of_bodies, (tuple(self._bodies), self._gravity)))


def _model_of_bodies(bodies: tuple[tuple[Any, ...], ...], gravity: tuple[float, float, float]) -> Model:
    builder = ModelBuilder()
    builder.set_gravity(gravity)
    for body in bodies:
        name, parent, joint, axis, pitch, place, rotation, mass, center, inertia, mode = body
        builder.add_body(
            name, parent, joint, axis=axis, pitch=pitch, place=place, rotation=rotation, mass=mass, center=center,
            inertia=inertia, mode=mode,
        )  # fmt: skip
    return builder.build()


def _model_of_tree(*tree: Any) -> Model:
    return Model(_engine.model_of_tree(*tree), (_model_of_tree, tree))


class Model:
    """A tree of bodies. It does not change, and threads may share it; other processes get a copy by pickle."""

    def __init__(self, core: _engine.EngineModel, made_by: tuple[Callable[..., Model], tuple[Any, ...]]) -> None:
        self._core, self._made_by = core, made_by
        self.names: list[str] = list(core.names)
        self.parents: list[int] = list(core.parents)  # -1 is the ground
        self.nq, self.nv = core.nq, core.nv
        self.gravity = np.array(core.gravity)
        self.prescribed: list[bool] = list(core.prescribed)  # of each row of v: whether hybrid_dynamics knows its acceleration

    def body(self, name: str) -> int:
        """The number of a body."""
        if not isinstance(name, str):
            raise TypeError(f"a body is sought by its name, not by {name!r}")
        try:
            return self.names.index(name)
        except ValueError:
            hint = _core.did_you_mean(name, self.names)
            known = hint or f"the model has {', '.join(self.names)}"
            raise KeyError(f"there is no body '{name}' ({known})") from None

    def first_position(self, body: int | str) -> int:
        """The row of q at which the coordinates of a body's joint begin."""
        return int(self._core.first_position[self._number(body)])

    def first_velocity(self, body: int | str) -> int:
        """The row of v at which the rates of a body's joint begin."""
        return int(self._core.first_velocity[self._number(body)])

    def neutral(self) -> Array:
        """The positions in which every body's frame lies on that of its joint."""
        return np.array(self._core.neutral)

    def __reduce__(self) -> tuple[Callable[..., Model], tuple[Any, ...]]:
        return self._made_by

    def _number(self, body: int | str) -> int:
        """The number of a body, which is in the model."""
        if isinstance(body, str):
            return self.body(body)
        number = calls.whole(body, "the number of a body", least=0)
        if number >= len(self.names):
            raise IndexError(f"there is no body {number}: the model has {len(self.names)}, counted from 0")
        return number

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
    if not isinstance(problem, problems.Problem):
        raise TypeError(f"expected a Problem, not {problem!r}: Problem.from_file(path) reads one")
    motion = problem.motion(sets, timeout=timeout, **values)
    start = motion._problem._called(motion._core.start, timeout, False)
    model = _model_of_tree(start.names, start.bodies, start.prescribed, start.gravity)
    origins = {name: np.array(origin) for name, origin in zip(start.names, start.origins, strict=True)}
    return Start(model, np.array(start.q), np.array(start.v), list(start.coordinates), origins, list(start.others))


def inverse_dynamics(
    model: Model, q: npt.ArrayLike, v: npt.ArrayLike, a: npt.ArrayLike, *, threads: int = 1
) -> Array:
    """The joint forces that give the accelerations a, by the recursive Newton-Euler algorithm."""
    # Written out, for a single call takes half a microsecond.
    try:
        return _engine.inverse_dynamics(model._core, q, v, a, threads)
    except (TypeError, AttributeError, ValueError):
        _explain(model, (q, v, a, threads))
        raise


def forward_dynamics(
    model: Model, q: npt.ArrayLike, v: npt.ArrayLike, tau: npt.ArrayLike, *, threads: int = 1
) -> Array:
    """The accelerations under the joint forces tau, by the articulated-body algorithm."""
    try:
        return _engine.forward_dynamics(model._core, q, v, tau, threads)
    except (TypeError, AttributeError, ValueError):
        _explain(model, (q, v, tau, threads))
        raise


class HybridDynamics(NamedTuple):
    """Of each coordinate its acceleration and its force."""

    acceleration: Array
    force: Array


def hybrid_dynamics(
    model: Model, q: npt.ArrayLike, v: npt.ArrayLike, known: npt.ArrayLike, *, threads: int = 1
) -> HybridDynamics:
    """Accelerations and forces, where of each coordinate one is known: the force, or the acceleration of a joint whose
    mode is "prescribed"; that of one that is "locked" is zero, whatever stands there."""
    found = _run(_engine.hybrid_dynamics, model, q, v, known, threads)
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
    found = _run(_engine.inverse_dynamics_derivatives, model, q, v, a, threads)
    return ForceDerivatives(found[0], found[1], found[2])


def forward_dynamics_derivatives(
    model: Model, q: npt.ArrayLike, v: npt.ArrayLike, tau: npt.ArrayLike, *, threads: int = 1
) -> AccelerationDerivatives:
    """How the accelerations of forward_dynamics change with the state; positions as above."""
    found = _run(_engine.forward_dynamics_derivatives, model, q, v, tau, threads)
    return AccelerationDerivatives(found[0], found[1], found[2])


def inertia_regressor(
    model: Model, q: npt.ArrayLike, v: npt.ArrayLike, a: npt.ArrayLike, *, threads: int = 1
) -> Array:
    """Y of shape (nv, 10 bodies[, cases]) with inverse_dynamics = Y pi, pi = inertia_numbers(model).ravel(): the derivative of the
    joint forces by the inertias."""
    return _run(_engine.inertia_regressor, model, q, v, a, threads)


def forward_dynamics_by_inertia(
    model: Model, q: npt.ArrayLike, v: npt.ArrayLike, tau: npt.ArrayLike, *, threads: int = 1
) -> Array:
    """How the accelerations of forward_dynamics change with inertia_numbers(model).ravel(); shape (nv, 10 bodies[, cases])."""
    # What inverse dynamics gives stays tau: M da + Y dpi = 0.
    Y = inertia_regressor(model, q, v, forward_dynamics(model, q, v, tau, threads=threads), threads=threads)
    M = mass_matrix(model, q, threads=threads)
    of_cases = -np.linalg.solve(np.moveaxis(M, (0, 1), (-2, -1)), np.moveaxis(Y, (0, 1), (-2, -1)))
    return np.ascontiguousarray(np.moveaxis(of_cases, (-2, -1), (0, 1)))


def inertia_numbers(model: Model) -> Array:
    """Ten numbers for each body, about its origin on its axes: mass, mass times the place of its mass center (3), and the
    tensor of inertia as xx, yy, zz, xy, yz, zx."""
    return _engine.inertia_numbers(model._core)


def mass_matrix(model: Model, q: npt.ArrayLike, *, threads: int = 1) -> Array:
    """The mass matrix, of shape (nv, nv) or (nv, nv, cases)."""
    try:
        return _engine.mass_matrix(model._core, q, threads)
    except (TypeError, AttributeError, ValueError):
        _explain(model, (q, threads))
        raise


def integrate(model: Model, q: npt.ArrayLike, v: npt.ArrayLike, dt: float = 1.0, *, threads: int = 1) -> Array:
    """The positions after the velocities have held for the time dt."""
    return _run(_engine.integrate, model, q, v, _one(dt, "dt"), threads)


class State(NamedTuple):
    """Positions and velocities."""

    q: Array
    v: Array


def advance(
    model: Model, q: npt.ArrayLike, v: npt.ArrayLike, tau: npt.ArrayLike, dt: float, *, steps: int = 1, threads: int = 1
) -> State:
    """The states after a number of steps of dt seconds, in which the joint forces tau stay as they are (of a "prescribed" joint
    the acceleration). By the classical method of Runge and Kutta: half of dt leaves a sixteenth of the error."""
    steps = calls.whole(steps, "steps", least=0)
    found = _run(_engine.advance, model, q, v, tau, _one(dt, "dt"), steps, threads)
    return State(found[: model.nq], found[model.nq :])


def rotation(model: Model, q: npt.ArrayLike, body: int | str, *, threads: int = 1) -> Array:
    """The matrix that takes components on the body's axes to those on the ground's."""
    return _run(_engine.body_rotation, model, q, model._number(body), threads)


def position(
    model: Model, q: npt.ArrayLike, body: int | str, point: npt.ArrayLike = (0.0, 0.0, 0.0), *, threads: int = 1
) -> Array:
    """Where a point of the body is; the point is given on the body's axes."""
    return _run(_engine.point_position, model, q, model._number(body), _three(point, "point"), threads)


def jacobian(
    model: Model, q: npt.ArrayLike, body: int | str, point: npt.ArrayLike = (0.0, 0.0, 0.0), *, threads: int = 1
) -> Array:
    """J with (velocity of the point, angular velocity of the body) = J v, on the ground's axes: six rows."""
    return _run(_engine.jacobian, model, q, model._number(body), _three(point, "point"), threads)


def mass_center(model: Model, q: npt.ArrayLike, *, threads: int = 1) -> Array:
    """Where the center of all mass is, on the ground's axes: three rows."""
    return _run(_engine.mass_center, model, q, threads)


def momentum(
    model: Model, q: npt.ArrayLike, v: npt.ArrayLike, about: npt.ArrayLike = (0.0, 0.0, 0.0), *, threads: int = 1
) -> Array:
    """Linear momentum, then angular momentum about a point of the ground: six rows."""
    return _run(_engine.momentum, model, q, v, _three(about, "about"), threads)


def kinetic_energy(model: Model, q: npt.ArrayLike, v: npt.ArrayLike, *, threads: int = 1) -> Array:
    """Of all bodies: a number, or one for each case."""
    energy: Array = _run(_engine.kinetic_energy, model, q, v, threads)[0]
    return energy


def potential_energy(model: Model, q: npt.ArrayLike, *, threads: int = 1) -> Array:
    """Of the weights, zero with all mass at the ground's origin."""
    energy: Array = _run(_engine.potential_energy, model, q, threads)[0]
    return energy


# As users of Pinocchio look for them.
rnea, aba, crba, center_of_mass = inverse_dynamics, forward_dynamics, mass_matrix, mass_center
rnea_derivatives, aba_derivatives = inverse_dynamics_derivatives, forward_dynamics_derivatives
joint_torque_regressor = inertia_regressor


def __dir__() -> list[str]:
    return __all__
