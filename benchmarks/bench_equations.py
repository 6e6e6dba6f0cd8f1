#!/usr/bin/env python3
"""Equations of motion as formulas: bench_equations beside SymPy's KanesMethod, and generated C beside the engine.

usage: bench_equations.py PROGRAM

Both derive mass matrix and right-hand side of the same models in the same coordinates, whose rates are the speeds.
Operations are counted as they stand in what is handed over: SymPy's by count_ops, as they come and with its common
subexpressions named (cse). Exit code 1 if the equations differ at random points by more than 1e-9.
"""
import json
import random
import subprocess
import sys
import time

import sympy
from sympy.physics.mechanics import KanesMethod, Particle, Point, ReferenceFrame, RigidBody, dynamicsymbols, inertia

T = dynamicsymbols._t


def coordinates(count):
    q = dynamicsymbols(f"q1:{count + 1}")
    u = dynamicsymbols(f"u1:{count + 1}")
    return list(q), list(u), [a.diff(T) - b for a, b in zip(q, u)]


def kane(frame, q, u, kinematic, loads, bodies):
    method = KanesMethod(frame, q_ind=q, u_ind=u, kd_eqs=kinematic)
    method.kanes_equations(bodies, loads)
    return method.mass_matrix, method.forcing


def heavy_top(letters):
    m, g, l, A, C = letters
    q, u, kinematic = coordinates(3)
    ground = ReferenceFrame("N")
    a = ground.orientnew("a", "Axis", [q[0], ground.z])
    b = a.orientnew("b", "Axis", [q[1], a.x])
    c = b.orientnew("c", "Axis", [q[2], b.z])
    c.set_ang_vel(ground, u[0] * a.z + u[1] * b.x + u[2] * c.z)
    fixed = Point("O")
    fixed.set_vel(ground, 0)
    center = fixed.locatenew("G", l * c.z)
    center.v2pt_theory(fixed, ground, c)
    body = RigidBody("top", center, c, m, (inertia(c, A, A, C), center))
    return *kane(ground, q, u, kinematic, [(center, -m * g * ground.z)], [body]), q, u


def rolling_disk(letters):
    m, g, r = letters
    q, u, kinematic = coordinates(3)
    ground = ReferenceFrame("N")
    yaw = ground.orientnew("Y", "Axis", [q[0], ground.z])
    lean = yaw.orientnew("L", "Axis", [q[1], yaw.x])
    disk = lean.orientnew("R", "Axis", [q[2], lean.y])
    rates = u[0] * ground.z + u[1] * yaw.x + u[2] * lean.y
    disk.set_ang_vel(ground, rates)
    disk.set_ang_acc(ground, rates.express(lean).dt(lean) + (lean.ang_vel_in(ground) ^ rates))
    contact = Point("C")
    contact.set_vel(ground, 0)
    center = contact.locatenew("Dmc", r * lean.z)
    center.v2pt_theory(contact, ground, disk)
    moment = m * r**2 / 4
    body = RigidBody("disk", center, disk, m, (inertia(lean, moment, 2 * moment, moment), center))
    return *kane(ground, q, u, kinematic, [(center, -m * g * ground.z)], [body]), q, u


def planar_pendulum(letters):
    g, rest = letters[0], letters[1:]
    count = len(rest) // 2
    masses, lengths = rest[:count], rest[count:]
    q, u, kinematic = coordinates(count)
    ground = ReferenceFrame("N")
    frame, point = ground, Point("O")
    point.set_vel(ground, 0)
    bodies, loads = [], []
    for i in range(count):
        outer = frame.orientnew(f"b{i}", "Axis", [q[i], frame.z])
        outer.set_ang_vel(frame, u[i] * frame.z)
        end = point.locatenew(f"P{i}", -lengths[i] * outer.y)
        end.v2pt_theory(point, ground, outer)
        bodies.append(Particle(f"m{i}", end, masses[i]))
        loads.append((end, -masses[i] * g * ground.y))
        frame, point = outer, end
    return *kane(ground, q, u, kinematic, loads, bodies), q, u


