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
        assert low == pytest.approx(-4.0, abs=0.01)
        assert high == pytest.approx(1.0, abs=0.01)
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
