/** Pseudo-inverses by singular values, for the small systems of joins. */

export type Matrix = readonly (readonly number[])[];

const SWEEPS = 40;

export const transposed = (a: Matrix): number[][] => (a[0] ?? []).map((_, j) => a.map((row) => row[j]!));
export const times = (a: Matrix, b: Matrix): number[][] => a.map((row) => (b[0] ?? []).map((_, j) => row.reduce((sum, x, k) => sum + x * b[k]![j]!, 0)));
export const size = (a: Matrix): number => Math.hypot(...a.flat());

/** The pseudo-inverse of a matrix; singular values up to `least` count as 0. By rotations of its columns (Hestenes 1958). */
export function pseudoInverse(a: Matrix, least: (largest: number) => number): number[][] {
  if (!a.length || !a[0]!.length) return Array.from({ length: a[0]?.length ?? 0 }, () => []);
  if (a[0]!.length > a.length) return transposed(pseudoInverse(transposed(a), least));
  const u = transposed(a), v = u.map((_, i) => u.map((_, j) => Number(i === j)));
  const dot = (x: readonly number[], y: readonly number[]) => x.reduce((sum, value, k) => sum + value * y[k]!, 0);
  for (let sweep = 0, turned = true; turned && sweep < SWEEPS; sweep++) {
    turned = false;
    for (let p = 0; p < u.length; p++) for (let q = p + 1; q < u.length; q++) {
      const pp = dot(u[p]!, u[p]!), qq = dot(u[q]!, u[q]!), pq = dot(u[p]!, u[q]!);
      if (!(Math.abs(pq) > 1e-16 * Math.sqrt(pp * qq))) continue;
      turned = true;
      const zeta = (qq - pp) / (2 * pq), t = (zeta < 0 ? -1 : 1) / (Math.abs(zeta) + Math.hypot(1, zeta)), c = 1 / Math.hypot(1, t), s = c * t;
      for (const pair of [u, v]) {
        const [x, y] = [pair[p]!, pair[q]!];
        for (let k = 0; k < x.length; k++) [x[k], y[k]] = [c * x[k]! - s * y[k]!, s * x[k]! + c * y[k]!];
      }
    }
  }
  const values = u.map((column) => Math.hypot(...column)), limit = least(Math.max(...values));
  // A⁺ = V Σ⁻¹ Uᵀ, where u holds the columns of U Σ.
  return v[0]!.map((_, i) => a.map((_, r) => values.reduce((sum, value, k) => (value > limit ? sum + (v[k]![i]! * u[k]![r]!) / value ** 2 : sum), 0)));
}
