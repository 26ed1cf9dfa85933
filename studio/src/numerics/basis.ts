/** The Bézier bases: quintic trigonometric with two shape parameters, and classical Bernstein. */

import { cosine, sinCos, sine, store, type Functions } from "./functions";
import { combine, integral, jet, jets, powers, product, slope, type Jet } from "./taylor";

export type BasisName = "trigonometric" | "bernstein";

const s = jet(), c = jet(), a = jet(), b = jet();
const f0 = jet(), f1 = jet(), f2 = jet(), f3 = jet(), f4 = jet(), f5 = jet();
const x2 = jet(), x3 = jet(), x4 = jet(), q = jet(), speed = jet(), work = jet(), more = jet();

/** The six quintic trigonometric Bézier functions (Misro, Ramli and Ali 2017; thesis eq. 2.2). */
export class Trigonometric implements Functions {
  readonly size = 6;
  constructor(readonly alpha: number, readonly zeta: number) {}

  derivatives(t: Float64Array, n: number, out: Float64Array): void {
    for (let p = 0; p < n; p++) {
      const value = t[p]!;
      sinCos(value);
      rotation(sine, cosine, s);
      rotation(cosine, -sine, c);
      // 1 - sin and 1 - cos without cancellation: relative accuracy at both ends.
      combine(-1, s, 0, s, 0, a);
      combine(-1, c, 0, c, 0, b);
      a[0] = 2 * Math.sin(0.25 * Math.PI * (1 - value)) ** 2;
      b[0] = 2 * Math.sin(0.25 * Math.PI * value) ** 2;
      const nearStart = value < 0.5;
      endPair(s, a, this.alpha, nearStart, f0, f1);
      endPair(c, b, this.zeta, !nearStart, f5, f4);
      product(product(a, a, work), b, work);
      product(work, combine(8, s, 3, c, 9, more), f2);
      product(product(b, b, work), a, work);
      product(work, combine(8, c, 3, s, 9, more), f3);
      store(f0, out, n, p, 6, 0);
      store(f1, out, n, p, 6, 1);
      store(f2, out, n, p, 6, 2);
      store(f3, out, n, p, 6, 3);
      store(f4, out, n, p, 6, 4);
      store(f5, out, n, p, 6, 5);
    }
  }
}

/** The Bernstein polynomials of any degree. */
export class Bernstein implements Functions {
  readonly size: number;
  constructor(readonly degree: number) {
    this.size = degree + 1;
  }

  derivatives(t: Float64Array, n: number, out: Float64Array): void {
    const x = jet(), rest = jet(), form = bernsteinForm(this.degree);
    x[1] = 1;
    rest[1] = -1;
    for (let p = 0; p < n; p++) {
      x[0] = t[p]!;
      rest[0] = 1 - t[p]!;
      form(x, rest, out, n, p);
    }
  }
}

/** Bernstein polynomials in w = tan(πt/4), where the exact rational form of trigonometric curves lives. */
export class TangentBernstein implements Functions {
  readonly size: number;
  constructor(readonly degree: number) {
    this.size = degree + 1;
  }

  derivatives(t: Float64Array, n: number, out: Float64Array): void {
    const rate = 0.25 * Math.PI;
    const w = jet(), rest = jet(), form = bernsteinForm(this.degree);
    for (let p = 0; p < n; p++) {
      const value = t[p]!;
      w[0] = value === 1 ? 1 : Math.tan(rate * value);
      w[1] = rate * (w[0] * w[0] + 1);
      w[2] = (rate / 2) * (2 * w[0] * w[1]);
      combine(-1, w, 0, w, 0, rest);
      rest[0] = Math.tan(rate * (1 - value)) * (1 + w[0]); // 1 - tan x = tan(π/4 - x)(1 + tan x)
      form(w, rest, out, n, p);
    }
  }
}

/** The basis called `name` for this many control points. */
export function family(name: BasisName, points: number, alpha: number, zeta: number): Functions {
  return name === "trigonometric" ? new Trigonometric(alpha, zeta) : new Bernstein(points - 1);
}

/** C(n, k), exact as long as it is a safe integer. */
export function binomial(n: number, k: number): number {
  let result = 1;
  for (let i = 1; i <= k; i++) result = (result * (n - k + i)) / i;
  return result;
}

/**
 * Write the series of f0 = a⁴ (1 - α s) and f1 = s a³ (4 + α - α s), a = 1 - s, integrated from slopes whose terms do
 * not cancel near the end where s = 0, whatever α.
 */
function endPair(s: Jet, a: Jet, alpha: number, near: boolean, first: Jet, second: Jet): void {
  product(a, a, x2);
  product(x2, a, x3);
  product(x2, x2, x4);
  linear(s, a, 4 + alpha, 4, near, q);
  product(slope(s, speed), x2, speed);
  product(s, x3, second);
  const value1 = second[0]! * q[0]!;
  product(a, linear(s, a, 4 + alpha, 4 - 4 * alpha, near, work), work);
  product(speed, work, work);
  combine(-1, work, 0, work, 0, work);
  const value0 = x4[0]! * linear(s, a, 1, 1 - alpha, near, more)[0]!;
  integral(work, value0, first);
  product(combine(1, a, -3, s, 0, work), q, work);
  product(s, a, more);
  combine(1, work, -alpha, more, 0, work);
  integral(product(speed, work, work), value1, second);
}

/** The series of a linear function of s from its values at s = 0 and s = 1. */
function linear(s: Jet, a: Jet, atStart: number, atEnd: number, near: boolean, out: Jet): Jet {
  const rise = atEnd - atStart;
  combine(rise, s, 0, s, 0, out);
  out[0] = near ? atStart + rise * s[0]! : atEnd - rise * a[0]!;
  return out;
}

/** The series of a function with f'' = -(π/2)² f, from f and f' / (π/2). */
function rotation(value: number, derivative: number, out: Jet): void {
  const rate = 0.5 * Math.PI;
  out[0] = value;
  out[1] = rate * derivative;
  out[2] = (rate * rate * -value) / 2;
}

type Form = (x: Jet, rest: Jet, out: Float64Array, n: number, p: number) => void;

/** A function that writes C(n, i) x^i (1 - x)^(n - i), given x and 1 - x apart. */
function bernsteinForm(degree: number): Form {
  const up = jets(degree + 1), down = jets(degree + 1), term = jet();
  const factors = up.map((_, i) => binomial(degree, i));
  return (x, rest, out, n, p) => {
    powers(x, degree, up);
    powers(rest, degree, down);
    for (let i = 0; i <= degree; i++) {
      product(up[i]!, down[degree - i]!, term);
      combine(factors[i]!, term, 0, term, 0, term);
      store(term, out, n, p, degree + 1, i);
    }
  };
}
