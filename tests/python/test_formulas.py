"""Answers in letters, as text, TeX and SymPy."""

import copy
import pickle
import random

import numpy as np
import pytest
import sympy

import poinsot
from poinsot import formulas


def test_formulas_of_a_blow(bent: poinsot.Problem) -> None:
    answer = bent.solve()["w"]
    assert answer.state == "needs_letters"
    assert answer.letters == ["m", "a", "J"] or set(answer.letters) == {"m", "a", "J"}
    m, a, J = sympy.symbols("m a J", real=True)
    found = answer.sympy()
    # By hand: the rod's tensor about its center, and H = r x J.
    r = sympy.Matrix([0, -a, a])
    blow = sympy.Matrix([J, 0, 0])
    mass = m / 4  # of a piece of length a; the rod is four of them
    inertia = sympy.zeros(3)
    x = sympy.Symbol("x")
    for start, end in (((0, -a, a), (0, 0, a)), ((0, 0, a), (0, 0, 0)), ((0, 0, 0), (0, 0, -a)), ((0, 0, -a), (0, a, -a))):
        p = sympy.Matrix(start) + x * (sympy.Matrix(end) - sympy.Matrix(start))
        density = (p.dot(p) * sympy.eye(3) - p * p.T) * mass
        inertia += density.applyfunc(lambda entry: sympy.integrate(sympy.expand(entry), (x, 0, 1)))
    by_hand = inertia.LUsolve(r.cross(blow))
    renamed = found.subs({letter: sympy.Symbol(letter.name, real=True) for letter in found.free_symbols})
    assert (renamed - by_hand).applyfunc(sympy.simplify) == sympy.zeros(3, 1)
    # Symbols are those that a user makes, unless the assumptions of the answer are asked for.
    assert found.free_symbols == set(sympy.symbols("m a J"))
    assumed = answer.sympy(assumptions=True)
    assert sympy.Symbol("a", positive=True) in assumed.free_symbols
    assert all(letter.is_real for letter in assumed.free_symbols)
    with pytest.raises(poinsot.NoAnswer, match="letters are open"):
        answer.value


def test_claims(bent: poinsot.Problem) -> None:
    result = bent.solve()
    assert result["more"].holds is True
    assert result["more"].claim is not None and result["more"].claim.how == "proved"
    assert result["less"].holds is False
    claim = result["less"].claim
    assert claim is not None
    left, right = claim.sides
    assert not left < right
    assert {one.letter for one in claim.counterexample} == {"m", "a", "J"}
    assert result["w"].holds is None


def test_letters_with_values_give_numbers(bent: poinsot.Problem) -> None:
    result = bent.solve(m=3, a=0.4, J=5)
    np.testing.assert_allclose(result["w"].value, [0, -60 / 8.4, 300 / 8.4], rtol=1e-12)
    assert result["w"].formula is None or result["w"].sympy() is not None


def random_formula(random_source: random.Random, depth: int) -> str:
    if depth == 0:
        return random_source.choice(["a", "b1", "w_x", "theta'", "pi", "2", "3/7", "0.25"])
    parts = [random_formula(random_source, depth - 1) for _ in range(2)]
    return random_source.choice(
        [
            "({0}) + ({1})",
            "({0}) - ({1})",
            "({0})*({1})",
            "({0})/({1})",
            "-({0})^2",
            "sqrt(({0})^2)",
            "atan2({0}, 1 + ({1})^2)",
            "cos({0})*sin({1})",
        ]
    ).format(*parts)


def test_random_formulas_read_as_python_would() -> None:
    source, tried = random.Random(4), 0
    values = {"a": 1.3, "b1": -0.7, "w_x": 2.1, "theta'": 0.4}
    names = {"sqrt": np.sqrt, "cos": np.cos, "sin": np.sin, "atan2": np.arctan2, "pi": np.pi, "theta_dot": 0.4}
    for _ in range(200):
        text = random_formula(source, source.randint(1, 3))
        python = text.replace("^", "**").replace("theta'", "theta_dot")
        with np.errstate(all="ignore"):
            try:
                wanted = eval(python, {}, names | values)
            except ZeroDivisionError:
                continue
        if not np.isfinite(wanted) or abs(wanted) > 1e6:
            continue
        found = formulas.to_sympy(text)
        number = found.subs({letter: values[letter.name] for letter in found.free_symbols})
        assert float(number) == pytest.approx(float(wanted), rel=1e-9, abs=1e-9), text
        tried += 1
    assert tried > 100


