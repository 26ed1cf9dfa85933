"""``quintrig basis``: what papers claim of their bases is found, and a misprint too."""

import json

import numpy as np
import pytest
from typer.testing import CliRunner

from quintrig.analysis.basis_checks import check_basis, check_end_derivative
from quintrig.basis.formulas import Basis, Parameter
from quintrig.basis.library import LIBRARY
from quintrig.cli.app import build

_PI = np.pi


@pytest.mark.parametrize("entry", LIBRARY, ids=lambda one: one.name)
def test_every_basis_of_the_library_keeps_what_its_paper_claims(entry):
    found = check_basis(entry.basis()).findings
    for key in ("partition_of_unity", "non_negative", "end_points"):
        assert found[key].holds, (key, found[key])
    if not found["independent"].holds:  # at an end of the range a function may vanish, as Ali's do for p = 0
        at = found["independent"].at
        assert any(at[one.name] in (one.low, one.high) for one in entry.basis().parameters), at
    if entry.name in ("bernstein", "lambda_bezier", "alpha_bernstein", "c_bezier", "h_bezier"):
        assert found["symmetry"].holds
    if entry.name in ("trigonometric", "quadratic", "cubic", "quartic", "quintic", "ali_cubic"):
        assert found["symmetry_with_swap"].holds
        assert not found["symmetry"].holds


def test_spaces_hold_lines_and_circles_as_known():
    reports = {one.name: check_basis(one.basis()) for one in LIBRARY}
    lines = {name for name, one in reports.items() if one.findings["lines"].holds}
    assert {"bernstein", "c_bezier", "h_bezier"} <= lines
    assert not lines & {"trigonometric", "quadratic", "cubic", "quartic", "normalised_trigonometric"}
    circles = {name for name, one in reports.items() if one.findings["circles"].holds}
    assert {"quadratic", "cubic", "normalised_trigonometric", "c_bezier"} <= circles
    assert not circles & {"trigonometric", "quartic", "bernstein"}
    assert reports["bernstein"].findings["total_positivity"].holds
    assert reports["bernstein"].findings["end_torsion"].holds
    assert not reports["trigonometric"].findings["end_torsion"].holds


def test_the_quintics_range_and_end_derivatives():
    found = check_basis(next(one for one in LIBRARY if one.name == "trigonometric").basis())
    for low, high in found.non_negative_range.values():
        assert low == pytest.approx(-4.0, abs=1e-6)
        assert high == pytest.approx(1.0, abs=1e-6)
    assert found.rational_degree == 10  # 8 where both parameters are 0
    at = found.end_derivatives["0"]
    assert at[1] == pytest.approx([-2 * _PI, 2 * _PI, 0, 0, 0, 0], abs=1e-10)
    assert at[2] == pytest.approx([3 * _PI**2, -6 * _PI**2, 3 * _PI**2, 0, 0, 0], abs=1e-9)
    assert at[3] == pytest.approx([-2.5 * _PI**3, 8.5 * _PI**3, -6 * _PI**3, 0, 0, 0], abs=1e-8)


def test_a_misprint_is_told_with_place_and_size():
    wrong = check_basis(Basis("wrong", ("r^2", "2*t*r", "1.1*t^2"))).findings
    assert wrong["partition_of_unity"].worst == pytest.approx(0.1)
    assert wrong["partition_of_unity"].at == {"t": 1.0}
    assert not wrong["end_points"].holds
    negative = check_basis(Basis("negative", ("1-t+t*r", "t-t*r", "t*r-t*r"))).findings
    assert not negative["independent"].holds
    below = check_basis(Basis("below", ("r*(1-lam*t)", "t*(1+lam*r)"), (Parameter("lam", 0.0, 2.0),)))
    assert below.findings["partition_of_unity"].holds
    assert below.findings["non_negative"].worst == pytest.approx(-0.125, abs=1e-4)
    assert below.findings["non_negative"].at["lam"] == 2.0


def test_negative_beside_an_end_by_less_than_samples_show():
    """(1 - s)⁴ (1 - αs) is -(α - 1)⁵ and smaller beside t = 1, for an α above 1."""
    quintic = next(one for one in LIBRARY if one.name == "quintic").basis()
    wider = (Parameter("alpha", -4.0, 1.001), Parameter("zeta", -4.0, 1.0))
    found = check_basis(Basis("wider", quintic.functions, wider))
    assert not found.findings["non_negative"].holds
    assert found.findings["non_negative"].at["alpha"] == pytest.approx(1.001)
    assert found.findings["non_negative"].at["t"] == 1.0


