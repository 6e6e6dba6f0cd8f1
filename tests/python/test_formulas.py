"""Answers in letters, as text, TeX and SymPy."""

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