def spatial_pendulum(count):
    def build(letters):
        g, m, l = letters
        q, u, kinematic = coordinates(count)
        ground = ReferenceFrame("N")
        frame, point = ground, Point("O")
        point.set_vel(ground, 0)
        bodies, loads = [], []
        moment = m * l**2 / 12
        for i in range(count):
            axis = frame.x if i % 2 == 0 else frame.y
            outer = frame.orientnew(f"b{i}", "Axis", [q[i], axis])
            outer.set_ang_vel(frame, u[i] * axis)
            center = point.locatenew(f"G{i}", -l / 2 * outer.z)
            center.v2pt_theory(point, ground, outer)
            end = point.locatenew(f"P{i}", -l * outer.z)
            end.v2pt_theory(point, ground, outer)
            bodies.append(RigidBody(f"bar{i}", center, outer, m, (inertia(outer, moment, moment, 0), center)))
            loads.append((center, -m * g * ground.z))
            frame, point = outer, end
        return *kane(ground, q, u, kinematic, loads, bodies), q, u

    return build


BUILDERS = {"heavy top, Euler angles": heavy_top, "rolling disk": rolling_disk,
            "planar 3-link pendulum": planar_pendulum, "spatial 3-link pendulum": spatial_pendulum(3),
            "planar 6-link pendulum": planar_pendulum, "spatial 6-link pendulum": spatial_pendulum(6),
            "planar 10-link pendulum": planar_pendulum}
POINTS = 5
TOLERANCE = 1e-9


def apart(row, matrix, forcing, q, u, letters):
    """The largest difference at random points, relative to the largest entry."""
    scope = {}
    exec(row["python"], scope)  # our own text
    size = row["size"]
    replacements, reduced = sympy.cse([*matrix, *forcing])
    theirs = sympy.lambdify([*q, *u, *letters], list(reduced), modules="math",
                            cse=lambda _: (replacements, list(reduced)))
    random.seed(1)
    worst = 0.0
    for _ in range(POINTS):
        at_q = [random.uniform(-1, 1) for _ in q]
        at_u = [random.uniform(-1, 1) for _ in u]
        at_letters = [random.uniform(0.5, 2) for _ in letters]
        # The rolling disk's point of contact comes first among the coordinates, and does not matter.
        own_q, own_u = at_q, at_u
        if row["model"] == "rolling disk":
            own_q, own_u = [0.3, -0.2] + at_q, [0.0, 0.0] + at_u
        own = scope["equations"](own_q, own_u, at_letters)
        other = theirs(*at_q, *at_u, *at_letters)
        largest = max(abs(x) for x in other)
        worst = max(worst, max(abs(a - b) for a, b in zip(own, other, strict=True)) / largest)
    assert len(own) == size * size + size
    return worst


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__.strip())
    run = subprocess.run([sys.argv[1]], stdout=subprocess.PIPE, text=True, check=True)
    rows = [json.loads(line) for line in run.stdout.splitlines()]
    print(f"Equations of motion (mass matrix and right-hand side) beside SymPy {sympy.__version__}, KanesMethod\n")
    print(f"{'model':<26} {'ms':>9} {'SymPy, ms':>11} {'ratio':>8}   {'operations':>10} {'SymPy':>9} {'its cse':>9} {'apart':>8}"
          f"   thorough: {'ms':>7} {'operations':>10}")
    agree = True
    for row in rows:
        if "model" not in row:
            continue
        letters = [sympy.Symbol(name, positive=True) for name in row["letters"]]
        begin = time.perf_counter()
        matrix, forcing, q, u = BUILDERS[row["model"]](letters)
        seconds = time.perf_counter() - begin
        operations = sum(int(sympy.count_ops(entry)) for entry in [*matrix, *forcing])
        replacements, reduced = sympy.cse([*matrix, *forcing])
        named = sum(int(sympy.count_ops(entry)) for _, entry in replacements) + sum(
            int(sympy.count_ops(entry)) for entry in reduced)
        difference = apart(row, matrix, forcing, q, u, letters)
        agree = agree and difference < TOLERANCE
        print(f"{row['model']:<26} {1e3 * row['seconds']:9.3f} {1e3 * seconds:11.1f} {seconds / row['seconds']:8.0f}   "
              f"{row['operations']:10d} {operations:9d} {named:9d} {difference:8.0e}"
              f"             {1e3 * row['thorough_seconds']:7.1f} {row['thorough_operations']:10d}", flush=True)
    print("\nInverse dynamics: generated C (cc -O3 -march=native) beside the engine's call, ns\n")
    print(f"{'model':<26} {'generated':>10} {'engine':>8} {'ratio':>7} {'operations':>11} {'apart':>8}")
    for row in rows:
        if "code" in row:
            print(f"{row['code']:<26} {row['generated']:10.0f} {row['engine']:8.0f} {row['engine'] / row['generated']:7.2f} "
                  f"{row['operations']:11d} {row['apart']:8.0e}")
    if not agree:
        sys.exit("bench_equations.py: the equations differ from SymPy's")


if __name__ == "__main__":
    main()
