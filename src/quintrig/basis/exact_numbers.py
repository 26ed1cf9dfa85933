"""Numbers a + b√2 ± error, a and b fractions: what the coefficients of exact forms are made of.

Where the error is 0 the number is exact, and so are sums and products. Quintic trigonometric functions need fractions
only, those with half right angles √2, and others the sine or cosine of a parameter, which is a double and its error.
"""

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quintrig.basis.rational import NotRationalError
from quintrig.support.arrays import FloatArray

Exact = NDArray[Any]
"""An array of int, ``Fraction`` and ``Surd``."""

_ROOT = Fraction(math.sqrt(2.0))
_ROOT_OFF = Fraction(math.ulp(math.sqrt(2.0)))
_LIBRARY = 4
"""Units in the last place by which the C library's sine, cosine and root may be off; they are off by less than one."""


@dataclass(frozen=True)
class Surd:
    """``rational`` + ``root`` √2, to within ``error``."""

    rational: Fraction
    root: Fraction = Fraction(0)
    error: Fraction = Fraction(0)

    def __bool__(self) -> bool:
        """Return whether the number may be other than 0."""
        return bool(self.rational or self.root or self.error)

    def __add__(self, other: "Surd | Fraction | int") -> "Surd":
        """Return the sum."""
        y = _surd(other)
        return Surd(self.rational + y.rational, self.root + y.root, self.error + y.error)

    def __neg__(self) -> "Surd":
        """Return the number with the other sign."""
        return Surd(-self.rational, -self.root, self.error)

    def __sub__(self, other: "Surd | Fraction | int") -> "Surd":
        """Return the difference."""
        return self + -_surd(other)

    def __rsub__(self, other: "Surd | Fraction | int") -> "Surd":
        """Return the difference."""
        return -self + other

    def __mul__(self, other: "Surd | Fraction | int") -> "Surd":
        """Return the product."""
        y = _surd(other)
        rational = self.rational * y.rational + 2 * self.root * y.root
        root = self.rational * y.root + self.root * y.rational
        error = Fraction(0)
        if self.error or y.error:
            error = self.error * (y.size + y.error) + self.size * y.error
        return Surd(rational, root, error)

    __radd__, __rmul__ = __add__, __mul__

    @property
    def size(self) -> Fraction:
        """An upper bound of the absolute value of a + b√2."""
        return abs(self.rational) + abs(self.root) * (_ROOT + _ROOT_OFF)

    def inverse(self) -> "Surd":
        """Return 1 / x; NotRationalError where x may be 0."""
        norm = self.rational**2 - 2 * self.root**2
        if not self.error and norm:
            return Surd(self.rational / norm, -self.root / norm)
        middle, off = self.rounded()
        if off >= abs(middle):
            raise NotRationalError("they divide by what may be zero")
        return Surd(1 / middle, Fraction(0), off / (abs(middle) * (abs(middle) - off)))

    def rounded(self) -> tuple[Fraction, Fraction]:
        """Return a fraction and by how much it may be off."""
        return self.rational + self.root * _ROOT, self.error + abs(self.root) * _ROOT_OFF


def _surd(value: Surd | Fraction | int) -> Surd:
    return value if isinstance(value, Surd) else Surd(Fraction(value))


def plain(value: Any) -> Any:
    """Return a ``Surd`` without √2 and error as the fraction that it is, anything else as it is."""
    return value.rational if isinstance(value, Surd) and not value.root and not value.error else value


def divided(x: Any, y: Any) -> Any:
    """Return x / y; NotRationalError where y may be 0."""
    return plain(x * _surd(y).inverse())


def called(function: str, x: Any) -> Any:
    """Return a function of the grammar at a number; NotRationalError for those whose error is not known."""
    if function == "sqrt" and not isinstance(x, Surd):
        for half, unit in ((x, Surd(Fraction(1))), (Fraction(x) / 2, Surd(Fraction(0), Fraction(1)))):
            root = Fraction(math.isqrt(half.numerator), math.isqrt(half.denominator)) if half > 0 else Fraction(0)
            if root * root == half:
                return plain(unit * root)
    if function not in ("sin", "cos"):
        raise NotRationalError(f"{function} of a parameter has no known rounding")
    middle, off = _surd(x).rounded()
    at = float(middle)
    value = math.sin(at) if function == "sin" else math.cos(at)
    error = off + abs(middle - Fraction(at)) + _LIBRARY * Fraction(math.ulp(value))
    return Surd(Fraction(value), Fraction(0), error)


PI = Surd(Fraction(math.pi), Fraction(0), Fraction(math.ulp(math.pi)))


def doubles(values: Exact) -> tuple[FloatArray, FloatArray]:
    """Return the nearest doubles of exact numbers and bounds of their errors, both of the same shape."""
    middle: FloatArray = np.zeros(values.shape)
    error: FloatArray = np.zeros(values.shape)
    for index, value in np.ndenumerate(values):
        exact, off = value.rounded() if isinstance(value, Surd) else (value, 0)
        near = float(exact)
        middle[index] = near
        if off or Fraction(near) != exact:
            error[index] = math.nextafter(float(abs(exact - Fraction(near)) + off), math.inf)
    return middle, error


def fractions(values: FloatArray) -> Exact:
    """Return doubles as the fractions that they are."""
    result: Exact = np.empty(np.shape(values), dtype=object)
    for index, value in np.ndenumerate(values):
        result[index] = Fraction(float(value))
    return result
