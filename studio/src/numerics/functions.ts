/** Elementary families of functions on [0, 1]: what the closed-form reference surfaces are made of. */

import { jet, jets, powers } from "./taylor";

/** A tuple of `size` scalar functions on [0, 1]. */
export interface Functions {
  readonly size: number;
  /** Write derivatives 0 to 2 at t[0], ..., t[n - 1] to out[(k n + p) size + i]. */
  derivatives(t: Float64Array, n: number, out: Float64Array): void;
}

const HALF_PI = 0.5 * Math.PI;

/** cos q and sin q, the angle q running from `start` to `end`, counted in right angles. */
export class Circular implements Functions {
  readonly size = 2;
  constructor(readonly start: number, readonly end: number) {}

  derivatives(t: Float64Array, n: number, out: Float64Array): void {
    const speed = this.end - this.start;
    const rate = HALF_PI * speed;
    for (let p = 0; p < n; p++) {
      sinCos(this.start + speed * t[p]!);
      const s = sine, c = cosine;
      out[2 * p] = c;
      out[2 * p + 1] = s;
      out[2 * (n + p)] = rate * -s;
      out[2 * (n + p) + 1] = rate * c;
      out[2 * (2 * n + p)] = rate * rate * -c;
      out[2 * (2 * n + p) + 1] = rate * rate * -s;
    }
  }
}

/** cosh x and sinh x, x running from `start` to `end`. */
export class Hyperbolic implements Functions {
  readonly size = 2;
  constructor(readonly start: number, readonly end: number) {}

  derivatives(t: Float64Array, n: number, out: Float64Array): void {
    const rate = this.end - this.start;
    for (let p = 0; p < n; p++) {
      const x = this.start + rate * t[p]!;
      const c = Math.cosh(x), s = Math.sinh(x);
      for (let k = 0, factor = 1; k < 3; k++, factor *= rate) {
        out[2 * (k * n + p)] = factor * (k === 1 ? s : c);
        out[2 * (k * n + p) + 1] = factor * (k === 1 ? c : s);
      }
    }
  }
}

/** 1, x, ..., x^degree, x running from `start` to `end`. */
export class Powers implements Functions {
  readonly size: number;
  constructor(readonly start: number, readonly end: number, readonly degree: number) {
    this.size = degree + 1;
  }

  derivatives(t: Float64Array, n: number, out: Float64Array): void {
    const x = jet(), all = jets(this.size), m = this.size;
    x[1] = this.end - this.start;
    for (let p = 0; p < n; p++) {
      x[0] = this.start + (this.end - this.start) * t[p]!;
      powers(x, this.degree, all);
      for (let i = 0; i < m; i++) store(all[i]!, out, n, p, m, i);
    }
  }
}

/** The functions of several families one after the other. */
export class Joined implements Functions {
  readonly size: number;
  private scratch = new Float64Array(0);
  constructor(readonly parts: readonly Functions[]) {
    this.size = parts.reduce((sum, part) => sum + part.size, 0);
  }

  derivatives(t: Float64Array, n: number, out: Float64Array): void {
    let first = 0;
    for (const part of this.parts) {
      const m = part.size;
      if (this.scratch.length < 3 * n * m) this.scratch = new Float64Array(3 * n * m);
      part.derivatives(t, n, this.scratch);
      for (let q = 0; q < 3 * n; q++) {
        for (let i = 0; i < m; i++) out[q * this.size + first + i] = this.scratch[q * m + i]!;
      }
      first += m;
    }
  }
}

/** Write the derivatives of a series as function i of m at point p of n. */
export function store(x: Float64Array, out: Float64Array, n: number, p: number, m: number, i: number): void {
  out[p * m + i] = x[0]!;
  out[(n + p) * m + i] = x[1]!;
  out[(2 * n + p) * m + i] = 2 * x[2]!;
}

/** Results of the last `sinCos`, which returns nothing so that it allocates nothing. */
export let sine = 0;
export let cosine = 1;

/** Set `sine` and `cosine` of `turns` right angles, exact at whole ones. */
export function sinCos(turns: number): void {
  const whole = rint(turns);
  const rest = HALF_PI * (turns - whole);
  const s = Math.sin(rest), c = Math.cos(rest);
  const quarter = ((whole % 4) + 4) % 4;
  // Adding 0 turns the -0 of the rotations into 0.
  sine = (quarter === 0 ? s : quarter === 1 ? c : quarter === 2 ? -s : -c) + 0;
  cosine = (quarter === 0 ? c : quarter === 1 ? -s : quarter === 2 ? -c : s) + 0;
}

/** Round half to even, as NumPy does. */
function rint(x: number): number {
  const below = Math.floor(x), rest = x - below;
  if (rest !== 0.5) return Math.round(x);
  return below % 2 === 0 ? below : below + 1;
}
