"""Problems that several tests use."""

import pytest

import poinsot

ASKEW = """\
title: Disk mounted askew on a shaft
given: {m: 8 kg, r: 150 mm, b: 20 deg, n: 1200 rpm, L: 500 mm}
points: {A: [-L/2, 0, 0], G: [0, 0, 0], B: [L/2, 0, 0]}
directions: {across: [cos(b), sin(b), 0]}
bodies:
  disk: {disk: {center: G, normal: across, radius: r}, mass: m}
joints:
  shaft: {revolute: A->B, at: A, to: disk, rate: n, accel: 0, supports: {A: [x, y, z], B: [y, z]}}
gravity: none
ask:
  H: angular_momentum(disk about G)
  T: kinetic_energy(disk)
  A: reaction(A)
  B: reaction(B)
"""

BENT = """\
title: Bent rod, struck at its end
letters: {m: kg, a: m, J: N*s}
points: {A: [0, -a, a], B: [0, 0, a], C: [0, 0, -a], D: [0, a, -a]}
bodies:
  rod: {wire: [A, B, C, D], mass: m}
impulses:
  blow: {body: rod, at: A, value: [J, 0, 0]}
instants:
  before: rest
ask:
  w: angular_velocity(rod)
claim:
  more: kinetic_energy(rod) > J^2/(2*m)
  less: kinetic_energy(rod) < J^2/(2*m)
"""


@pytest.fixture
def askew() -> poinsot.Problem:
    return poinsot.Problem.from_text(ASKEW, "askew.yaml")


@pytest.fixture
def bent() -> poinsot.Problem:
    return poinsot.Problem.from_text(BENT, "bent.yaml")
