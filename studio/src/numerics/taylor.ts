/** Arithmetic of Taylor series to second order: x[k] is the k-th derivative divided by k!, in scratch arrays of three. */

export type Jet = Float64Array;

/** Scratch for one series. */
export const jet = (): Jet => new Float64Array(3);

/** Write the series of x y to `out`, which may be x or y. */
export function product(x: Jet, y: Jet, out: Jet): Jet {
  const x0 = x[0]!, x1 = x[1]!, x2 = x[2]!, y0 = y[0]!, y1 = y[1]!, y2 = y[2]!;
  out[0] = x0 * y0;
  out[1] = x0 * y1 + x1 * y0;
  out[2] = x0 * y2 + x1 * y1 + x2 * y0;
  return out;
}

/** Write the series of p x + q y + r to `out`. */
export function combine(p: number, x: Jet, q: number, y: Jet, r: number, out: Jet): Jet {
  out[0] = p * x[0]! + q * y[0]! + r;
  out[1] = p * x[1]! + q * y[1]!;
  out[2] = p * x[2]! + q * y[2]!;
  return out;
}

/** Write the series of x / y to `out`, which may be x or y. */
export function quotient(x: Jet, y: Jet, out: Jet): Jet {
  const y0 = y[0]!, y1 = y[1]!, y2 = y[2]!;
  const r0 = x[0]! / y0, r1 = (x[1]! - r0 * y1) / y0, r2 = (x[2]! - (r0 * y2 + r1 * y1)) / y0;
  out[0] = r0;
  out[1] = r1;
  out[2] = r2;
  return out;
}

/** Write the powers 1, x, ..., x^highest to `out`, one series after the other in each of its arrays. */
export function powers(x: Jet, highest: number, out: readonly Jet[]): void {
  out[0]!.fill(0);
  out[0]![0] = 1;
  for (let k = 1; k <= highest; k++) product(out[k - 1]!, x, out[k]!);
}

/** As many scratch series as the longest basis may need. */
export const jets = (count: number): Jet[] => Array.from({ length: count }, jet);