def test_command(tmp_path):
    run = CliRunner().invoke
    assert "Phillips 1997" in run(build(), ["basis"]).stdout
    data = json.loads(run(build(), ["basis", "cubic", "--json"]).stdout)
    assert data["name"] == "cubic"
    assert data["size"] == 4
    assert set(data["parameters"]) == {"alpha", "zeta"}
    for key in ("partition_of_unity", "non_negative", "end_points"):
        assert data[key] is True
        assert {"worst", "at", "how"} <= set(data["found"][key])
        assert "t" in data["found"][key]["at"]
    file = tmp_path / "paper.toml"
    file.write_text('[basis.mine]\nfunctions = ["r^2", "2*t*r", "1.1*t^2"]\n')
    data = json.loads(run(build(), ["basis", str(file), "--json"]).stdout)
    assert data["partition_of_unity"] is False
    assert data["found"]["partition_of_unity"]["worst"] == pytest.approx(0.1)
    assert data["found"]["partition_of_unity"]["at"]["t"] == 1.0
    page = tmp_path / "page.html"
    assert run(build(), ["basis", str(file), "--compare", "cubic,c_bezier", "-o", str(page)]).exit_code == 0
    text = page.read_text()
    assert text.count("<svg") == 5  # all, the curves of 3 and of 4 points, the effect of the parameters of two
    assert "<math" in text
    assert "\\frac" in text


def test_the_thesis_misprinted_end_derivatives_are_caught():
    quintic = next(one for one in LIBRARY if one.name == "trigonometric").basis()
    first = ("-pi/2*(4+alpha)", "pi/2*(4+alpha)", "0", "0", "0", "0")
    assert check_end_derivative(quintic, 0, 1, first).holds
    right = ("pi^2*(3+2*alpha)", "-2*pi^2*(3+alpha)", "3*pi^2", "0", "0", "0")
    assert check_end_derivative(quintic, 0, 2, right).holds
    # Thesis eq. (2.3) as printed: π²(3P2 - 2P1)(3 + α) + P0(3 + 2α), and its mirror image.
    printed = ("3+2*alpha", "-2*pi^2*(3+alpha)", "3*pi^2*(3+alpha)", "0", "0", "0")
    found = check_end_derivative(quintic, 0, 2, printed)
    assert not found.holds
    # For P2 it misses 3π²(2 + α), 9π² at α = 1; the largest coefficient of all is 8π².
    assert found.worst == pytest.approx(9 / 8, rel=1e-12)
    assert (found.at["t"], found.at["i"], found.at["alpha"]) == (0.0, 2.0, 1.0)
    mirrored = ("0", "0", "0", "3*pi^2*(3+zeta)", "-2*pi^2*(3+zeta)", "3+2*zeta")
    assert not check_end_derivative(quintic, 1, 2, mirrored).holds
    with pytest.raises(ValueError, match="expected 6"):
        check_end_derivative(quintic, 0, 2, ("1",))


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ('[basis.mine]\nfunctions = ["__import__(t)", "t"]\n', "functions[0]"),
        ('[basis.mine]\nfunctions = ["1/t", "t"]\n', "divides by zero"),
        ('[basis.mine]\nfunctions = ["t"]\n', "2 to 64"),
        ('[basis.cubic]\nfunctions = ["r", "t"]\n', "choose another name"),
        ("[bases]\n", "[basis.NAME]"),
        ("not toml", "mine.toml"),
    ],
)
def test_bad_input_is_told_in_one_line(tmp_path, text, word):
    from quintrig.support.errors import QuintrigError

    file = tmp_path / "mine.toml"
    file.write_text(text)
    error = CliRunner().invoke(build(), ["basis", str(file)]).exception
    assert isinstance(error, (ValueError, QuintrigError))
    assert word in str(error)
    assert "\n" not in str(error)


@pytest.mark.parametrize("arguments", [["nope"], ["cubic", "--compare", "cubik"], ["cubic", "-o", "a.png"]])
def test_bad_options_are_told_in_one_line(arguments):
    error = CliRunner().invoke(build(), ["basis", *arguments]).exception
    assert isinstance(error, ValueError)
    assert "\n" not in str(error)