@pytest.mark.parametrize(
    "text, wanted",
    [
        ("-12*J/(7*m*a)", r"-\frac{12 \, J}{7 \, m \, a}"),
        ("omega1^2*theta'", r"\omega_{1}^{2} \, \dot{\theta}"),
        ("a - (b + c)", r"a - \left(b + c\right)"),
        ("sqrt(2)*I_xx", r"\sqrt{2} \, I_{xx}"),
        ("2*3^x", r"2 \cdot 3^{x}"),
    ],
)
def test_tex(text: str, wanted: str) -> None:
    assert formulas.tex(text) == wanted


@pytest.mark.parametrize("text", ["", "a +", "(a", "a b", "a $ b", "sin()", "a)"])
def test_what_is_no_formula(text: str) -> None:
    with pytest.raises(ValueError, match="is no formula"):
        formulas.parse(text)


def test_formulas_of_the_examples_are_understood() -> None:
    from pathlib import Path

    seen = 0
    for path in sorted((Path(__file__).parents[2] / "examples/textbook").glob("18.0[2-4]*.yaml")):
        for solution in poinsot.Problem.from_file(path).solve(timeout=20).solutions:
            for answer in solution.answers.values():
                if answer.formula is not None:
                    assert answer.tex is not None
                    answer.sympy()
                    seen += 1
    assert seen > 0


def test_data_become_letters(askew: poinsot.Problem) -> None:
    opened = askew.with_letters("m", "r", "n")
    assert opened.letters == {"m": "kg", "r": "m", "n": "rad/s"} and "m" not in opened.data and opened.data["b"] == "20 deg"
    assert askew.letters == {} and opened.text == askew.text
    m, r, n = sympy.symbols("m r n")
    found = opened.solve()["T"].sympy()
    # m r^2 n^2 (2 cos^2 b + sin^2 b)/8, with b = 20 deg.
    b = sympy.pi / 9
    by_hand = m * r**2 * n**2 * (2 * sympy.cos(b) ** 2 + sympy.sin(b) ** 2) / 8
    assert float((found / by_hand).subs({m: 3, r: 5, n: 7})) == pytest.approx(1, rel=1e-14)
    # With values they are what they were.
    for other in (opened, pickle.loads(pickle.dumps(opened)), copy.deepcopy(opened), askew.with_letters(["m", "r"]).with_letters("n")):
        assert other.solve(m="8 kg", r=0.15, n="1200 rpm")["T"].value == pytest.approx(askew.solve()["T"].value, rel=1e-14)
        assert other.solve()["T"].state == "needs_letters"
    # All of them.
    whole = askew.with_letters().solve()["B"]
    assert set(whole.letters) == {"m", "r", "b", "n", "L"}
    assert whole.sympy()[1].subs({"m": 8, "r": 0.15, "b": sympy.pi / 9, "n": 40 * sympy.pi, "L": 0.5}).evalf() == pytest.approx(
        askew.solve()["B"]["y"], rel=1e-12
    )
    assert opened.with_letters("n").letters == opened.letters


def test_letters_that_are_none(askew: poinsot.Problem) -> None:
    with pytest.raises(poinsot.StatementError, match="the letter q: error: the problem has no letter or datum 'q'"):
        askew.with_letters("q")
    with pytest.raises(TypeError, match="names is a list of texts"):
        askew.with_letters(3)  # type: ignore[arg-type]
    sought = poinsot.Problem.from_text(
        "given: {m: 2 kg, w: [1 rad/s, 2 rad/s, 3 rad/s]}\nfind: {F: N}\nbodies: {b: {particle: [0, 0, 0], mass: m}}\ngravity: none\n"
        "loads: {push: {body: b, force: [F, 0, 0]}}\ninstants: {now: {acceleration(b): [3 m/s^2, 0, 0]}}\nask: {F: F}"
    )
    assert sought.with_letters("m").solve()["F"].formula == "3*m"
    assert list(sought.with_letters().letters) == ["m"]
    with pytest.raises(poinsot.StatementError, match="'F' is to be found and no datum"):
        sought.with_letters("F")
    with pytest.raises(poinsot.StatementError, match="'w' is no number"):
        sought.with_letters("w")


def test_studies_of_letters(askew: poinsot.Problem) -> None:
    opened = askew.with_letters("m", "n")
    with pytest.raises(ValueError, match=r"m became letters by with_letters\(\): vary them by over, or give them values by sets"):
        poinsot.study(opened, {"n": [100.0]}, "T")
    study = poinsot.study(opened, {"n": [100.0, 200.0]}, "T", sets={"m": "4 kg"})
    assert study["T"] == pytest.approx([askew.solve(n=n, m=4)["T"].value for n in (100.0, 200.0)], rel=1e-12)
