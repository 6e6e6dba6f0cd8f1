#!/usr/bin/env python3
"""poinsot equations: every form gives the same numbers, C compiles alone, and what is wrong is refused.

usage: equations_test.py PROGRAM SOURCE_FOLDER
"""
import ctypes
import math
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])

PENDULUM = """title: Double pendulum, driven cart
letters: {m: kg, L: m, k: N*m/rad}
gravity: [0, 0, -9.81 m/s^2]
points: {O: [0, 0, 0], A: [0, 0, -L], B: [L/3, 0, -2*L]}
bodies:
  cart: {sphere: {center: O, radius: L/4}, mass: 2*m}
  first: {rod: [O, A], mass: m}
  second: {rod: [A, B], mass: m}
joints:
  rail: {prismatic: x, to: cart, displacement: s, rate: 1 m/s, accel: 0}
  top: {revolute: y, at: O, from: cart, to: first, angle: alpha, spring: {stiffness: k}}
  elbow: {revolute: x, at: A, from: first, to: second, angle: beta}
ask: {T: kinetic_energy(first)}
"""


CRATE = """title: A crate that slides on its rough edge, free in a plane
letters: {m: kg, I: kg*m^2, mu: 1}
gravity: [0, -9.81 m/s^2, 0]
points: {A: [0, 0, 0], G: [0.3 m, 0.4 m, 0]}
bodies: {crate: {mass: m, center: G, inertia: {axis: z, axial: I, transverse: I}}}
joints:
  free: {planar: z, at: G, to: crate, freedoms: {slide1: {displacement: X}, slide2: {displacement: Y}, turn: {angle: th}}}
contacts: {edge: {of: crate, corner: A, normal: y, friction: mu}}
instants: {now: {"X'": 1 m/s, "Y'": 0 m/s, "th'": 0 rad/s}}
ask: {N: normal_force(edge)}
"""


def run(*arguments, text=PENDULUM):
    return subprocess.run([PROGRAM, "equations", "-", *arguments], input=text, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, timeout=120, check=False)


def python_function(*arguments, text=PENDULUM):
    result = run("--form", "python", *arguments, text=text)
    assert result.returncode == 0, result.stderr
    scope = {}
    exec(result.stdout, scope)
    return scope["equations"]


def samples(count=4):
    random.seed(3)
    for _ in range(count):
        yield [[random.uniform(-1, 1) for _ in range(3)] for _ in range(3)] + [[random.uniform(0.5, 2) for _ in range(3)]]


class Forms(unittest.TestCase):
    def assert_near(self, found, expected):
        self.assertEqual(len(found), len(expected))
        size = max(abs(x) for x in expected)
        for a, b in zip(found, expected):
            self.assertLessEqual(abs(a - b), 1e-12 * size)

    @unittest.skipUnless(shutil.which("cc") and shutil.which("c++"), "no compiler")
    def test_c_and_cpp_compile_alone_and_agree_with_python(self):
        for parts in ("mass-matrix,right-hand-side", "forward-dynamics", "inverse-dynamics"):
            python = python_function("--of", parts)
            for form, ending, compiler in (("c", "c", ["cc", "-std=c99"]), ("c++", "cpp", ["c++", "-std=c++17"])):
                with tempfile.TemporaryDirectory() as folder:
                    source = pathlib.Path(folder) / f"code.{ending}"
                    result = run("--form", form, "--of", parts, "--name", "model", "-o", str(source))
                    self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
                    if form == "c++":
                        source.write_text(source.read_text().replace("inline void", 'extern "C" void'))
                    library = pathlib.Path(folder) / "code.so"
                    subprocess.run([*compiler, "-Wall", "-Wextra", "-Werror", "-pedantic", "-shared", "-fPIC", "-o",
                                    library, source, "-lm"], check=True)
                    function = ctypes.CDLL(str(library)).model
                    for arguments in samples():
                        expected = python(*arguments)
                        out = (ctypes.c_double * len(expected))()
                        function(*[(ctypes.c_double * len(a))(*a) for a in arguments], out)
                        self.assert_near(list(out), expected)

    def test_mass_matrix_times_accelerations_is_the_force(self):
        matrices, inverse = python_function(), python_function("--of", "inverse-dynamics")
        for q, v, a, parameters in samples():
            numbers = matrices(q, v, a, parameters)
            M, F = numbers[:9], numbers[9:]
            self.assert_near(inverse(q, v, a, parameters),
                             [sum(M[3 * i + j] * a[j] for j in range(3)) - F[i] for i in range(3)])

    def test_forward_dynamics_undoes_inverse_dynamics(self):
        forward, inverse = python_function("--of", "forward-dynamics"), python_function("--of", "inverse-dynamics")
        for q, v, a, parameters in samples():
            effort = inverse(q, v, a, parameters)
            # The cart is driven: its acceleration is given in both.
            found = forward(q, v, [a[0], *effort[1:]], parameters)
            for x, y in zip(found, a):
                self.assertAlmostEqual(x, y, delta=1e-10)

    def test_what_slides_on_a_rough_floor_moves_by_newton_and_euler(self):
        forward, matrices = (python_function(*more, text=CRATE) for more in (("--of", "forward-dynamics"), ()))
        random.seed(7)
        for _ in range(20):
            m, inertia, mu = (random.uniform(0.3, 3) for _ in range(3))
            q, v, u = ([random.uniform(-1, 1) for _ in range(3)] for _ in range(3))
            turn, w = q[2], v[2]
            x, y = -0.3*math.cos(turn) + 0.4*math.sin(turn), -0.3*math.sin(turn) - 0.4*math.cos(turn)
            push = (9.81 + w*w*y - u[1]/m - x*u[2]/inertia)/(1/m + x*(x + mu*y)/inertia)
            expected = [(u[0] - mu*push)/m, (u[1] + push)/m - 9.81, (u[2] + (x + mu*y)*push)/inertia]
            self.assert_near(forward(q, v, u, [m, inertia, mu]), expected)
            numbers = matrices(q, v, u, [m, inertia, mu])
            self.assert_near(numbers[-3:], [-mu, 1, x + mu*y])

    def test_sympy_agrees_with_python(self):
        try:
            import sympy
        except ImportError:
            self.skipTest("no SymPy")
        result = run("--form", "sympy")
        self.assertEqual(result.returncode, 0, result.stderr)
        scope = {}
        exec(result.stdout, scope)
        names = ["s", "alpha", "beta", "s_dot", "alpha_dot", "beta_dot", "m", "L", "k"]
        for q, v, a, parameters in samples(2):
            values = dict(zip([scope[name] for name in names], [*q, *v, *parameters]))
            found = [float(x) for x in [*scope["M"].subs(values), *scope["F"].subs(values)]]
            self.assert_near(found, python_function()(q, v, a, parameters))
        self.assertEqual(sympy.simplify(scope["M"] - scope["M"].T), sympy.zeros(3, 3))

    def test_text_and_tex_name_what_there_is(self):
        text = run().stdout
        for part in ("Double pendulum", "alpha'", "rad/s", "driven as given", "M[1, 1] = ", "F[2] = "):
            self.assertIn(part, text)
        tex = run("--form", "tex").stdout
        for part in ("\\begin{align*}", "\\dot{\\alpha}", "\\end{align*}"):
            self.assertIn(part, tex)

    def test_a_letter_that_is_set_is_a_number(self):
        self.assertIn("parameters[2]", run("--form", "c").stdout)
        self.assertNotIn("parameters[2]", run("--form", "c", "--set", "m=2 kg").stdout)