PRINTED = "z''(0) = pi^2*(3*P2 - 2*P1)*(3 + alpha) + P0*(3 + 2*alpha)"
"""Thesis eq. (2.3), left end, as printed."""


def test_the_misprint_is_caught_from_the_command_line_and_from_a_file(tmp_path):
    run = CliRunner().invoke
    right = "z'(0) = pi/2*(4+alpha)*(P1-P0)"
    data = json.loads(run(build(), ["basis", "quintic", "--json", "--claim", PRINTED, "--claim", right]).stdout)
    wrong, fine = data["claims"]
    assert fine["finding"]["holds"] is True
    assert wrong["finding"]["holds"] is False
    assert wrong["finding"]["worst"] == pytest.approx(9 / 8, rel=1e-12)
    assert wrong["finding"]["at"]["alpha"] == 1.0
    assert wrong["point"] == "P2"
    known = _library("quintic")
    table = Basis("paper", known.functions, known.parameters, "", (PRINTED,))
    from quintrig.model.own_bases import table_of

    file = tmp_path / "paper.json"
    file.write_text(json.dumps({"basis": {"paper": table_of(table)}}))
    told = run(build(), ["basis", str(file)]).stdout
    assert "NO  claimed: z''(0)" in told
    assert "off by 1.12 of the largest coefficient for P2" in told
    page = tmp_path / "page.html"
    assert run(build(), ["basis", str(file), "-o", str(page)]).exit_code == 0
    assert "off by 1.12" in page.read_text()


@pytest.mark.parametrize("claim", ["hello", "z''''(0) = P0", "z(2) = P0", "z'(0) = P0^2", "z'(0) = t*P0", "z'(0) = P9"])
def test_what_is_no_claim_is_told_in_one_line(claim):
    error = CliRunner().invoke(build(), ["basis", "cubic", "--claim", claim]).exception
    assert isinstance(error, ValueError)
    assert "\n" not in str(error)


@pytest.mark.parametrize(
    "name", ["quintic", "cubic", "sg_bezier", "generalised_trigonometric", "q_bernstein", "c_bezier"]
)
def test_end_derivatives_are_formulas_in_the_parameters(name):
    pytest.importorskip("sympy")
    from quintrig.analysis.basis_ends import end_formulas
    from quintrig.basis.expression import series
    from quintrig.basis.grammar import parse

    basis = _library(name)
    found = end_formulas(basis)
    assert found is not None
    random = np.random.default_rng(3)
    for _ in range(3):
        values = [one.low + (one.high - one.low) * random.uniform(0.2, 0.8) for one in basis.parameters]
        family = basis.family(values)
        given = {one.name: np.asarray(x) for one, x in zip(basis.parameters, values, strict=True)}
        for end in (0, 1):
            true = family.derivatives(np.array([float(end)]), 3)[:, 0]
            for order in range(4):
                trees = [parse(text, given) for text in found[str(end)][order]]
                told = series(trees, np.zeros(1), 0, {k: v[None] for k, v in given.items()})[0, 0]
                assert told == pytest.approx(true[order], rel=1e-9, abs=1e-9 * np.abs(true[order]).max())


def test_signs_are_certified_or_said_to_be_sampled():
    how = {one.name: check_basis(one.basis()).findings["non_negative"].how for one in LIBRARY if one.usual <= 6}
    assert all("certified" in how[name] for name in ("quintic", "quadratic", "lambda_bezier", "sg_bezier", "ali_cubic"))
    assert how["c_bezier"] == "sampled"
    from quintrig.analysis.basis_sign import certified

    quintic = _library("quintic")
    for low, high in ((-4.0, 1.02), (-4.05, 1.0)):  # just outside of [-4, 1] a function is negative
        wider = tuple(Parameter(one.name, low, high) for one in quintic.parameters)
        assert not certified(Basis("wider", quintic.functions, wider))
    # Negative on an interval too short for samples: (t - 1/3)² - 1e-10.
    assert not certified(Basis("narrow", ("(t-1/3)^2-1e-10", "1-(t-1/3)^2+1e-10")))
    assert certified(Basis("touching", ("(t-1/3)^2", "1-(t-1/3)^2")))


def _library(name):
    return next(one for one in LIBRARY if one.name == name).basis()
