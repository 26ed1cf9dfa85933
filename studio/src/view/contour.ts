/** Contour lines on the grid of a surface by marching squares. */

import type { Lines } from "./lines";

/**
 * Add the zero contour of `value` over n × n grid points, at their positions in the scene. Only cells that hold both
 * signs count: `value` is to give 0 where it is zero to rounding, and NaN where there is nothing.
 */
export function zeroContour(value: (p: number) => number, n: number, position: Float32Array, lines: Lines): void {
  const ends = new Float64Array(12);
  for (let i = 0; i < n - 1; i++) {
    for (let k = 0; k < n - 1; k++) {
      const a = i * n + k, corners = [a, a + n, a + n + 1, a + 1] as const;
      const v0 = value(corners[0]), v1 = value(corners[1]), v2 = value(corners[2]), v3 = value(corners[3]);
      if (!(Math.min(v0, v1, v2, v3) < 0 && Math.max(v0, v1, v2, v3) > 0)) continue;
      let found = 0;
      found = cross(position, corners[0], corners[1], v0, v1, ends, found);
      found = cross(position, corners[1], corners[2], v1, v2, ends, found);
      found = cross(position, corners[2], corners[3], v2, v3, ends, found);
      found = cross(position, corners[3], corners[0], v3, v0, ends, found);
      for (let s = 0; s + 1 < found; s += 2) {
        lines.segment(ends[3 * s]!, ends[3 * s + 1]!, ends[3 * s + 2]!, ends[3 * s + 3]!, ends[3 * s + 4]!, ends[3 * s + 5]!);
      }
    }
  }
}

function cross(
  position: Float32Array, p: number, q: number, vp: number, vq: number, ends: Float64Array, found: number,
): number {
  // A corner at 0 counts with the positive side, so that each line passes it once.
  if (vp < 0 === vq < 0 || found > 3) return found;
  const t = vp / (vp - vq);
  for (let x = 0; x < 3; x++) ends[3 * found + x] = position[3 * p + x]! + t * (position[3 * q + x]! - position[3 * p + x]!);
  return found + 1;
}
