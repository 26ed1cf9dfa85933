"""Numbers, units and sentences as HTML: real subscripts and superscripts, minus signs, powers of ten."""

import math
import re
from collections.abc import Sequence

from markupsafe import Markup, escape

_DASH = "–"  # an undefined value
_RAISED = re.compile(
    r"(?P<mantissa>(?<![\w.])-?\d+(?:\.\d+)?)e(?P<exponent>[+-]?\d+)"
    r"|(?P<greek>[κβγαζ])(?P<index>[0-9])(?P<own>ˢ?)"
    r"|\bS_(?P<partial>[uv]{1,2})\b"
    r"|\bn_(?P<part>[xyz])\b|\bd(?P<direction>[12])(?:_(?P<axis>[xyz]))?\b"
    r"|\^\((?P<power>\d/\d)\)"
    r"|(?P<order>&[lg]t;=)"
    r"|(?P<letter>(?<![\w&./])[KHSCEFGLMNRuvnxyz](?![A-Za-z0-9_]|\.\w|&#39;))"
    r"|(?P<minus>(?<![\w.)\]²])-(?=[\d.])|(?<= )-(?= )|(?<=\()-(?=\))|^-$)|(?P<mark>ˢ)"
)


def digits_of(value: float, digits: int = 4) -> Markup:
    """Return a number with this many significant digits, a power of ten where it is very large or small."""
    if math.isnan(value):
        return Markup(_DASH)
    if math.isinf(value):
        return Markup("∞" if value > 0 else "−∞")
    if value == 0.0:
        return Markup("0")
    mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
    power = int(exponent)
    if -4 <= power < 7:
        text = f"{float(value):.{max(digits - 1 - power, 0)}f}"
        if power >= digits:
            text = f"{round(value, digits - 1 - power):.0f}"
        text = text.rstrip("0").rstrip(".") if "." in text else text
        return Markup(_signed(_grouped(text)))
    mantissa = mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa
    return Markup(_signed(mantissa)) + ten(power, times=True)


def ten(power: int, times: bool = False) -> Markup:
    """Return a power of ten, after a multiplication sign where ``times``."""
    return Markup("{}10<sup>{}</sup>").format("\u202f×\u202f" if times else "", _signed(str(power)))


def measure(value: float, unit: str, digits: int = 4) -> Markup:
    """Return a number with its unit."""
    return digits_of(value, digits) + (Markup("\u00a0") + escape(unit) if unit else Markup(""))


def span(low: float, high: float, unit: str, digits: int = 3) -> Markup:
    """Return a range in words, both ends with one power of ten: from -13.6 × 10⁻⁶ to 173 × 10⁻⁶ 1/mm²; 0 is plain."""
    power, texts = aligned((low, high), digits)
    scale = Markup("\u202f×\u202f") + ten(power) if power else Markup("")
    ends = [escape(text.strip("\u2007\u2008")) for text in texts]
    first, last = (end + scale if value else end for end, value in zip(ends, (low, high), strict=True))
    return Markup("from {} to {}{}").format(first, last, Markup("\u00a0") + escape(unit) if unit else Markup(""))


def percent(share: float) -> str:
    """Return a share in whole percent, with decimals only where it is near to none or all."""
    hundred = 100.0 * share
    if 0.0 < hundred < 0.05:
        return "less than 0.1\u00a0%"
    if 99.95 <= hundred < 100.0 - 1e-9:
        return "more than 99.9\u00a0%"
    text = f"{hundred:.0f}" if 1.0 <= hundred <= 99.0 or hundred in (0.0, 100.0) else f"{hundred:.1f}"
    return f"{text.removesuffix('.0')}\u00a0%"


def pair(u: float, v: float) -> Markup:
    """Return parameters such as (0.5, 1)."""
    return Markup("({},\u00a0{})").format(*(_signed(f"{x + 0.0:.4g}") for x in (u, v)))


def listed(parts: Sequence[str]) -> str:
    """Return phrases as a list in prose: a, b and c."""
    return parts[0] if len(parts) == 1 else f"{', '.join(parts[:-1])} and {parts[-1]}"


def prose(text: object) -> Markup:
    """Return a sentence of ours, or a symbol or unit, with its notation set as HTML; everything in it is escaped."""
    return Markup(_RAISED.sub(_set, str(escape(text))))


def aligned(values: Sequence[float], digits: int = 5) -> tuple[int, tuple[str, ...]]:
    """Return a common power of ten for a column, and its numbers padded so that their decimal points align.

    Each has ``digits`` significant digits, and at most that many decimals; one that would vanish keeps its own power.
    """
    sizes = [abs(value) for value in values if math.isfinite(value) and value != 0.0]
    largest = max(sizes, default=0.0)
    power = 0 if not sizes or 0.1 <= largest < 1e5 else 3 * math.floor(math.log10(largest) / 3.0)
    texts = [_decimal(value, power, digits) for value in values]
    longest = max((len(text.partition(".")[2]) for text in texts), default=0)
    return power, tuple(_padded(text, longest) for text in texts)


def _decimal(value: float, power: int, digits: int) -> str:
    if math.isnan(value):
        return _DASH
    if math.isinf(value):
        return "∞" if value > 0 else "−∞"
    scaled = value / 10.0**power
    if scaled == 0.0:
        return "0"
    before = math.floor(math.log10(abs(scaled))) + 1
    if before < 1 - digits:
        mantissa, exponent = f"{scaled:.1e}".split("e")
        raised = str(int(exponent)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
        return _signed(f"{mantissa.removesuffix('.0')}·10{raised}")
    text = f"{scaled:.{min(max(digits - before, 0), digits)}f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return _signed(text)


def _padded(text: str, decimals: int) -> str:
    """Fill up with spaces as wide as digits and as the point."""
    whole, point, fraction = text.partition(".")
    if not decimals or "·" in text:
        return text
    return text + ("" if point else "\u2008") + "\u2007" * (decimals - len(fraction)) if whole else text


def _signed(text: str) -> str:
    return "0" if text in ("-0", "-0.0") else text.replace("-", "−")


def _grouped(text: str) -> str:
    """Part the thousands of numbers of five digits or more by narrow spaces."""
    sign, digits = ("-", text[1:]) if text.startswith("-") else ("", text)
    whole, point, fraction = digits.partition(".")
    return f"{sign}{int(whole):,}".replace(",", "\u202f") + point + fraction if len(whole) > 4 else text


def _set(match: re.Match[str]) -> str:
    """Return one piece of notation as HTML."""
    part = match.groupdict()
    if part["mantissa"]:
        power = str(ten(int(part["exponent"])))
        result = power if part["mantissa"] == "1" else f"{_signed(part['mantissa'])}\u202f×\u202f{power}"
        result = "0" if float(part["mantissa"]) == 0.0 else result
    elif part["greek"]:
        result = f"<i>{part['greek']}</i><sub>{part['index']}</sub>" + ("<sup>S</sup>" if part["own"] else "")
    elif part["partial"] or part["part"]:
        result = f"<i>{'S' if part['partial'] else 'n'}</i><sub><i>{part['partial'] or part['part']}</i></sub>"
    elif part["direction"]:
        axis = f"<i>{part['axis']}</i>" if part["axis"] else ""
        result = f"<b>d</b><sub>{part['direction']}{axis}</sub>"
    elif part["power"]:
        result = f"<sup>{part['power']}</sup>"
    elif part["order"]:
        result = "≤" if part["order"] == "&lt;=" else "≥"
    else:
        result = "−" if part["minus"] else "<sup>S</sup>" if part["mark"] else f"<i>{part['letter']}</i>"
    return result
