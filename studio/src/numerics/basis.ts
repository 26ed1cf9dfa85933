/** The Bézier bases: quintic trigonometric with two shape parameters, and classical Bernstein. */

import { cosine, sinCos, sine, store, type Functions } from "./functions";
import { combine, jet, jets, powers, product, quotient, type Jet } from "./taylor";

const s = jet(), c = jet(), a = jet(), b = jet(), one = jet();
const a2 = jet(), b2 = jet(), both = jet(), factor = jet(), work = jet();
const hodograph = jets(5), across = jets(5);
one[0] = 1;

/** Whether a surface stands still at t = 0, and at t = 1. */
export type Still = readonly [boolean, boolean];
export const MOVING: Still = [false, false];

/** The six quintic trigonometric Bézier functions (Misro, Ramli and Ali 2017; thesis eq. 2.2). */
export class Trigonometric implements Functions {
  readonly size = 6;
  constructor(readonly alpha: number, readonly zeta: number, readonly still: Still = MOVING) {}

  /**
   * Values are products that do not cancel, derivatives differences of the hodograph's functions G. Beside still ends
   * second derivatives are those across the first, f (G / f)' with f = sin or cos: what runs along the first drops out of
   * every curvature, but its rounding would not.
   */
  derivatives(t: Float64Array, n: number, out: Float64Array): void {
    const { alpha, zeta } = this;
    for (let p = 0; p < n; p++) {
      const [start, end] = this.still;
      this.slopes(t[p]!, false, false, hodograph);
      if (start || end) {
        this.slopes(t[p]!, start, end, across);
        const factor = (start ? s[0]! : 1) * (end ? c[0]! : 1);
        for (let i = 0; i < 5; i++) hodograph[i]![1] = factor * across[i]![1]!;
      }
      const s0 = s[0]!, c0 = c[0]!, a0 = a[0]!, b0 = b[0]!, near = t[p]! < 0.5, at = 6 * p;
      out[at] = a0 ** 4 * (near ? 1 - alpha * s0 : 1 - alpha + alpha * a0);
      out[at + 1] = s0 * a0 ** 3 * (near ? 4 + alpha - alpha * s0 : 4 + alpha * a0);
      out[at + 2] = a0 ** 2 * b0 * (8 * s0 + 3 * c0 + 9);
      out[at + 3] = b0 ** 2 * a0 * (8 * c0 + 3 * s0 + 9);
      out[at + 4] = c0 * b0 ** 3 * (near ? 4 + zeta * b0 : 4 + zeta - zeta * c0);
      out[at + 5] = b0 ** 4 * (near ? 1 - zeta + zeta * b0 : 1 - zeta * c0);
      for (let k = 0; k < 2; k++) {
        const first = 6 * ((k + 1) * n + p);
        out[first] = -hodograph[0]![k]!;
        for (let i = 1; i < 5; i++) out[first + i] = hodograph[i - 1]![k]! - hodograph[i]![k]!;
        out[first + 5] = hodograph[4]![k]!;
      }
    }
  }

  /**
   * Write the series at t of the functions of the hodograph z'(t) = Σ G_i(t) (P_{i+1} - P_i) to `out`. With `start`
   * (`end`) all are divided by s (c), and 4 + α (4 + ζ) is left out: what remains where the curve stands still there.
   */
  slopes(t: number, start: boolean, end: boolean, out: readonly Jet[]): void {
    sinCos(t);
    rotation(sine, cosine, s);
    rotation(cosine, -sine, c);
    // 1 - sin and 1 - cos without cancellation: relative accuracy at both ends.
    combine(-1, s, 0, s, 0, a);
    combine(-1, c, 0, c, 0, b);
    a[0] = 2 * Math.sin(0.25 * Math.PI * (1 - t)) ** 2;
    b[0] = 2 * Math.sin(0.25 * Math.PI * t) ** 2;
    const near = t < 0.5, rising = start ? one : s, falling = end ? one : c;
    product(rising, falling, both);
    product(a, a, a2);
    product(b, b, b2);
    outerFactor(this.alpha, s, a, near, start, factor);
    product(falling, product(product(a2, a, work), factor, work), out[0]!);
    product(a2, both, out[1]!);
    combine(12, out[1]!, 0, one, 0, out[1]!);
    quotient(one, combine(1, s, 1, c, 1, work), work);
    combine(4, work, 32, one, 0, work);
    product(product(a, b, factor), product(both, work, work), out[2]!);
    product(b2, both, out[3]!);
    combine(12, out[3]!, 0, one, 0, out[3]!);
    outerFactor(this.zeta, c, b, !near, end, factor);
    product(rising, product(product(b2, b, work), factor, work), out[4]!);
    for (let i = 0; i < 5; i++) combine(0.5 * Math.PI, out[i]!, 0, one, 0, out[i]!);
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

/** Whether a surface on these rows of points stands still at either end: as at -4, or where two rows coincide. */
export function standing(alpha: number, zeta: number, rows: readonly (readonly (readonly number[])[])[]): Still {
  const same = (i: number, k: number) => rows[i]!.every((point, j) => point.every((x, q) => x === rows[k]![j]![q]));
  return [alpha === -4 || same(0, 1), zeta === -4 || same(rows.length - 1, rows.length - 2)];
}

/** C(n, k), exact as long as it is a safe integer. */
export function binomial(n: number, k: number): number {
  let result = 1;
  for (let i = 1; i <= k; i++) result = (result * (n - k + i)) / i;
  return result;
}

/** The series of 4 + α - 5α s, from a = 1 - s where not `near` the end where s = 0; -5α alone when `divided` by s. */
function outerFactor(alpha: number, s: Jet, a: Jet, near: boolean, divided: boolean, out: Jet): void {
  if (divided) return void combine(-5 * alpha, one, 0, s, 0, out);
  combine(-5 * alpha, s, 0, s, 0, out);
  out[0] = near ? 4 + alpha - 5 * alpha * s[0]! : 4 - 4 * alpha + 5 * alpha * a[0]!;
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
