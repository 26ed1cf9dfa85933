/** Six algebraic invariants of a surface seen as a height field z (Fujita and Ohsaki 2009; Iri et al. 2001). */

import data from "../data.json";

/** At or below this |n_z| the tangent plane counts as vertical: what is left of n_z after rounding means nothing. */
const VERTICAL = data.limits.vertical;

/** Write Γ1, Γ2, Γ3, the second form of (h, h), (h, Jh), (Jh, Jh), h the steepest ascent (z1, z2), to `out`. */
export function slopeForms(a: number, b: number, c: number, z1: number, z2: number, sign: number, out: Float64Array): void {
  out[0] = a * z1 * z1 + 2 * b * z1 * z2 + c * z2 * z2;
  out[1] = sign * ((c - a) * z1 * z2 + b * (z1 * z1 - z2 * z2));
  out[2] = a * z2 * z2 - 2 * b * z1 * z2 + c * z1 * z1;
}

/** β0, β1, β2, γ1, γ2, γ3 in the metric of the horizontal plane; infinite or NaN where it is vertical. */
export function planar(g: Float64Array, slope: number, mean: number, gaussian: number, nz: number, out: Float64Array): void {
  const i = 1 / (Math.abs(nz) > VERTICAL ? nz : 0), i2 = i * i, i3 = i2 * i;
  out[0] = slope * i2;
  out[1] = (g[0]! + 2 * mean * nz * nz) * i3;
  out[2] = gaussian * i2 * i2;
  out[3] = g[0]! * i3 * i2;
  out[4] = g[1]! * i2 * i2;
  out[5] = g[2]! * i3;
}

/** β0, β1, β2, γ1, γ2, γ3 in the metric of the surface; bounded everywhere. */
export function surface(g: Float64Array, slope: number, mean: number, gaussian: number, nz: number, out: Float64Array): void {
  out[0] = slope;
  out[1] = 2 * nz * mean;
  out[2] = nz * nz * gaussian;
  out[3] = nz * g[0]!;
  out[4] = Math.abs(nz) * g[1]!;
  out[5] = nz * g[2]!;
}