class Refusals(unittest.TestCase):
    def assert_refused(self, code, message, *arguments, text=PENDULUM):
        result = run(*arguments, text=text)
        self.assertEqual((result.returncode, result.stdout), (code, ""))
        self.assertIn(message, result.stderr)

    def test_words(self):
        self.assert_refused(2, "--form knows no 'latex': expected text, tex, c, c++, python, sympy", "--form", "latex")
        self.assert_refused(2, "did you mean 'mass-matrix'?", "--of", "mass-matrx")
        self.assert_refused(2, "cannot be the name of a function", "--name", "while")
        self.assert_refused(2, "ask for one at a time", "--of", "forward-dynamics,inverse-dynamics")
        self.assert_refused(2, "it has", "--set", "unknown=3 kg")

    def test_what_cannot_move(self):
        fixed = "bodies: {ball: {sphere: {center: [0, 0, 0], radius: 1 m}, mass: 1 kg}}\n" \
                "joints: {wall: {weld: [0, 0, 0], to: ball}}\nask: {m: mass(ball)}\n"
        self.assert_refused(1, "nothing in it can move", text=fixed)

    def test_nothing_is_overwritten_unless_forced(self):
        with tempfile.TemporaryDirectory() as folder:
            problem, other = pathlib.Path(folder, "p.yaml"), pathlib.Path(folder, "p.py")
            problem.write_text(PENDULUM, encoding="utf-8")
            other.write_text("mine = 1\n", encoding="utf-8")

            def write(output, *more):
                return subprocess.run([PROGRAM, "equations", problem, "-o", output, *more], stdout=subprocess.PIPE,
                                      stderr=subprocess.PIPE, text=True, timeout=120, check=False)
            for more in [(), ("--force",)]:
                result = write(problem, *more)
                self.assertEqual((result.returncode, result.stderr),
                                 (2, f"poinsot: cannot write {problem}: it is the problem file\n"))
                self.assertEqual(problem.read_text(encoding="utf-8"), PENDULUM)
            result = write(other)
            self.assertEqual((result.returncode, result.stderr),
                             (2, f"poinsot: {other} is there already and is not overwritten: add --force, or name "
                                 "another file\n"))
            self.assertEqual(other.read_text(encoding="utf-8"), "mine = 1\n")
            self.assertEqual(write(other, "--force").returncode, 0)
            self.assertNotIn("mine", other.read_text(encoding="utf-8"))

    def test_output_that_cannot_be_written(self):
        self.assert_refused(3, "cannot write /nowhere/x.c", "-o", "/nowhere/x.c")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
