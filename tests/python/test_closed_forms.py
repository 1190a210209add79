"""Closed forms: exact sums of square roots."""

import sys
import types
from fractions import Fraction

import pytest

import hottel
from conftest import SCENES


@pytest.fixture
def strips():
    return hottel.Simulation(hottel.read_scene(SCENES / "analytic/strip_obstructed.json"))


def test_a_pair_is_an_exact_number(strips):
    exact = strips.exact("bottom", "top")
    assert str(exact) == "-2 + 1*sqrt(5)" == strips.exact_form("bottom", "top")["exchange"]
    assert exact.terms == ((Fraction(-2), 1), (Fraction(1), 5))
    area = strips.factors.areas[strips.factors.index("bottom")]
    assert float(exact) / area == pytest.approx(strips.factors["bottom", "top"]["factor"], rel=1e-15)
    assert float(exact) == 0.2360679774997897


def test_sums_are_reckoned_with_exactly(strips):
    exact = strips.exact("bottom", "top")
    assert exact == strips.exact("top", "bottom") and not exact - exact and exact.sign() == 1
    third = exact * Fraction(1, 3)
    assert third + third + third == exact == "1/3" * exact + 2 * third
    assert third < exact and not exact < third and (third - exact).sign() == -1 and (exact - exact).terms == ()
    assert exact != 3 and (exact * 0.1).terms[0][0] == Fraction(-1, 5)


def test_what_is_no_number_is_refused(strips):
    exact = strips.exact("bottom", "top")
    for factor in (None, [], 1j):
        with pytest.raises(TypeError):
            exact * factor
    for factor in (float("nan"), "x"):
        with pytest.raises(hottel.InputError):
            exact * factor
    with pytest.raises(TypeError):
        exact + 1
    for names in (("x", "top"), ("sky", "top")):
        with pytest.raises(hottel.UsageError):
            strips.exact(*names)
    with pytest.raises(hottel.UsageError):
        hottel.Simulation(hottel.read_scene(SCENES / "space/cube.json")).exact("floor", "ceiling")


def test_sympy_has_them_where_it_is_installed(strips, monkeypatch):
    monkeypatch.setitem(sys.modules, "sympy", types.SimpleNamespace(
        Integer=float, Rational=lambda p, q: p / q, sqrt=lambda n: n**0.5))
    assert strips.exact("bottom", "top").sympy() == pytest.approx(5**0.5 - 2, rel=1e-15)
    monkeypatch.setitem(sys.modules, "sympy", None)
    with pytest.raises(ImportError):
        strips.exact("bottom", "top").sympy()
